#include <gtest/gtest.h>

#include <burin/measure/curve_distance.hpp>

namespace burin::measure {
namespace {

TEST(CurveDistance, OfACurveFromItselfIsNone) {
  const std::vector<Vec2> curve{{0, 0}, {3, 0}, {3, 4}, {8, 4}};
  const Result<CurveDistance> found = curve_distance(curve, curve);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rmse, 0.0, 1e-15);
  EXPECT_NEAR(found->farthest, 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(found->extent, 8.0);
}

TEST(CurveDistance, MorePointsOnTheSameLineChangeNothing) {
  const std::vector<Vec2> coarse{{0, 0}, {10, 0}};
  const std::vector<Vec2> fine{{0, 0}, {1, 0}, {2.5, 0}, {7, 0}, {7, 0}, {10, 0}};
  EXPECT_NEAR(curve_distance(coarse, fine)->farthest, 0.0, 1e-15);
  EXPECT_NEAR(curve_distance(fine, coarse)->farthest, 0.0, 1e-14);
}

TEST(CurveDistance, IsRootMeanSquareOverThePointsOfTheFirst) {
  // Shares 0, 1/2 and 1: the distances are 1, 2 and 3.
  const Result<CurveDistance> found = curve_distance({{0, 0}, {5, 0}, {10, 0}}, {{0, 1}, {5, 2}, {10, 3}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rmse, std::sqrt(14.0 / 3.0), 1e-14);
  EXPECT_NEAR(found->farthest, 3.0, 1e-14);
}

TEST(CurveDistance, NeedsLength) {
  EXPECT_FALSE(curve_distance({{1, 1}}, {{0, 0}, {1, 0}}));
  EXPECT_FALSE(curve_distance({{0, 0}, {1, 0}}, {{1, 1}, {1, 1}}));
  EXPECT_FALSE(curve_distance({}, {}));
}

}  // namespace
}  // namespace burin::measure
