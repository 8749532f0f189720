#include <cstdio>

#include <gtest/gtest.h>

#include "quality.hpp"

/// The curves of the benchmark at their full size.
namespace burin::test {
namespace {

void expect_quality(const char* motif, int levels) {
  for (const double width_px : {0.3, 1.0, 1.2, 3.0}) {
    const double difference = difference_of_curve(motif, levels, width_px, 2000);
    std::printf("%s, %d levels, %g px: %.2f of 255\n", motif, levels, width_px, difference);
    EXPECT_LE(difference, most_difference(width_px)) << motif << ' ' << width_px;
  }
}

TEST(FullQuality, OfKochOfOrderTen) {
  expect_quality("koch", 10);
}
TEST(FullQuality, OfAMillionSegmentsOfDragon) {
  expect_quality("dragon", 20);
}
TEST(FullQuality, OfTheArrowheadOfOrderTwelve) {
  expect_quality("sierpinski", 12);
}

}  // namespace
}  // namespace burin::test
