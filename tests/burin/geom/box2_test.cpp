#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/geom/box2.hpp>

namespace burin {
namespace {

constexpr Box2 unit{{0.0, 0.0}, {1.0, 1.0}};

TEST(Box2, TheDefaultIsEmptyAndGrowsFromNothing) {
  Box2 box;
  EXPECT_TRUE(box.empty());
  EXPECT_FALSE(box.contains({0.0, 0.0}));
  box.add(Box2{});
  EXPECT_TRUE(box.empty());
  box.add(Vec2{2.0, -1.0});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box, (Box2{{2.0, -1.0}, {2.0, -1.0}}));
  box.add(unit);
  EXPECT_EQ(box, (Box2{{0.0, -1.0}, {2.0, 1.0}}));
  EXPECT_EQ(box.width(), 2.0);
  EXPECT_EQ(box.height(), 2.0);
  EXPECT_EQ(box.center(), (Vec2{1.0, 0.0}));
}

TEST(Box2, BordersBelongToIt) {
  EXPECT_TRUE(unit.contains({0.0, 1.0}));
  EXPECT_FALSE(unit.contains({0.0, 1.0000001}));
  EXPECT_TRUE(unit.touches_disc({2.0, 0.5}, 1.0));
  EXPECT_FALSE(unit.touches_disc({2.0, 0.5}, 0.999));
  EXPECT_TRUE(unit.contains_disc({0.5, 0.5}, 0.5));
  EXPECT_FALSE(unit.contains_disc({0.5, 0.5}, 0.501));
  EXPECT_TRUE(Box2::everything().contains_disc({1e300, -1e300}, 1e300));
  EXPECT_EQ(unit.grown(0.5), (Box2{{-0.5, -0.5}, {1.5, 1.5}}));
  EXPECT_TRUE(unit.grown(-0.6).empty());
}

TEST(Box2, TouchesDiscNeverDeniesACommonPoint) {
  for (int i = 0; i < 2000; ++i) {
    const Vec2 center{2.0 * uniform_symmetric(1, i), 2.0 * uniform_symmetric(2, i)};
    const Vec2 inside{uniform(3, i), uniform(4, i)};
    EXPECT_TRUE(unit.touches_disc(center, distance(center, inside) * (1.0 + 1e-15)));
  }
}

TEST(Box2, ImageBoxIsTheSmallestAroundTheImage) {
  EXPECT_TRUE(image_box(rotation_degrees(30.0), Box2{}).empty());
  EXPECT_EQ(image_box(scaling(2.0, -1.0), unit), (Box2{{0.0, -1.0}, {2.0, 0.0}}));
  EXPECT_EQ(image_box(rotation_degrees(90.0), unit), (Box2{{-1.0, 0.0}, {0.0, 1.0}}));
  const Box2 tilted = image_box(rotation_degrees(45.0), unit);
  EXPECT_DOUBLE_EQ(tilted.width(), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(tilted.height(), std::sqrt(2.0));
  for (int i = 0; i < 1000; ++i) {
    const Vec2 inside{uniform(5, i), uniform(6, i)};
    const Affine2 map = translation({uniform(7, i), uniform(8, i)}) * rotation_degrees(360.0 * uniform(9, i));
    EXPECT_TRUE(image_box(map, unit).grown(1e-15).contains(map(inside)));
  }
}

}  // namespace
}  // namespace burin
