#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>

#include "made_data.hpp"
#include "support/json_value.hpp"

/// The reference's vectors, interpolation.json: computed by an independent program, checked at 40 digits.
namespace burin::curves::fractal_interpolation {
namespace {

using nlohmann::json;

const json& vectors() {
  static const json all = testing::reference("interpolation.json");
  return all;
}

void expect_relative(double actual, const json& expected, double tolerance = 1e-12) {
  const auto value = expected.get<double>();
  EXPECT_NEAR(actual, value, tolerance * std::max(1.0, std::abs(value)));
}

void expect_weights(const Weights& w, const json& expected) {
  expect_relative(w.left, expected[0]);
  expect_relative(w.right, expected[1]);
  expect_relative(w.left_slope, expected[2]);
  expect_relative(w.right_slope, expected[3]);
}

TEST(InterpolationVectors, Basis) {
  ASSERT_EQ(vectors()["basis"].size(), 8U);
  for (const json& row : vectors()["basis"]) {
    const Shape shape{row["alpha"], row["beta"]};
    expect_weights(weights_at(row["theta"], shape), row["w"]);
    expect_weights(weight_slopes_at(row["theta"], shape), row["dw"]);
  }
}

TEST(InterpolationVectors, MeanDerivatives) {
  for (const json& row : vectors()["amm"]) {
    const std::vector<double> d =
        mean_derivatives(row["x"].get<std::vector<double>>(), row["f"].get<std::vector<double>>(),
                         row["periodic"].get<bool>() ? Ends::periodic : Ends::open);
    ASSERT_EQ(d.size(), row["d"].size());
    for (std::size_t i = 0; i < d.size(); ++i) expect_relative(d[i], row["d"][i]);
  }
}

TEST(InterpolationVectors, Scalings) {
  ASSERT_EQ(vectors()["scale"].size(), 3U);
  for (const json& row : vectors()["scale"]) {
    const Scaling scaling = scaling_from(row);
    for (std::size_t k = 0; k < row["theta"].size(); ++k) {
      expect_relative(scaling_at(scaling, row["theta"][k]), row["value"][k]);
    }
    expect_relative(sup_bound(scaling), row["sup_bound"]);
    expect_relative(lipschitz_bound(scaling), row["lip_bound"]);
  }
}

void expect_level(const Interpolant& f, const json& level) {
  const std::vector<Vec2> points = level_set(f, level["m"]);
  ASSERT_EQ(points.size(), level["count"].get<std::size_t>());
  double sum = 0.0;
  double low = points[0].y;
  double high = points[0].y;
  for (const Vec2 p : points) {
    sum += p.y;
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  EXPECT_NEAR(sum, level["sum_y"].get<double>(), 1e-12 * static_cast<double>(points.size()) * (1.0 + high - low));
  expect_relative(low, level["min_y"]);
  expect_relative(high, level["max_y"]);
}

TEST(InterpolationVectors, LevelSetsAddressesValuesAndBounds) {
  ASSERT_EQ(vectors()["fif"].size(), 9U);
  for (const json& row : vectors()["fif"]) {
    SCOPED_TRACE(row["name"].get<std::string>());
    const Interpolant f = make_interpolant(data_from(row["fif"]));
    expect_relative(largest_scaling(f), row["S_sup"]);
    expect_relative(gap_bound(f), row["gap_bound"]);
    const std::vector<Vec2> level1 = level_set(f, 1);
    ASSERT_EQ(level1.size(), row["level1"]["x"].size());
    for (std::size_t k = 0; k < level1.size(); ++k) {
      expect_relative(level1[k].x, row["level1"]["x"][k]);
      expect_relative(level1[k].y, row["level1"]["y"][k]);
    }
    for (const json& level : row["level"]) expect_level(f, level);
    for (const json& address : row["address"]) {
      const GraphPoint p = point_at(f, address["digits"].get<std::vector<std::uint32_t>>(), address["node"]);
      expect_relative(f.begin + f.length * p.theta, address["x"]);
      expect_relative(p.y, address["y"]);
    }
    if (row.contains("eval")) {
      for (std::size_t k = 0; k < row["eval"]["x"].size(); ++k) {
        EXPECT_NEAR(value_at(f, row["eval"]["x"][k]), row["eval"]["y"][k].get<double>(),
                    row["eval"]["tol"].get<double>());
      }
    }
    // The reference takes the largest sampled slopes and adds 0.1 percent; ours are bounds, at most 2 percent above.
    const std::vector<double> bounds = level_bounds(f, static_cast<int>(row["level_error_bound"].size()) - 1);
    for (std::size_t m = 0; m < bounds.size(); ++m) {
      const double sampled = row["level_error_bound"][m];
      EXPECT_GE(bounds[m], 0.9985 * sampled) << m;
      EXPECT_LE(bounds[m], 1.025 * sampled) << m;
    }
  }
}

TEST(InterpolationVectors, ChaosGame) {
  const json& chaos = vectors()["chaos"];
  std::uint64_t state = chaos["seed"];
  for (const json& expected : chaos["splitmix_first"]) {
    EXPECT_EQ(mix(state), std::stoull(expected.get<std::string>(), nullptr, 16));
    state += 0x9E3779B97F4A7C15U;
  }
  for (const json& row : vectors()["fif"]) {
    if (row["name"] != chaos["fif"]) continue;
    const std::vector<Vec2> points =
        chaos_points(make_interpolant(data_from(row["fif"])), chaos["points"].size(), chaos["seed"]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      expect_relative(points[k].x, chaos["points"][k][0]);
      expect_relative(points[k].y, chaos["points"][k][1]);
    }
  }
}

TEST(InterpolationVectors, Stability) {
  const json& row = vectors()["stability"];
  const InterpolationData data = data_from(row["fif"]);
  const auto dv = row["df"].get<std::vector<double>>();
  const auto dd = row["dd"].get<std::vector<double>>();
  InterpolationData moved = data;
  for (std::size_t i = 0; i < dv.size(); ++i) {
    moved.values[i] += dv[i];
    moved.derivatives[i] += dd[i];
  }
  expect_relative(stability_bound(make_interpolant(data), dv, dd), row["bound"]);
  const std::vector<Vec2> a = level_set(make_interpolant(data), 4);
  const std::vector<Vec2> b = level_set(make_interpolant(moved), 4);
  double change = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) change = std::max(change, std::abs(a[k].y - b[k].y));
  expect_relative(change, row["max_change_level4"]);
}

}  // namespace
}  // namespace burin::curves::fractal_interpolation
