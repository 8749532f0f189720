#pragma once

#include <burin/geom/vec2.hpp>

namespace burin {

/// An affine map of the plane: p -> (a x + c y + e, b x + d y + f), SVG's matrix(a b c d e f). Named after both spaces,
/// `page_from_model` maps model points to page points; `page_from_model * model_from_unit` chains from right to left.
struct Affine2 {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  friend constexpr bool operator==(const Affine2&, const Affine2&) = default;

  constexpr Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// The map of directions: no translation.
  constexpr Vec2 linear(Vec2 v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  constexpr double determinant() const { return a * d - b * c; }
  /// How much lengths grow, for a similarity; for other maps the geometric mean of both directions.
  double scale() const { return std::sqrt(std::abs(determinant())); }

  friend constexpr Affine2 operator*(const Affine2& m, const Affine2& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
  }
};

constexpr Affine2 translation(Vec2 by) {
  return {1.0, 0.0, 0.0, 1.0, by.x, by.y};
}
constexpr Affine2 scaling(double x, double y) {
  return {x, 0.0, 0.0, y, 0.0, 0.0};
}
/// Counter-clockwise (y up) about the origin; exact at multiples of 90 degrees.
Affine2 rotation_degrees(double degrees);
/// Whether m turns, mirrors, scales and moves, but bends nothing out of shape.
bool is_similarity(const Affine2& m);
/// Pre: m is invertible.
Affine2 inverse(const Affine2& m);

}  // namespace burin
