#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/geom/affine2.hpp>

namespace burin {
namespace {

constexpr double tolerance = 1e-12;

Affine2 random_map(int i) {
  const auto draw = [i](int key) { return 3.0 * uniform_symmetric(11, i, key); };
  return {draw(0), draw(1), draw(2), draw(3), draw(4), draw(5)};
}

void expect_near(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Affine2, ProductAppliesTheRightFactorFirst) {
  const Affine2 page_from_model = translation({10.0, 0.0}) * scaling(2.0, -3.0);
  EXPECT_EQ(page_from_model(Vec2{1.0, 1.0}), (Vec2{12.0, -3.0}));
  EXPECT_EQ(page_from_model.linear({1.0, 1.0}), (Vec2{2.0, -3.0}));
  EXPECT_EQ((scaling(2.0, -3.0) * translation({10.0, 0.0}))(Vec2{1.0, 1.0}), (Vec2{22.0, -3.0}));
  for (int i = 0; i < 100; ++i) {
    const Affine2 m = random_map(i);
    const Affine2 n = random_map(i + 1000);
    const Vec2 p{uniform(1, i), uniform(2, i)};
    expect_near((m * n)(p), m(n(p)));
    EXPECT_NEAR((m * n).determinant(), m.determinant() * n.determinant(), 1e-11);
  }
}

TEST(Affine2, InverseUndoesFromBothSides) {
  for (int i = 0; i < 1000; ++i) {
    const Affine2 m = random_map(i);
    if (std::abs(m.determinant()) < 0.1) continue;
    const Vec2 p{uniform(3, i), uniform(4, i)};
    expect_near(inverse(m)(m(p)), p);
    expect_near(m(inverse(m)(p)), p);
  }
  EXPECT_EQ(inverse(Affine2{}), Affine2{});
  EXPECT_EQ(inverse(scaling(4.0, 0.5)), scaling(0.25, 2.0));
}

TEST(Affine2DeathTest, SingularMapsHaveNoInverse) {
  EXPECT_DEATH(inverse(scaling(1.0, 0.0)), "contract broken");
}

TEST(Affine2, QuarterTurnsAreExact) {
  for (int turn = -3; turn <= 3; ++turn) {
    EXPECT_EQ(rotation_degrees(360.0 * turn)(Vec2{3.0, 4.0}), (Vec2{3.0, 4.0}));
    EXPECT_EQ(rotation_degrees(360.0 * turn + 90.0)(Vec2{3.0, 4.0}), (Vec2{-4.0, 3.0}));
    EXPECT_EQ(rotation_degrees(360.0 * turn + 180.0)(Vec2{3.0, 4.0}), (Vec2{-3.0, -4.0}));
    EXPECT_EQ(rotation_degrees(360.0 * turn + 270.0)(Vec2{3.0, 4.0}), (Vec2{4.0, -3.0}));
  }
}

TEST(Affine2, RotationsAddUpAndKeepLengths) {
  for (int i = 0; i < 200; ++i) {
    const double a = 1000.0 * uniform_symmetric(5, i);
    const double b = 1000.0 * uniform_symmetric(6, i);
    const Vec2 p{uniform(7, i), uniform(8, i)};
    expect_near((rotation_degrees(a) * rotation_degrees(b))(p), rotation_degrees(a + b)(p));
    EXPECT_NEAR(length(rotation_degrees(a)(p)), length(p), tolerance);
  }
}

TEST(Affine2, ScaleIsTheGeometricMean) {
  EXPECT_DOUBLE_EQ(scaling(2.0, 8.0).scale(), 4.0);
  EXPECT_DOUBLE_EQ(scaling(-3.0, 3.0).scale(), 3.0);
  EXPECT_DOUBLE_EQ((rotation_degrees(33.0) * scaling(5.0, 5.0)).scale(), 5.0);
}

}  // namespace
}  // namespace burin
