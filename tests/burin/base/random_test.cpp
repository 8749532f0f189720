#include <array>
#include <set>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>

namespace burin {
namespace {

// Reference: curves A.7.
static_assert(mix(0) == 0xe220a8397b1dcdafU);
static_assert(random_bits(1, 2, 3) == 0xd0734750fde362b3U);
static_assert(uniform(42, 1, 2, 3) == 0.24892237592789002);
static_assert(uniform_symmetric(42, 1, 2, 3) == -0.5021552481442197);

TEST(Random, SignsOfTheReference) {
  constexpr std::array<int, 16> signs{1, -1, 1, 1, -1, -1, -1, 1, 1, -1, -1, -1, 1, 1, -1, -1};
  for (std::size_t i = 0; i < signs.size(); ++i) {
    EXPECT_EQ(random_bits(12345, 1, i + 1) >> 63U != 0 ? -1 : 1, signs[i]) << i + 1;
  }
}

TEST(Random, IntervalsAreHalfOpenAndOpen) {
  EXPECT_EQ(unit_interval(0), 0.0);
  EXPECT_EQ(unit_interval(~0ULL), 1.0 - 0x1p-53);
  EXPECT_EQ(symmetric_interval(0), -1.0 + 0x1p-52);
  EXPECT_EQ(symmetric_interval(~0ULL), 1.0 - 0x1p-52);
}

TEST(Random, KeysOfAnyWidthWrapAlike) {
  EXPECT_EQ(random_bits(5, -1), random_bits(5, ~0ULL));
  EXPECT_EQ(random_bits(5, 7), random_bits(5, static_cast<unsigned char>(7)));
}

TEST(Random, OrderAndNumberOfKeysMatter) {
  const std::set<std::uint64_t> different{random_bits(1),       random_bits(1, 0),    random_bits(1, 0, 0),
                                          random_bits(1, 2, 3), random_bits(1, 3, 2), random_bits(2, 1, 3)};
  EXPECT_EQ(different.size(), 6U);
}

TEST(Random, MeanAndSpreadOfTheUniformDraw) {
  double sum = 0.0;
  double squares = 0.0;
  constexpr int draws = 100000;
  for (int i = 0; i < draws; ++i) {
    const double x = uniform_symmetric(99, i);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / draws, 0.0, 0.01);
  EXPECT_NEAR(squares / draws, 1.0 / 3.0, 0.01);
}

}  // namespace
}  // namespace burin
