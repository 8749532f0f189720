#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/primitives/spacing.hpp>

namespace burin::primitives {
namespace {

TEST(Spacing, AgreesWithComparingEveryPair) {
  for (const double distance_mm : {0.001, 0.37, 3.0, 40.0}) {
    Spacing spacing(distance_mm);
    std::vector<Vec2> taken;
    for (std::uint64_t i = 0; i < 3000; ++i) {
      const Vec2 p{100.0 * uniform_symmetric(5, i, 0), 0.3 * std::max(distance_mm, 1.0) * uniform_symmetric(5, i, 1)};
      const bool free =
          std::ranges::none_of(taken, [&](Vec2 q) { return distance(p, q) < distance_mm * (1.0 - 1e-9); });
      ASSERT_EQ(spacing.take(p), free) << i;
      if (free) taken.push_back(p);
    }
    EXPECT_GT(taken.size(), 2U);
  }
}

TEST(Spacing, ALatticeOfJustThatWidthIsTakenWhole) {
  Spacing spacing(0.3);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) EXPECT_TRUE(spacing.take({0.3 * x - 7.7, 0.1 * (3 * y)}));
  }
  EXPECT_FALSE(spacing.take({0.3 * 7 - 7.7 + 1e-7, 0.3}));
}

TEST(Spacing, TakesNothingThatIsNoPlace) {
  Spacing spacing(1e-3);
  EXPECT_FALSE(spacing.take({std::numeric_limits<double>::quiet_NaN(), 0}));
  EXPECT_FALSE(spacing.take({0, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(spacing.take({1e300, 0}));
  EXPECT_TRUE(spacing.take({1e6, -1e6}));
}

TEST(Spacing, RemembersFourMillionsAndSaysSo) {
  Spacing spacing(0.5);
  for (std::size_t i = 0; i < Spacing::most_points; ++i) {
    ASSERT_TRUE(spacing.take({static_cast<double>(i % 2048), static_cast<double>(i / 2048)}));
  }
  EXPECT_FALSE(spacing.full());
  EXPECT_FALSE(spacing.take({0.25, 0}));
  EXPECT_FALSE(spacing.full());
  EXPECT_FALSE(spacing.take({-3, -3}));
  EXPECT_TRUE(spacing.full());
}

}  // namespace
}  // namespace burin::primitives
