#pragma once

#include <cmath>

namespace burin {

/// A point or a vector of space.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Perpendicular to both; a, b and it are right-handed.
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double length_squared(Vec3 a) {
  return dot(a, a);
}
inline double length(Vec3 a) {
  return std::sqrt(dot(a, a));
}
inline double distance(Vec3 a, Vec3 b) {
  return length(b - a);
}
constexpr Vec3 lerp(Vec3 a, Vec3 b, double t) {
  return a + t * (b - a);
}
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// a at length 1; the zero vector stays.
inline Vec3 unit(Vec3 a) {
  const double norm = length(a);
  return norm > 0.0 ? Vec3{a.x / norm, a.y / norm, a.z / norm} : Vec3{};
}

/// Two directions across another one; with it they are right-handed: `right` x `up` points back along it.
struct Across {
  Vec3 right;
  Vec3 up;
};

/// right = unit(d x up) and up = right x unit(d). Where d runs along `up`, or `up` is zero, the axis least aligned with
/// d stands in for it, of equals the first. Pre: d is not zero.
Across across(Vec3 d, Vec3 up);

}  // namespace burin
