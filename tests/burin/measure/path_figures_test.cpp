#include <cmath>

#include <gtest/gtest.h>

#include <burin/measure/path_figures.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"
#include "support/random_paths.hpp"

namespace burin::measure {
namespace {

using test::DrawnPath;

PathFigures figures_of(const std::vector<DrawnPath>& paths, std::size_t span = SIZE_MAX) {
  PathFiguresSink sink;
  EXPECT_EQ(test::draw(paths, sink, span), Flow::go);
  return sink.figures();
}

TEST(PathFigures, OfASquareAndALine) {
  const PathFigures f = figures_of({{{.closed = true}, {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}}, {{}, {{{5, 2}, {5, 7}}}}});
  EXPECT_EQ(f.paths, 2U);
  EXPECT_EQ(f.contours, 2U);
  EXPECT_EQ(f.points, 6U);
  EXPECT_EQ(f.edges, 5U);
  EXPECT_DOUBLE_EQ(f.length, 13.0);
  EXPECT_DOUBLE_EQ(f.shortest_edge, 2.0);
  EXPECT_DOUBLE_EQ(f.longest_edge, 5.0);
  EXPECT_DOUBLE_EQ(f.area, 4.0);
  EXPECT_DOUBLE_EQ(f.turn_degrees, 360.0);
  EXPECT_DOUBLE_EQ(f.bend_degrees, 360.0);
  EXPECT_EQ(f.box, (Box2{{0, 0}, {5, 7}}));
  // A closed contour ends where it began.
  EXPECT_DOUBLE_EQ(f.travel, std::hypot(5.0, 2.0));
}

TEST(PathFigures, TurnsHaveASignAndAReversalIsHalfATurn) {
  const PathFigures right = figures_of({{{}, {{{0, 0}, {1, 0}, {1, -1}}}}});
  EXPECT_DOUBLE_EQ(right.turn_degrees, -90.0);
  EXPECT_DOUBLE_EQ(right.bend_degrees, 90.0);
  EXPECT_DOUBLE_EQ(figures_of({{{}, {{{0, 0}, {1, 0}, {0, 0}}}}}).bend_degrees, 180.0);
}

TEST(PathFigures, RepeatedPointsAreNoEdges) {
  const PathFigures f = figures_of({{{}, {{{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}}}}, {{}, {{{9, 9}}}}});
  EXPECT_EQ(f.edges, 2U);
  EXPECT_EQ(f.points, 6U);
  EXPECT_DOUBLE_EQ(f.shortest_edge, 1.0);
  EXPECT_DOUBLE_EQ(f.turn_degrees, 90.0);
}

TEST(PathFigures, SnowflakesHaveTheirLengthAndArea) {
  for (int level = 0; level <= 5; ++level) {
    const auto params =
        burin::testing::two_point(R"({"motif": "koch", "base": "triangle", "levels": )" + std::to_string(level) + "}");
    PathFiguresSink sink;
    ASSERT_EQ(curves::find_family("two-point")->draw(params, {}, sink), Flow::go);
    const PathFigures& f = sink.figures();
    EXPECT_NEAR(f.length, 3.0 * std::pow(4.0 / 3.0, level), 1e-10);
    EXPECT_NEAR(f.area, std::sqrt(3.0) / 4.0 + std::sqrt(3.0) / 12.0 * (1.0 - std::pow(4.0 / 9.0, level)) / (5.0 / 9.0),
                1e-12);
    EXPECT_NEAR(f.turn_degrees, 360.0, 1e-8);
    EXPECT_EQ(f.points, 3U << (2U * static_cast<unsigned>(level)));
  }
}

TEST(PathFigures, SpansDoNotMatter) {
  const auto paths = test::random_paths(4, 1, 20);
  const PathFigures whole = figures_of(paths);
  const PathFigures parts = figures_of(paths, 3);
  EXPECT_EQ(whole.length, parts.length);
  EXPECT_EQ(whole.travel, parts.travel);
  EXPECT_EQ(whole.bend_degrees, parts.bend_degrees);
  EXPECT_EQ(whole.area, parts.area);
}

}  // namespace
}  // namespace burin::measure
