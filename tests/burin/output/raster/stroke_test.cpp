#include <algorithm>

#include <gtest/gtest.h>

#include <burin/output/raster/dashes.hpp>
#include <burin/output/raster/path_stroker.hpp>

#include "sample_reference.hpp"
#include "support/random_paths.hpp"

namespace burin::test {
namespace {

using namespace output::raster;

constexpr PixelBox part{0, 0, 32, 24};
constexpr Box2 page{{0.0, 0.0}, {32.0, 24.0}};

Vec2 in_pixels(Point p) {
  return {p.x / 1024.0, p.y / 1024.0};
}

void draw(Ink& ink, const ReferenceStroke& stroke, const Box2& on = page) {
  PathStroker stroker(ink, on);
  stroker.set_style({stroke.half_width / 512.0, stroke.cap, stroke.join, stroke.miter_limit});
  stroker.begin(stroke.closed);
  for (const Point p : stroke.points) stroker.to(in_pixels(p));
  stroker.end();
}

std::vector<Samples> drawn(const ReferenceStroke& stroke, const Kernel& kernel = best_kernel()) {
  Ink ink(part, kernel);
  draw(ink, stroke);
  return samples_of(ink, part);
}

Point random_point(Dice& dice, double around) {
  const auto units = [&](double low, double high) {
    return static_cast<std::int32_t>(1024.0 * dice.between(low, high));
  };
  return {units(-around, 32.0 + around), units(-around, 24.0 + around)};
}

/// Long and tiny steps, level and upright ones, steps back and points that repeat.
ReferenceStroke random_stroke(Dice& dice) {
  ReferenceStroke stroke;
  stroke.closed = dice.below(3) == 0;
  constexpr double widths[] = {0.02, 0.3, 1.0, 2.7, 9.0, 50.0};
  stroke.half_width = 512.0 * widths[dice.below(6)] * dice.between(0.5, 1.0);
  constexpr double steps[] = {0.2, 1.0, 6.0, 30.0};
  const double step = steps[dice.below(4)] * 1024.0;
  stroke.points.push_back(random_point(dice, 3.0));
  const std::size_t count = 1 + dice.below(10);
  while (stroke.points.size() < count) {
    const Point last = stroke.points.back();
    Point next{last.x + static_cast<std::int32_t>(dice.between(-step, step)),
               last.y + static_cast<std::int32_t>(dice.between(-step, step))};
    const std::size_t kind = dice.below(10);
    if (kind == 0) next.x = last.x;
    if (kind == 1) next.y = last.y;
    if (kind == 2) next = last;
    if (kind == 3 && stroke.points.size() > 1) next = stroke.points[stroke.points.size() - 2];
    stroke.points.push_back(next);
  }
  return stroke;
}

using CapJoinAndSeed = std::tuple<Cap, Join, std::uint64_t>;

class Strokes : public testing::TestWithParam<CapJoinAndSeed> {};

TEST_P(Strokes, HaveExactlyTheSamplesOfTheirDefinition) {
  const auto& [cap, join, seed] = GetParam();
  Dice dice(20 + static_cast<std::uint64_t>(cap) * 3 + static_cast<std::uint64_t>(join) + 100 * seed);
  for (int turn = 0; turn < 5; ++turn) {
    ReferenceStroke stroke = random_stroke(dice);
    stroke.cap = cap;
    stroke.join = join;
    stroke.miter_limit = dice.between(1.0, 8.0);
    const auto reference =
        reference_samples(part, [line = stroke.without_repeats()](Point p) { return line.covers(p); });
    EXPECT_EQ(differing_samples(drawn(stroke, best_kernel()), reference), 0) << "best, turn " << turn;
    EXPECT_EQ(differing_samples(drawn(stroke, portable_kernel()), reference), 0) << "portable, turn " << turn;
  }
}

INSTANTIATE_TEST_SUITE_P(CapsAndJoins, Strokes,
                         testing::Combine(testing::Values(Cap::round, Cap::butt, Cap::square),
                                          testing::Values(Join::round, Join::miter, Join::bevel),
                                          testing::Range<std::uint64_t>(0, 5)));

TEST(Stroke, OfLevelAndUprightLinesIsExactAtEveryWidth) {
  for (const double half_width : {8.0, 100.0, 512.0, 1000.0, 5000.0}) {
    ReferenceStroke stroke;
    stroke.half_width = half_width;
    stroke.cap = Cap::butt;
    stroke.points = {{5 * 1024, 4 * 1024}, {20 * 1024, 4 * 1024}, {20 * 1024, 19 * 1024}};
    const auto reference =
        reference_samples(part, [line = stroke.without_repeats()](Point p) { return line.covers(p); });
    EXPECT_EQ(differing_samples(drawn(stroke), reference), 0) << half_width;
  }
}

TEST(Stroke, OfSlopesAlongTheRowsOfSamplesIsExact) {
  // Where the bounds in a row of samples cannot be computed, since row and edge are parallel.
  for (const Point step : {Point{8 * 1024, -1024}, Point{1024, 8 * 1024}, Point{16384, -2047}, Point{2047, 16384}}) {
    ReferenceStroke stroke;
    stroke.half_width = 700.0;
    stroke.points = {{10000, 8000}, {10000 + step.x, 8000 + step.y}};
    const auto reference =
        reference_samples(part, [line = stroke.without_repeats()](Point p) { return line.covers(p); });
    EXPECT_EQ(differing_samples(drawn(stroke), reference), 0) << step.x << ' ' << step.y;
  }
}

TEST(Stroke, DoesNotDependOnOrderOrRepetition) {
  Dice dice(7);
  std::vector<ReferenceStroke> strokes;
  for (int k = 0; k < 20; ++k) strokes.push_back(random_stroke(dice));
  Ink forward(part);
  for (const ReferenceStroke& stroke : strokes) draw(forward, stroke);
  Ink backward(part);
  for (int twice = 0; twice < 2; ++twice) {
    std::for_each(strokes.rbegin(), strokes.rend(), [&](const ReferenceStroke& stroke) { draw(backward, stroke); });
  }
  EXPECT_EQ(samples_of(forward, part), samples_of(backward, part));
}

TEST(Stroke, InPartsIsTheSameAsAtOnce) {
  constexpr PixelBox whole{0, 0, 96, 64};
  constexpr Box2 large_page{{0.0, 0.0}, {96.0, 64.0}};
  Dice dice(8);
  std::vector<ReferenceStroke> strokes;
  for (int k = 0; k < 30; ++k) {
    strokes.push_back(random_stroke(dice));
    for (Point& p : strokes.back().points) p = {p.x * 3, p.y * 3};
  }
  Ink all(whole);
  for (const ReferenceStroke& stroke : strokes) draw(all, stroke, large_page);
  for (const PixelBox& some : {PixelBox{0, 0, 16, 8}, PixelBox{16, 8, 96, 64}, PixelBox{48, 24, 64, 56}}) {
    Ink ink(some);
    for (const ReferenceStroke& stroke : strokes) draw(ink, stroke, large_page);
    EXPECT_EQ(samples_of(ink, some), samples_of(all, some)) << some.left << ' ' << some.top;
  }
}

TEST(Stroke, ComesBackFromFarAwayAsItWent) {
  // Both lines are the same where they show; one of them leaves the numbers that can be rounded.
  for (const bool closed : {false, true}) {
    ReferenceStroke near;
    near.closed = closed;
    near.points = {{5000, 5000}, {20000, 9000}, {20000, 900000}, {-90000, 900000}, {-90000, 5000}};
    Ink far(part);
    PathStroker stroker(far, page);
    stroker.set_style({1.0, Cap::round, Join::round, 4.0});
    stroker.begin(closed);
    for (const Vec2 p : {Vec2{5000 / 1024.0, 5000 / 1024.0}, Vec2{20000 / 1024.0, 9000 / 1024.0},
                         Vec2{20000 / 1024.0, 1e290}, Vec2{-1e290, 1e290}, Vec2{-1e200, 5000 / 1024.0}}) {
      stroker.to(p);
    }
    stroker.end();
    EXPECT_EQ(differing_samples(samples_of(far, part), drawn(near)), 0) << closed;
  }
}

/// What a dashed line and the given full lines have in common: all.
void expect_dashes(const std::vector<Vec2>& line, bool closed, const std::vector<double>& pattern, double offset,
                   const std::vector<std::vector<Vec2>>& pieces, const StrokeStyle& style, Cap cap_of_pieces) {
  Ink dashed(part);
  PathStroker stroker(dashed, page);
  stroker.set_style(style);
  Dashes dashes(stroker);
  dashes.set_pattern(pattern, offset);
  dashes.begin(closed);
  for (const Vec2 p : line) dashes.to(p);
  dashes.end();
  Ink full(part);
  PathStroker plain(full, page);
  StrokeStyle style_of_pieces = style;
  style_of_pieces.cap = cap_of_pieces;
  plain.set_style(style_of_pieces);
  for (const std::vector<Vec2>& piece : pieces) {
    plain.begin(false);
    for (const Vec2 p : piece) plain.to(p);
    plain.end();
  }
  EXPECT_EQ(differing_samples(samples_of(dashed, part), samples_of(full, part)), 0);
}

TEST(Dashes, RunOnAroundCornersFromTheirOffset) {
  const StrokeStyle style{1.0, Cap::butt, Join::miter, 4.0};
  const std::vector<Vec2> line = {{2, 4}, {12, 4}, {12, 14}};
  expect_dashes(line, false, {4, 2}, 0,
                {{{2, 4}, {6, 4}}, {{8, 4}, {12, 4}}, {{12, 6}, {12, 10}}, {{12, 12}, {12, 14}}}, style, Cap::butt);
  expect_dashes(line, false, {4, 2}, 3,
                {{{2, 4}, {3, 4}}, {{5, 4}, {9, 4}}, {{11, 4}, {12, 4}, {12, 7}}, {{12, 9}, {12, 13}}}, style,
                Cap::butt);
  expect_dashes(line, false, {4, 2}, -2, {{{4, 4}, {8, 4}}, {{10, 4}, {12, 4}, {12, 6}}, {{12, 8}, {12, 12}}}, style,
                Cap::butt);
}

TEST(Dashes, OfAnOddListAreReadTwice) {
  expect_dashes({{2, 4}, {30, 4}}, false, {3}, 0,
                {{{2, 4}, {5, 4}}, {{8, 4}, {11, 4}}, {{14, 4}, {17, 4}}, {{20, 4}, {23, 4}}, {{26, 4}, {29, 4}}},
                {1.0, Cap::butt, Join::round, 4.0}, Cap::butt);
}

TEST(Dashes, WithoutLengthAreDotsAlongTheLine) {
  expect_dashes({{2, 4}, {10, 4}}, false, {0, 3}, 0, {{{2, 4}}, {{5, 4}}, {{8, 4}}},
                {1.5, Cap::round, Join::round, 4.0}, Cap::round);
  expect_dashes({{2, 4}, {10, 10}}, false, {0, 5}, 0,
                {{{1.5, 3.625}, {2.5, 4.375}}, {{5.5, 6.625}, {6.5, 7.375}}, {{9.5, 9.625}, {10.5, 10.375}}},
                {1.25, Cap::square, Join::round, 4.0}, Cap::butt);
}

TEST(Dashes, OfAClosedLineMeetWithoutCaps) {
  const std::vector<Vec2> square = {{4, 4}, {12, 4}, {12, 12}, {4, 12}};
  expect_dashes(square, true, {6, 2}, 3,
                {{{4, 4}, {4, 4}},
                 {{9, 4}, {12, 4}, {12, 7}},
                 {{12, 9}, {12, 12}, {9, 12}},
                 {{7, 12}, {4, 12}, {4, 9}},
                 {{4, 7}, {4, 4}, {7, 4}}},
                {1.0, Cap::butt, Join::miter, 4.0}, Cap::butt);
}

TEST(Dashes, TooShortToShowAreAFullLine) {
  expect_dashes({{2, 4}, {30, 9}}, false, {1e-9, 1e-9}, 0, {{{2, 4}, {30, 9}}}, {1.0, Cap::butt, Join::round, 4.0},
                Cap::butt);
}

TEST(Dashes, GoOnWhereTheyWouldBeAfterAWayOutOfSight) {
  // 1000 pixels out and back are 250 times the pattern.
  expect_dashes({{30, 4}, {30 + 1000, 4}, {30 + 1000, 12}, {2, 12}}, false, {5, 3}, 0,
                {{{30, 4}, {35, 4}},
                 {{38, 12}, {33, 12}},
                 {{30, 12}, {25, 12}},
                 {{22, 12}, {17, 12}},
                 {{14, 12}, {9, 12}},
                 {{6, 12}, {2, 12}}},
                {1.0, Cap::butt, Join::round, 4.0}, Cap::butt);
}

}  // namespace
}  // namespace burin::test
