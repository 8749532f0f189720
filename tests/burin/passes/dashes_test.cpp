#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <burin/passes/dashes.hpp>
#include <burin/path/recording.hpp>

#include "support/polygons.hpp"
#include "support/random_paths.hpp"

namespace burin::passes {
namespace {

using test::contours_of;
using test::DrawnPath;

using Contours = std::vector<std::vector<Vec2>>;

constexpr Box2 page{{-1000, -1000}, {1000, 1000}};

Recording dashed(const DrawnPath& path, const std::vector<double>& lengths_mm, const Box2& box = page,
                 std::size_t span = SIZE_MAX) {
  Recorder recorder;
  Checked checked(recorder);
  Dashes dashes(checked, lengths_mm, box);
  EXPECT_EQ(test::draw({path}, dashes, span), Flow::go);
  return recorder.take();
}

DrawnPath line(std::vector<Vec2> points, bool closed = false) {
  return {{.closed = closed}, {std::move(points)}};
}

TEST(Dashes, OnAndOffInTurns) {
  EXPECT_EQ(contours_of(dashed(line({{0, 0}, {10, 0}}), {3, 2})), (Contours{{{0, 0}, {3, 0}}, {{5, 0}, {8, 0}}}));
  // An odd list is read twice: 1 on, 2 off, 3 on, 1 off, 2 on, 3 off.
  EXPECT_EQ(contours_of(dashed(line({{0, 0}, {12, 0}}), {1, 2, 3})),
            (Contours{{{0, 0}, {1, 0}}, {{3, 0}, {6, 0}}, {{7, 0}, {9, 0}}}));
}

TEST(Dashes, GoAroundCornersAndBeginAnewAtEachContour) {
  EXPECT_EQ(contours_of(dashed(line({{0, 0}, {2, 0}, {2, 4}}), {3, 2})),
            (Contours{{{0, 0}, {2, 0}, {2, 1}}, {{2, 3}, {2, 4}}}));
  const DrawnPath two{{}, {{{0, 0}, {4, 0}}, {{0, 9}, {4, 9}}}};
  EXPECT_EQ(contours_of(dashed(two, {3, 2})), (Contours{{{0, 0}, {3, 0}}, {{0, 9}, {3, 9}}}));
}

TEST(Dashes, AClosedLineThatBeginsAndEndsInOneHasNoGapThere) {
  const DrawnPath square = line({{0, 0}, {5, 0}, {5, 5}, {0, 5}}, true);
  // 20 mm are 6 on, 6 off, 6 on and 2 off; or 8 on, 4 off and 8 on, which the first goes on from.
  EXPECT_EQ(contours_of(dashed(square, {6, 6})), (Contours{{{3, 5}, {0, 5}, {0, 2}}, {{0, 0}, {5, 0}, {5, 1}}}));
  const Contours joined = contours_of(dashed(square, {8, 4}));
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0], (std::vector<Vec2>{{3, 5}, {0, 5}, {0, 0}, {5, 0}, {5, 3}}));
  // One dash that is longer than the line leaves it whole.
  const Recording whole = dashed(square, {25, 1});
  EXPECT_TRUE(whole.paths().front().head.closed);
  EXPECT_EQ(contours_of(whole), square.contours);
}

TEST(Dashes, FillsAndDotsPass) {
  const DrawnPath fill{{.paint = Paint::fill_evenodd, .closed = true}, {{{0, 0}, {9, 0}, {9, 9}}}};
  EXPECT_EQ(contours_of(dashed(fill, {1, 1})), fill.contours);
  EXPECT_EQ(contours_of(dashed(line({{1, 2}}), {1, 1})), (Contours{{{1, 2}}}));
  EXPECT_EQ(contours_of(dashed(line({{0, 0}, {5, 0}}), {0, 2})),
            (Contours{{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}, {{4, 0}, {4, 0}}}));
}

TEST(Dashes, WhatIsFarOutOfTheBoxCostsNothingAndKeepsTheirPlace) {
  const Box2 box{{0, -1}, {20, 1}};
  EXPECT_EQ(contours_of(dashed(line({{-1e9, 0}, {1e9, 0}}), {3, 2}, box)).front().front(), (Vec2{0, 0}));
  // 1e9 mm are whole periods: dashes as of a line that begins at 0.
  EXPECT_EQ(contours_of(dashed(line({{-1e9, 0}, {1e9, 0}}), {3, 2}, box)),
            (Contours{{{0, 0}, {3, 0}}, {{5, 0}, {8, 0}}, {{10, 0}, {13, 0}}, {{15, 0}, {18, 0}}}));
  EXPECT_TRUE(dashed(line({{-1e9, 5}, {1e9, 5}}), {3, 2}, box).empty());
  dashed(line({{-1e300, 0}, {1e300, 0}, {0, 1e308}}), {3, 2}, box);  // returns
}

TEST(Dashes, APatternTooFineToShowIsAFullLine) {
  const DrawnPath path = line({{0, 0}, {10, 0}});
  EXPECT_EQ(contours_of(dashed(path, {1e-9, 1e-9})), path.contours);
}

/// The walked length of every point of a dash is one at which the pattern is on, and all such lengths are drawn.
TEST(Dashes, AreWhereThePatternSays) {
  test::Dice dice(5);
  for (int round = 0; round < 300; ++round) {
    std::vector<Vec2> points;
    for (std::size_t i = 2 + dice.below(40); i-- > 0;) points.push_back({dice.between(0, 50), dice.between(0, 50)});
    const double on = dice.between(0.2, 20.0);
    const double off = dice.between(0.2, 20.0);
    double total = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) total += distance(points[i - 1], points[i]);
    const double periods = std::floor(total / (on + off));
    const double expected = periods * on + std::min(on, total - periods * (on + off));
    const Recording drawing = dashed(line(points), {on, off}, page, 1 + dice.below(9));
    ASSERT_NEAR(test::stroke_length(drawing), expected, 1e-9 * total) << round;
    ASSERT_EQ(drawing.paths().size(), static_cast<std::size_t>(periods) + 1) << round;
    for (const std::vector<Vec2>& dash : contours_of(drawing)) {
      double length = 0.0;
      for (std::size_t i = 1; i < dash.size(); ++i) length += distance(dash[i - 1], dash[i]);
      ASSERT_LE(length, on + 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace burin::passes
