#include <cmath>
#include <optional>

#include <burin/curves/two_point_3d/normals.hpp>

namespace burin::curves::two_point_3d {

namespace {

/// What is below this share is rounding.
constexpr double rounding = 1e-9;

/// Away from the neighbour that w leads to from the edge's end, across the edge d; nothing where w runs along it.
std::optional<Vec3> away_from(Vec3 w, Vec3 d) {
  const Vec3 off = w - (dot(w, d) / length_squared(d)) * d;
  const double norm = length(off);
  if (!(norm > rounding * length(w))) return std::nullopt;
  return Vec3{-off.x / norm, -off.y / norm, -off.z / norm};
}

}  // namespace

Normals normals_of(const Vec3* before, Vec3 a, Vec3 b, const Vec3* after, Orient orient, Vec3 up) {
  const Vec3 d = b - a;
  if (!(length_squared(d) > 0.0)) return {};
  std::optional<Vec3> left = before != nullptr ? away_from(*before - a, d) : std::nullopt;
  std::optional<Vec3> right = after != nullptr ? away_from(*after - b, d) : std::nullopt;
  if (orient == Orient::reference || (!left && !right)) {
    const Vec3 reference = across(d, up).right;
    if (!left && !right) return {reference, reference};
    for (std::optional<Vec3>* normal : {&left, &right}) {
      if (*normal && dot(**normal, reference) < 0.0) **normal = -**normal;
    }
  }
  return {left ? *left : *right, right ? *right : *left};
}

Vec3 blend(const Normals& normals, double theta, bool normalize) {
  const Vec3 between = (1.0 - theta) * normals.left + theta * normals.right;
  if (!normalize) return between;
  const double norm = length(between);
  if (!(norm > rounding)) return theta >= 0.5 ? normals.right : normals.left;
  return {between.x / norm, between.y / norm, between.z / norm};
}

}  // namespace burin::curves::two_point_3d
