#include <cmath>

#include <gtest/gtest.h>

#include <burin/path/recording.hpp>
#include <burin/preset/layer_run.hpp>
#include <burin/preset/pen_bands.hpp>

namespace burin::preset {
namespace {

/// A slot of 40 x 20 mm.
primitives::Setting setting_of(const Copy& copy, std::uint64_t seed) {
  return preset::setting_of({{100, 100}, 40, 20}, copy, {.seed = seed});
}

PenChoice choice(std::string_view by, std::vector<double> at) {
  PenChoice made;
  made.by = *expr::Expression::compile(by, primitives::position_variables, {});
  made.at = std::move(at);
  made.of.assign(made.at.size() + 1, "pen");
  return made;
}

/// One band of a path, as a recording.
Recording band(const PenChoice& pens, std::size_t which, const std::vector<Vec2>& points, bool closed = false,
               const Copy& copy = {}, std::uint64_t seed = 0) {
  Recorder recorder;
  Checked checked(recorder);
  PenBand filter(checked, pens, which, setting_of(copy, seed));
  EXPECT_EQ(filter.begin({.closed = closed}), Flow::go);
  EXPECT_EQ(filter.points(points), Flow::go);
  EXPECT_EQ(filter.end(), Flow::go);
  return recorder.take();
}

double total_length(const Recording& recording) {
  double sum = 0.0;
  for (const Recording::Path& path : recording.paths()) {
    for (const Recording::Contour& contour : recording.contours(path)) {
      const std::span<const Vec2> points = recording.points(contour);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += distance(points[i], points[i + 1]);
    }
  }
  return sum;
}

TEST(PenBand, ALineIsCutWhereTheBandChanges) {
  const PenChoice pens = choice("x", {1.0 / 3, 2.5});
  const std::vector<Vec2> line{{0, 0}, {3, 0}};
  const Recording first = band(pens, 0, line);
  const Recording middle = band(pens, 1, line);
  const Recording last = band(pens, 2, line);
  ASSERT_EQ(middle.paths().size(), 1U);
  EXPECT_NEAR(first.all_points().back().x, 1.0 / 3, 1e-8);
  EXPECT_NEAR(middle.all_points().front().x, 1.0 / 3, 1e-8);
  EXPECT_NEAR(middle.all_points().back().x, 2.5, 1e-8);
  EXPECT_EQ(last.all_points().back(), (Vec2{3, 0}));
  EXPECT_NEAR(total_length(first) + total_length(middle) + total_length(last), 3.0, 1e-9);
}

TEST(PenBand, BandsAreHalfOpenAndNanFallsIntoTheFirst) {
  const std::vector<Vec2> dot{{1, 0}};
  EXPECT_TRUE(band(choice("x", {1}), 0, dot).empty());
  EXPECT_FALSE(band(choice("x", {1}), 1, dot).empty());
  EXPECT_FALSE(band(choice("sqrt(-x)", {-5}), 0, dot).empty());
}

TEST(PenBand, ShortStretchesAreSeenAndVerticesKept) {
  // In and out again within one long edge: 2 mm of slot space are wide enough to be seen.
  const PenChoice pens = choice("abs(x-10)", {1});
  const Recording inside = band(pens, 0, {{0, 0}, {20, 0}, {20, 5}});
  EXPECT_EQ(inside.paths().size(), 1U);
  EXPECT_NEAR(total_length(inside), 2.0, 1e-7);
  const Recording outside = band(pens, 1, {{0, 0}, {20, 0}, {20, 5}});
  ASSERT_EQ(outside.paths().size(), 2U);
  EXPECT_EQ(outside.all_points().size(), 5U);  // a vertex is no cut, a step of the search no vertex
}

TEST(PenBand, AClosedPathComesBackToItsBeginning) {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Recording whole = band(choice("x", {5}), 0, square, true);
  EXPECT_NEAR(total_length(whole), 4.0, 1e-12);
  EXPECT_FALSE(whole.paths().front().head.closed);
  const Recording left = band(choice("x", {0.5}), 0, square, true);
  EXPECT_NEAR(total_length(left), 2.0, 1e-8);
}

TEST(PenBand, PlacesAreMeasuredOnThePage) {
  Copy copy;
  copy.slot_from_model = scaling(10, 10);
  copy.column = 2;
  copy.row = 3;
  copy.index = 5;
  const std::vector<Vec2> dot{{0.6, 0.8}};
  const auto sees = [&](std::string_view by, double value) {
    return !band(choice(by, {value - 1e-9, value + 1e-9}), 1, dot, false, copy).empty();
  };
  EXPECT_TRUE(sees("x", 0.6));
  EXPECT_TRUE(sees("r", 1.0));
  EXPECT_TRUE(sees("phi", std::atan2(0.8, 0.6) * 180 / M_PI));
  EXPECT_TRUE(sees("px", 6));
  EXPECT_TRUE(sees("py", 8));
  EXPECT_TRUE(sees("pr", 10));
  EXPECT_TRUE(sees("u", 0.5 + 6.0 / 40));
  EXPECT_TRUE(sees("v", 0.5 + 8.0 / 20));
  EXPECT_TRUE(sees("i", 2));
  EXPECT_TRUE(sees("j", 3));
  EXPECT_TRUE(sees("copy", 5));
  // Of a line: its edge has every direction, and a length on the page.
  const std::vector<Vec2> line{{0, 0}, {0, 0.1}};
  const auto line_sees = [&](std::string_view by, double value) {
    return !band(choice(by, {value - 1e-9, value + 1e-9}), 1, line, false, copy).empty();
  };
  for (const char* direction : {"angle", "edge", "tangent", "normal + 90"}) EXPECT_TRUE(line_sees(direction, 90));
  EXPECT_TRUE(line_sees("length", 1));
}

TEST(PenBand, EdgesHaveAnIndexAnAngleAndTheirOwnChance) {
  std::vector<Vec2> zigzag;
  for (int i = 0; i <= 2000; ++i) zigzag.push_back({0.01 * i, i % 2 == 0 ? 0.0 : 0.01});
  EXPECT_NEAR(total_length(band(choice("angle", {0}), 0, zigzag)), 1000 * 0.01 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(total_length(band(choice("index", {100}), 0, zigzag)), 100 * 0.01 * std::sqrt(2.0), 1e-9);
  const PenChoice chance = choice("rand", {0.25});
  const double drawn =
      total_length(band(chance, 0, zigzag, false, {}, 7)) / total_length(band(choice("x", {99}), 0, zigzag));
  EXPECT_NEAR(drawn, 0.25, 0.03);
  EXPECT_EQ(band(chance, 0, zigzag, false, {}, 7).all_points(), band(chance, 0, zigzag, false, {}, 7).all_points());
  EXPECT_NE(band(chance, 0, zigzag, false, {}, 7).all_points(), band(chance, 0, zigzag, false, {}, 8).all_points());
  // Symmetric copies are alike.
  Copy mirrored;
  mirrored.index = 3;
  EXPECT_EQ(band(chance, 0, zigzag, false, {}, 7).all_points(),
            band(chance, 0, zigzag, false, mirrored, 7).all_points());
}

}  // namespace
}  // namespace burin::preset
