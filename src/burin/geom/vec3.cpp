#include <burin/geom/vec3.hpp>

namespace burin {

namespace {

/// The axis least aligned with d.
Vec3 axis_across(Vec3 d) {
  const double x = std::abs(d.x);
  const double y = std::abs(d.y);
  const double z = std::abs(d.z);
  if (x <= y && x <= z) return {1.0, 0.0, 0.0};
  return y <= z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
}

}  // namespace

Across across(Vec3 d, Vec3 up) {
  // Below this the cross product is rounding.
  constexpr double rounding = 1e-12;
  const Vec3 along = unit(d);
  Vec3 right = cross(along, unit(up));
  if (!(length(right) > rounding)) right = cross(along, axis_across(d));
  right = unit(right);
  return {right, cross(right, along)};
}

}  // namespace burin
