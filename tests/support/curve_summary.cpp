#include "support/curve_summary.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>

#include "support/json_value.hpp"

namespace burin::testing {

Recording record(std::string_view family, const std::any& params, const DrawContext& context) {
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(curves::find_family(family)->draw(params, context, checked), Flow::go);
  return recorder.take();
}

std::vector<Vec2> draw_points(const curves::TwoPointParams& params, std::uint64_t seed) {
  return record("two-point", params, {.seed = seed}).all_points();
}

std::vector<Vec2> draw_points(std::string_view family, const nlohmann::json& params, const DrawContext& context) {
  const ReadParams read = read_params(family, params.dump());
  EXPECT_TRUE(read.params.has_value()) << params.dump() << problems_text(read.problems);
  return read.params ? record(family, *read.params, context).all_points() : std::vector<Vec2>{};
}

nlohmann::json json_points(const std::vector<Vec2>& points) {
  nlohmann::json list = nlohmann::json::array();
  for (const Vec2 p : points) list.push_back({p.x, p.y});
  return list;
}

namespace {

void expect_near(double actual, double expected, double scale, std::string_view what) {
  EXPECT_NEAR(actual, expected, 1e-9 * std::max({1.0, std::abs(expected), scale})) << what;
}

}  // namespace

void expect_points(const std::vector<Vec2>& points, const nlohmann::json& expected) {
  ASSERT_GE(points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expect_near(points[i].x, expected[i][0], 0.0, "x of point " + std::to_string(i));
    expect_near(points[i].y, expected[i][1], 0.0, "y of point " + std::to_string(i));
  }
}

void expect_summary(const std::vector<Vec2>& points, bool closed, const nlohmann::json& expected) {
  Vec2 sum;
  Vec2 weighted;
  double squares = 0.0;
  double total_length = 0.0;
  double area = 0.0;
  Box2 box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i];
    sum = sum + p;
    weighted = weighted + static_cast<double>(i % 251 + 1) * p;
    squares += length_squared(p);
    box.add(p);
    if (i + 1 == points.size() && !closed) break;
    const Vec2 q = points[(i + 1) % points.size()];
    total_length += distance(p, q);
    area += 0.5 * cross(p, q);
  }
  const auto count = static_cast<double>(points.size());
  EXPECT_EQ(count, expected["count"].get<double>());
  expect_near(sum.x, expected["sum"][0], count, "sum x");
  expect_near(sum.y, expected["sum"][1], count, "sum y");
  expect_near(weighted.x, expected["wsum"][0], 251.0 * count, "wsum x");
  expect_near(weighted.y, expected["wsum"][1], 251.0 * count, "wsum y");
  expect_near(squares, expected["sumsq"], 0.0, "sumsq");
  expect_near(total_length, expected["length"], 0.0, "length");
  expect_near(area, expected["area"], 0.0, "area");
  expect_near(box.low.x, expected["bbox"][0], 0.0, "bbox");
  expect_near(box.low.y, expected["bbox"][1], 0.0, "bbox");
  expect_near(box.high.x, expected["bbox"][2], 0.0, "bbox");
  expect_near(box.high.y, expected["bbox"][3], 0.0, "bbox");
}

}  // namespace burin::testing
