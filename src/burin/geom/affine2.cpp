#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/geom/affine2.hpp>

namespace burin {

Affine2 rotation_degrees(double degrees) {
  const double c = math::cos_degrees(degrees);
  const double s = math::sin_degrees(degrees);
  return {c, s, -s, c, 0.0, 0.0};
}

bool is_similarity(const Affine2& m) {
  const double slack = 1e-9 * m.scale();
  const auto same = [&](double x, double y) { return std::abs(x - y) <= slack; };
  return m.determinant() != 0.0 && ((same(m.a, m.d) && same(m.b, -m.c)) || (same(m.a, -m.d) && same(m.b, m.c)));
}

Affine2 inverse(const Affine2& m) {
  const double det = m.determinant();
  BURIN_EXPECT(det != 0.0);
  const Affine2 linear{m.d / det, -m.b / det, -m.c / det, m.a / det, 0.0, 0.0};
  const Vec2 moved = linear.linear({m.e, m.f});
  return {linear.a, linear.b, linear.c, linear.d, -moved.x, -moved.y};
}

}  // namespace burin
