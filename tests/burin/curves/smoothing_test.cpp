#include <vector>

#include <gtest/gtest.h>

#include <burin/curves/smoothing.hpp>

namespace burin::curves {
namespace {

std::vector<Vec2> smoothed(std::vector<Vec2> points, Smoothing smoothing, int levels) {
  std::vector<Vec2> spare;
  smooth(points, smoothing, levels, spare);
  return points;
}

TEST(Smoothing, CornersAreCutAtQuarters) {
  const std::vector<Vec2> expected{{0, 0}, {1, 0}, {3, 0}, {4, 1}, {4, 3}, {4, 4}};
  EXPECT_EQ(smoothed({{0, 0}, {4, 0}, {4, 4}}, Smoothing::corners, 1), expected);
}

TEST(Smoothing, FourPointsRunThroughTheGivenPointsAndAlongCubics) {
  const auto cubic = [](double x) { return Vec2{x, x * x * x - 2.0 * x}; };
  const std::vector<Vec2> given{cubic(0), cubic(1), cubic(2), cubic(3), cubic(4), cubic(5)};
  const std::vector<Vec2> refined = smoothed(given, Smoothing::four_point, 1);
  ASSERT_EQ(refined.size(), 11U);
  for (std::size_t i = 0; i < given.size(); ++i) EXPECT_EQ(refined[2 * i], given[i]);
  for (const double x : {1.5, 2.5, 3.5}) EXPECT_EQ(refined[static_cast<std::size_t>(2.0 * x)], cubic(x));
}

TEST(Smoothing, EndsStayAndCountsAreForetold) {
  const std::vector<Vec2> given{{0, 0}, {1, 3}, {2, -1}, {5, 0}};
  for (const Smoothing smoothing : {Smoothing::none, Smoothing::corners, Smoothing::four_point}) {
    for (int levels = 0; levels <= 4; ++levels) {
      for (std::size_t size = 1; size <= given.size(); ++size) {
        const std::vector<Vec2> part(given.begin(), given.begin() + static_cast<std::ptrdiff_t>(size));
        const std::vector<Vec2> refined = smoothed(part, smoothing, levels);
        EXPECT_EQ(refined.front(), part.front());
        EXPECT_EQ(refined.back(), part.back());
        EXPECT_EQ(static_cast<double>(refined.size()), smoothed_count(size, smoothing, levels));
      }
    }
  }
}

}  // namespace
}  // namespace burin::curves
