#include "quality.hpp"

#include <cstdio>

#include <gtest/gtest.h>

#include "support/random_paths.hpp"

/// 64 samples a pixel against 1024: what the eye could see of the difference.
namespace burin::test {
namespace {

TEST(Quality, OfRandomLinesAtAllWidths) {
  Dice dice(17);
  for (const double width_px : {0.3, 0.5, 1.0, 2.0, 5.0, 20.0}) {
    std::vector<Line> lines;
    for (int k = 0; k < 30; ++k) {
      lines.push_back({{dice.between(5, 195), dice.between(5, 195)}, {dice.between(5, 195), dice.between(5, 195)}});
    }
    const double difference = difference_of_lines(lines, width_px, 200);
    std::printf("random lines of %g px: %.2f of 255\n", width_px, difference);
    EXPECT_LE(difference, most_difference(width_px)) << width_px;
  }
}

TEST(Quality, OfLevelAndUprightLinesAtAllWidths) {
  Dice dice(18);
  for (const double width_px : {0.3, 0.5, 1.0, 2.0, 5.0, 20.0}) {
    std::vector<Line> lines;
    for (int k = 0; k < 20; ++k) {
      const double at = dice.between(5, 195);
      lines.push_back({{at, 10}, {at, 190}});
      lines.push_back({{10, at}, {190, at}});
    }
    const double difference = difference_of_lines(lines, width_px, 200);
    std::printf("level and upright lines of %g px: %.2f of 255\n", width_px, difference);
    EXPECT_LE(difference, most_difference(width_px)) << width_px;
  }
}

TEST(Quality, OfCurvesWithTheirFinestPointsLeftOut) {
  for (const char* motif : {"koch", "dragon", "sierpinski"}) {
    const int levels = std::string(motif) == "dragon" ? 13 : 7;
    const double difference = difference_of_curve(motif, levels, 1.0, 200);
    std::printf("%s, %d levels: %.2f of 255\n", motif, levels, difference);
    EXPECT_LE(difference, most_difference(1.0)) << motif;
  }
}

}  // namespace
}  // namespace burin::test
