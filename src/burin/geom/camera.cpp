#include <algorithm>

#include <burin/geom/camera.hpp>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is up in the picture. Along the line of sight `up` says nothing: then y is, and along y z.
Vec3 up_of(const CameraPose& pose, Vec3 forward) {
  constexpr double rounding = 1e-12;
  for (const Vec3 up : {pose.up, Vec3{0.0, 1.0, 0.0}}) {
    if (length(cross(forward, unit(up))) > rounding) return up;
  }
  return {0.0, 0.0, 1.0};
}

}  // namespace

Camera::Camera(const CameraPose& pose)
    : pose_(pose), forward_(unit(pose.target - pose.eye)), distance_(burin::distance(pose.eye, pose.target)) {
  const Across axes = across(forward_, up_of(pose, forward_));
  right_ = axes.right;
  up_ = axes.up;
  factor_ = is_perspective() ? pose.scale * distance_ : pose.scale;
}

Vec2 Camera::operator()(Vec3 p) const {
  const Vec3 seen = p - (is_perspective() ? pose_.eye : pose_.target);
  const double factor = is_perspective() ? factor_ / dot(forward_, seen) : factor_;
  return {factor * dot(right_, seen), factor * dot(up_, seen)};
}

double Camera::picture_radius(Vec3 p, double radius) const {
  if (!is_perspective()) return factor_ * radius;
  // The picture moves by (z v - s w) / (z (z + w)) when the point (s, z) does by (v, w): at most |(s, z)| radius over
  // the product of both depths.
  const double z = depth(p);
  if (!(z > radius)) return infinity;
  return factor_ * radius * length(p - pose_.eye) / (z * (z - radius));
}

double Camera::picture_error(Vec3 a, Vec3 b, double radius, double error) const {
  if (!is_perspective()) return factor_ * error;
  const double nearest = std::min(depth(a), depth(b)) - radius;
  if (!(nearest > 0.0)) return infinity;
  const double farthest = std::max(burin::distance(a, pose_.eye), burin::distance(b, pose_.eye)) + radius;
  return factor_ * error * farthest / (nearest * nearest);
}

}  // namespace burin
