#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/curves/line_art/neighbours.hpp>

#include "line_art_support.hpp"

/// What composition promises: shapes, spacing, tone, budget. Each is held against a count or a search of its own.
namespace burin::curves {
namespace {

using testing::drawn_lines;
using testing::DrawnLine;
using testing::length_of;

/// Random polylines over the unit square with this composition.
std::vector<DrawnLine> composed(const std::string& composition, int lines = 400) {
  return drawn_lines("line-art",
                     fmt::format(R"({{"lines": {}, "start": [0, 0, 1, 1], "compose": {{{}}}}})", lines, composition),
                     {.seed = 4});
}

bool come_near(const DrawnLine& one, const DrawnLine& other, double limit) {
  for (std::size_t i = 1; i < one.points.size(); ++i) {
    for (std::size_t k = 1; k < other.points.size(); ++k) {
      if (line_art::nearer_than({one.points[i - 1], one.points[i]}, {other.points[k - 1], other.points[k]}, limit)) {
        return true;
      }
    }
  }
  return false;
}

bool is_prefix(const DrawnLine& stroke, const DrawnLine& of) {
  return stroke.points.size() <= of.points.size() &&
         std::equal(stroke.points.begin(), stroke.points.end(), of.points.begin());
}

TEST(LineArtComposition, StrokesKeepTheirDistanceAndEarlierOnesWin) {
  constexpr double spacing = 0.03;
  const std::vector<DrawnLine> strokes = composed(R"("spacing": 0.03)");
  ASSERT_GT(strokes.size(), 30U);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(come_near(strokes[i], strokes[k], spacing)) << i << ' ' << k;
  }
  EXPECT_EQ(strokes.front(), composed("").front());  // nothing is in the way of the first
  const std::vector<DrawnLine> more = composed(R"("spacing": 0.03)", 600);
  ASSERT_GE(more.size(), strokes.size());
  EXPECT_TRUE(std::equal(strokes.begin(), strokes.end(), more.begin()));
}

TEST(LineArtComposition, WhatMeetsAStrokeEndsIsDroppedOrGoesOn) {
  const std::vector<DrawnLine> free = composed("");
  const auto some_line = [&](const DrawnLine& stroke, const auto& fits) {
    return std::any_of(free.begin(), free.end(), [&](const DrawnLine& line) { return fits(stroke, line); });
  };
  for (const DrawnLine& stroke : composed(R"("spacing": 0.02, "meet": "end")")) {
    EXPECT_TRUE(some_line(stroke, is_prefix));
  }
  for (const DrawnLine& stroke : composed(R"("spacing": 0.02, "meet": "drop")")) {
    EXPECT_TRUE(some_line(stroke, [](const DrawnLine& a, const DrawnLine& b) { return a == b; }));
  }
  EXPECT_GT(composed(R"("spacing": 0.02, "meet": "resume")").size(), composed(R"("spacing": 0.02)").size());
}

TEST(LineArtComposition, ShapesAreEnteredByNoStroke) {
  for (const char* meet : {"end", "drop", "resume"}) {
    const std::vector<DrawnLine> strokes = composed(fmt::format(
        R"("meet": "{}", "inside": {{"disc": [0.5, 0.5, 0.5]}}, "keep_out": [[0.2, 0.2, 0.4, 0.7], {{"disc": [0.7, 0.6, 0.15]}}])",
        meet));
    ASSERT_GT(strokes.size(), 20U) << meet;
    double nearest_to_border = 1.0;
    for (const DrawnLine& stroke : strokes) {
      for (std::size_t i = 1; i < stroke.points.size(); ++i) {
        for (int step = 0; step <= 20; ++step) {
          const Vec2 p = lerp(stroke.points[i - 1], stroke.points[i], step / 20.0);
          const double in_disc = distance(p, {0.5, 0.5});
          EXPECT_LE(in_disc, 0.5 + 1e-9);
          EXPECT_GE(distance(p, {0.7, 0.6}), 0.15 - 1e-9);
          EXPECT_FALSE(p.x > 0.2 + 1e-9 && p.x < 0.4 - 1e-9 && p.y > 0.2 + 1e-9 && p.y < 0.7 - 1e-9);
          nearest_to_border = std::min(nearest_to_border, 0.5 - in_disc);
        }
      }
    }
    // Strokes are cut on the border, unless they are dropped.
    EXPECT_EQ(nearest_to_border < 1e-9, std::string(meet) != "drop");
  }
}

TEST(LineArtComposition, ResumedPartsAreAllOfWhatLiesOutside) {
  // One straight line over a disc of radius 1 and a square: what is left is known.
  const std::vector<DrawnLine> strokes = drawn_lines("line-art", R"({"lines": 1, "segments": 7, "length": 2, "turn": 0,
      "heading": 0, "compose": {"meet": "resume", "keep_out": [{"disc": [4, 0, 1]}, [8.5, -1, 9.5, 1]]}})");
  ASSERT_EQ(strokes.size(), 3U);
  const double ends[3][2] = {{0.0, 3.0}, {5.0, 8.5}, {9.5, 14.0}};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(strokes[s].points.front().x, ends[s][0], 1e-12);
    EXPECT_NEAR(strokes[s].points.back().x, ends[s][1], 1e-12);
  }
}

TEST(LineArtComposition, DensityIsTheChanceOfAPolyline) {
  int left = 0;
  int right = 0;
  for (const DrawnLine& line : composed(R"("density": "x < 0.5 ? 0.2 : 0.7")", 20'000)) {
    (line.points.front().x < 0.5 ? left : right) += 1;
  }
  EXPECT_NEAR(left, 2000, 180);  // four standard deviations
  EXPECT_NEAR(right, 7000, 290);
  EXPECT_TRUE(composed(R"("density": "sqrt(-1) + 1")").empty());
}

TEST(LineArtComposition, KindsAreLevelsByChanceDirectionOrPlace) {
  int second = 0;
  for (const DrawnLine& line : composed(R"("kind": "rand < 0.25")", 8000)) second += line.level;
  EXPECT_NEAR(second, 2000, 160);
  for (const DrawnLine& line : composed(R"("kind": "x > 0.5 ? 7 : -3")")) {
    EXPECT_EQ(line.level, line.points.front().x > 0.5 ? 7 : 0);
  }
  for (const DrawnLine& line : composed(R"("kind": "abs(angle) < 90")")) {
    EXPECT_EQ(line.level, line.points.back().x > line.points.front().x ? 1 : 0);
  }
}

TEST(LineArtComposition, ToneCoversTheShareThatIsAsked) {
  constexpr double pen = 0.008;
  for (const double tone : {0.1, 0.2, 0.3, 0.45, 0.6}) {
    const std::vector<DrawnLine> strokes =
        drawn_lines("line-art", fmt::format(R"({{"lines": 30000, "start": [0, 0, 1, 1], "length": 0.02, "turn": 20,
            "compose": {{"tone": {}, "pen_width": {}, "shortest": 0.02}}}})",
                                            tone, pen));
    line_art::Neighbours ink(0.5 * pen);
    for (const DrawnLine& stroke : strokes) {
      for (std::size_t i = 1; i < stroke.points.size(); ++i) ink.add(stroke.points[i - 1], stroke.points[i]);
    }
    constexpr int samples = 100'000;
    int inked = 0;
    for (int i = 0; i < samples; ++i) {
      const Vec2 p{0.1 + 0.8 * uniform(1, i), 0.1 + 0.8 * uniform(2, i)};
      inked += ink.is_free(p, p) ? 0 : 1;
    }
    EXPECT_NEAR(static_cast<double>(inked) / samples, tone, 0.1 * tone);
  }
}

TEST(LineArtComposition, ToneGoesWithThePlace) {
  double light = 0.0;
  double dark = 0.0;
  for (const DrawnLine& stroke : composed(R"("tone": "x < 0.5 ? 0 : 0.2", "pen_width": 0.01)", 5000)) {
    // Cells of 12 pens have one tone, that of their middle.
    (stroke.points.front().x < 0.44 ? light : dark) += length_of(stroke.points);
  }
  EXPECT_EQ(light, 0.0);
  EXPECT_GT(dark, 5.0);
}

TEST(LineArtComposition, BudgetAndShortestAreKept) {
  double total = 0.0;
  const std::vector<DrawnLine> strokes = composed(R"("budget": 25)");
  for (const DrawnLine& stroke : strokes) total += length_of(stroke.points);
  EXPECT_GE(total, 25.0);
  EXPECT_LT(total - length_of(strokes.back().points), 25.0);
  for (const DrawnLine& stroke : composed(R"("spacing": 0.02, "shortest": 0.3)")) {
    EXPECT_GE(length_of(stroke.points), 0.3);
  }
  EXPECT_TRUE(composed(R"("budget": 0)").empty());
}

TEST(LineArtComposition, PolylinesAreSmoothedBetweenTheirEnds) {
  const std::vector<DrawnLine> plain = composed("");
  const std::vector<DrawnLine> smooth = composed(R"("smooth": "four-point", "smooth_levels": 2)");
  ASSERT_EQ(plain.size(), smooth.size());
  for (std::size_t j = 0; j < plain.size(); ++j) {
    ASSERT_EQ(smooth[j].points.size(), 4 * (plain[j].points.size() - 1) + 1);
    for (std::size_t i = 0; i < plain[j].points.size(); ++i) EXPECT_EQ(smooth[j].points[4 * i], plain[j].points[i]);
  }
}

}  // namespace
}  // namespace burin::curves
