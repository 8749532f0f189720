#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <burin/measure/box_dimension.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::measure {
namespace {

Recording polyline(const std::vector<Vec2>& points, bool closed = false) {
  Recorder recorder;
  EXPECT_EQ(recorder.begin({.closed = closed}), Flow::go);
  EXPECT_EQ(recorder.points(points), Flow::go);
  EXPECT_EQ(recorder.end(), Flow::go);
  return recorder.take();
}

/// "7/3" or "5".
double ratio(const std::string& text) {
  std::istringstream in(text);
  double numerator = 0.0;
  double denominator = 1.0;
  char slash = 0;
  in >> numerator;
  if (in >> slash) in >> denominator;
  return numerator / denominator;
}

TEST(BoxCount, IsTheExactOneOfTheReference) {
  for (const nlohmann::json& row : burin::testing::reference("interpolation.json")["box_count"]) {
    std::vector<Vec2> points;
    for (const nlohmann::json& p : row["points"]) points.push_back({p[0], p[1]});
    EXPECT_EQ(box_count(polyline(points), ratio(row["eps"]), {ratio(row["offset"][0]), ratio(row["offset"][1])}),
              row["count"].get<std::uint64_t>())
        << row.dump();
  }
}

TEST(BoxCount, ClosedCurvesCountTheirLastEdge) {
  const std::vector<Vec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(box_count(polyline(square), 1.0, {-0.5, -0.5}), 13U);
  EXPECT_EQ(box_count(polyline(square, true), 1.0, {-0.5, -0.5}), 16U);
}

TEST(BoxCount, PointsWithoutAnEdgeMeetNoBox) {
  EXPECT_EQ(box_count(polyline({{1, 1}}), 1.0, {}), 0U);
  EXPECT_EQ(box_count(polyline({{1, 1}, {1, 1}}), 1.0, {}), 0U);
  EXPECT_EQ(box_count(Recording{}, 1.0, {}), 0U);
}

struct Known {
  const char* name;
  Recording drawing;
  double dimension;
  double tolerance;
};

Recording two_point_curve(const char* json) {
  return burin::testing::record("two-point", burin::testing::two_point(json));
}

std::vector<Known> known_curves() {
  std::vector<Vec2> circle;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 2000.0;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  std::vector<Known> known;
  known.push_back({"segment", polyline({{0, 0}, {1, 0.3}}), 1.0, 0.02});
  known.push_back({"circle", polyline(circle), 1.0, 0.02});
  known.push_back({"Koch", two_point_curve(R"({"motif": "koch", "levels": 8})"), std::log(4.0) / std::log(3.0), 0.02});
  known.push_back({"Minkowski", two_point_curve(R"({"motif": "minkowski", "levels": 5})"), 1.5, 0.04});
  known.push_back({"Hilbert", two_point_curve(R"({"motif": "hilbert", "levels": 9})"), 2.0, 0.06});
  return known;
}

TEST(BoxDimension, OfKnownCurves) {
  for (const Known& known : known_curves()) {
    const Result<BoxDimension> found = box_dimension(known.drawing);
    ASSERT_TRUE(found) << known.name;
    EXPECT_NEAR(found->dimension, known.dimension, known.tolerance) << known.name;
    EXPECT_GT(found->r_squared, 0.99) << known.name;
    EXPECT_LT(found->standard_error, 0.02) << known.name;
  }
}

TEST(BoxDimension, IsTheReferencesEstimate) {
  const nlohmann::json rows = burin::testing::reference("interpolation.json")["box_dimension"];
  const std::vector<Known> known = known_curves();
  for (std::size_t i : {0U, 2U, 3U}) {
    EXPECT_NEAR(box_dimension(known[i].drawing)->dimension, rows[i]["oracle"].get<double>(), 2e-3) << known[i].name;
  }
}

/// The graph over nodes `x` at so many levels.
Recording graph(const nlohmann::json& scaling, int levels, const std::vector<double>& x = {0, 0.25, 0.5, 0.75, 1}) {
  const std::vector<double> y{0, 0.8, 0.2, 1, 0.3};
  nlohmann::json params{{"alpha", 1.5}, {"beta", 0.7}, {"scaling", scaling}, {"levels", levels}};
  for (std::size_t k = 0; k < x.size(); ++k) params["points"].push_back({x[k], y[k]});
  return polyline(burin::testing::draw_points("fractal-interpolation", params));
}

TEST(BoxDimension, OfGraphsOfFractalInterpolations) {
  const auto expect = [](const Recording& drawing, double dimension) {
    const Result<BoxDimension> found = box_dimension(drawing);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->is_of_graph);
    EXPECT_NEAR(found->dimension, dimension, 0.03);
  };
  expect(graph(0.5, 6), 1.5);
  expect(graph(0.7, 4), 1.7427);
  expect(graph({0.9, -0.6, 0.4, 0.8}, 6), 1.7165);
  expect(graph(0.3, 7), 1.1315);
  expect(graph(0.1, 6), 1.0);
  expect(graph(nlohmann::json::parse("[[0.5, 0.4]]"), 6), 1.5460);
  expect(graph(0.6, 6, {0, 0.1, 0.35, 0.6, 1}), 1.6140);
}

TEST(BoxDimension, OfASmoothGraphIsOne) {
  std::vector<Vec2> line;
  std::vector<Vec2> wave;
  for (int i = 0; i <= 5000; ++i) {
    line.push_back({5.0 - 0.001 * i, 0.3 * i});
    wave.push_back({0.001 * i, std::sin(0.001 * i)});
  }
  EXPECT_NEAR(box_dimension(polyline(line))->dimension, 1.0, 1e-9);
  EXPECT_NEAR(box_dimension(polyline(wave))->dimension, 1.0, 0.02);
  // What stands, what turns back and what is flat is counted on a grid.
  for (Vec2& p : line) p.x = 1.0;
  EXPECT_FALSE(box_dimension(polyline(line))->is_of_graph);
  wave.back().x = 0.0;
  EXPECT_FALSE(box_dimension(polyline(wave))->is_of_graph);
  for (Vec2& p : wave) p.y = 1.0;
  EXPECT_FALSE(box_dimension(polyline(wave))->is_of_graph);
}

TEST(BoxDimension, DoesNotDependOnPlaceAndSize) {
  std::vector<Vec2> points = two_point_curve(R"({"motif": "koch", "levels": 6})").all_points();
  const double here = box_dimension(polyline(points))->dimension;
  for (Vec2& p : points) p = 1024.0 * p;
  EXPECT_NEAR(box_dimension(polyline(points))->dimension, here, 1e-9);
}

TEST(BoxDimension, OfFewEdgesIsThatOfThePolyline) {
  const Result<BoxDimension> square = box_dimension(polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true));
  ASSERT_TRUE(square);
  EXPECT_NEAR(square->dimension, 1.0, 0.02);
  EXPECT_TRUE(square->is_of_few_edges);
  EXPECT_FALSE(box_dimension(two_point_curve(R"({"motif": "koch", "levels": 6})"))->is_of_few_edges);
}

TEST(BoxDimension, NeedsSomeExtent) {
  EXPECT_FALSE(box_dimension(Recording{}));
  EXPECT_FALSE(box_dimension(polyline({{3, 3}})));
}

}  // namespace
}  // namespace burin::measure
