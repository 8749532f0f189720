#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/dimension.hpp>
#include <burin/curves/fractal_interpolation/limit.hpp>

#include "made_data.hpp"
#include "support/json_value.hpp"

namespace burin::curves::fractal_interpolation {
namespace {

using nlohmann::json;

/// The data of the reference's table with these scalings.
Interpolant rough(const json& row) {
  InterpolationData data = plain_data(row["x"], {0.0, 0.8, 0.2, 1.0, 0.3});
  data = with_shape(std::move(data), {1.5, 0.7});
  for (std::size_t i = 0; i < data.scalings.size(); ++i) data.scalings[i] = scaling_from(row["s"][i]);
  return make_interpolant(data);
}

double measured(const Interpolant& f) {
  const std::vector<double> sums = oscillation_sums(f, 6, 3);
  return math::log(sums[6] / sums[5]) / math::log(static_cast<double>(f.pieces.size())) + 1.0;
}

TEST(FractalDimension, IsTheReferences) {
  const json rows = testing::reference("interpolation.json")["dimension"];
  ASSERT_EQ(rows.size(), 9U);
  for (const json& row : rows) {
    SCOPED_TRACE(row["s"].dump());
    const Interpolant f = rough(row);
    if (row["exact"]) {
      EXPECT_NEAR(constant_dimension(f), row["dim"].get<double>(), 1e-12);
      continue;
    }
    EXPECT_NEAR(spectral_dimension(f), row["dim_spectral"].get<double>(), 1e-4);
    EXPECT_NEAR(separate_bounds(f).lower, row["paper_bounds"][0].get<double>(), 1e-12);
    EXPECT_NEAR(separate_bounds(f).upper, row["paper_bounds"][1].get<double>(), 1e-12);
    EXPECT_NEAR(joint_bounds(f).lower, row["sum_bounds"][0].get<double>(), 1e-12);
    EXPECT_NEAR(joint_bounds(f).upper, row["sum_bounds"][1].get<double>(), 1e-12);
  }
}

TEST(FractalDimension, OscillationsGrowAsPredicted) {
  const json rows = testing::reference("interpolation.json")["dimension"];
  for (const std::size_t row : {0U, 1U, 2U, 7U}) {
    const Interpolant f = rough(rows[row]);
    const double predicted = row == 7 ? spectral_dimension(f) : constant_dimension(f);
    EXPECT_NEAR(measured(f), predicted, 0.01) << rows[row]["s"];
  }
}

TEST(FractalDimension, CertificateProvesRoughDataAndRefusesTheParabola) {
  const json nodes = {0, 0.25, 0.5, 0.75, 1};
  const json half = {{"x", nodes}, {"s", {{0.5}, {0.5}, {0.5}, {0.5}}}};
  const json more = {{"x", nodes}, {"s", {{0.8}, {0.8}, {0.8}, {0.8}}}};
  EXPECT_EQ(growth_certificate(rough(half), 5), 3);
  EXPECT_EQ(growth_certificate(rough(more), 5), 1);
  // x^2 with s = 0.9 is x^2 again: the paper's dimension 1 + log_4 3.6 is wrong.
  const InterpolationData parabola =
      with_scaling(plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.0625, 0.25, 0.5625, 1.0}), constant_scaling(0.9));
  EXPECT_EQ(growth_certificate(make_interpolant(parabola), 4), std::nullopt);
  EXPECT_NEAR(measured(make_interpolant(parabola)), 1.0, 1e-6);
}

TEST(FractalDimension, IsBoundedByWhatIsProven) {
  const json rows = testing::reference("interpolation.json")["dimension"];
  for (const json& row : rows) {
    SCOPED_TRACE(row["s"].dump());
    const Interpolant f = rough(row);
    const FractalDimension found = graph_dimension(f);
    EXPECT_LE(found.bounds.lower, found.bounds.upper);
    EXPECT_EQ(found.bounds.lower > 1.0, found.certificate && separate_bounds(f).lower > 1.0);
    if (found.spectral) {
      EXPECT_LE(found.bounds.lower, *found.spectral + 1e-9);
      EXPECT_GE(found.bounds.upper, *found.spectral - 1e-9);
    }
  }
  // The parabola is smooth whatever its scaling: nothing above 1 is proven, nothing excluded.
  const Interpolant parabola = make_interpolant(
      with_scaling(plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.0625, 0.25, 0.5625, 1.0}), constant_scaling(0.9)));
  const FractalDimension smooth = graph_dimension(parabola);
  EXPECT_EQ(smooth.bounds.lower, 1.0);
  EXPECT_EQ(smooth.certificate, std::nullopt);
  EXPECT_EQ(smoothness_of(parabola, smooth).excluded, std::nullopt);
}

TEST(FractalDimension, MeasuredByOscillationsIsThePredictedOne) {
  for (const json& row : testing::reference("interpolation.json")["dimension"]) {
    SCOPED_TRACE(row["s"].dump());
    const FractalDimension found = graph_dimension(rough(row));
    if (row["x"][1] != 0.25) continue;  // unequal intervals
    EXPECT_NEAR(found.oscillation.value_or(0.0), found.spectral.value_or(0.0), 0.03);
  }
  EXPECT_EQ(oscillation_dimension(make_interpolant(plain_data({0.0, 1.0, 2.0}, {1.0, 1.0, 1.0}))), std::nullopt);
}

TEST(FractalDimension, OfUnequalIntervalsIsKnownForConstantScaling) {
  InterpolationData data = plain_data({0.0, 0.1, 0.35, 0.6, 1.0}, {0.0, 0.8, 0.2, 1.0, 0.3});
  const FractalDimension constant = graph_dimension(make_interpolant(with_scaling(data, constant_scaling(0.6))));
  EXPECT_NEAR(constant.spectral.value_or(0.0), 1.6140, 5e-5);  // the reference's table
  EXPECT_NEAR(constant.bounds.upper, 1.6140, 5e-5);
  EXPECT_EQ(constant.bounds.lower, 1.0);
  const Scaling linear{Scaling::Kind::chebyshev, {0.4, 0.2}};
  EXPECT_EQ(graph_dimension(make_interpolant(with_scaling(data, linear))).spectral, std::nullopt);
}

TEST(FractalDimension, OfAContourIsThatOfItsImages) {
  // Equal factors s > a: log 4 / log(1/s), as in the reference's table; smaller ones: a line's 1.
  const auto bound = [](double s) {
    const InterpolationData data = plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.8, 0.2, 1.0, 0.3});
    const Interpolant f = make_interpolant(with_scaling(data, constant_scaling(s)));
    return contour_dimension_bound(f, f);
  };
  EXPECT_NEAR(bound(0.35), 1.3205, 5e-5);
  EXPECT_NEAR(bound(0.40), 1.5129, 5e-5);
  EXPECT_NEAR(bound(0.2), 1.0, 1e-12);
  EXPECT_EQ(bound(0.8), 2.0);
}

TEST(FractalLimit, SmoothnessFollowsFromScalingAndDimension) {
  const auto smoothness = [](double s) {
    const InterpolationData data = plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.8, 0.2, 1.0, 0.3});
    const Interpolant f = make_interpolant(with_scaling(data, constant_scaling(s)));
    return smoothness_of(f, graph_dimension(f));
  };
  EXPECT_EQ(smoothness(0.2).proven, 1);
  EXPECT_EQ(smoothness(0.2).exponent_low, 1.0);
  EXPECT_EQ(smoothness(0.25).proven, 0);
  const Smoothness rough = smoothness(0.5);
  EXPECT_EQ(rough.proven, 0);
  EXPECT_EQ(rough.excluded, 1);
  EXPECT_NEAR(rough.exponent_low, 0.5, 1e-12);  // log 2 / log 4
  EXPECT_NEAR(rough.exponent_high.value_or(0.0), 0.5, 1e-12);
}

TEST(FractalDimension, UnequalIntervalsAreTold) {
  EXPECT_TRUE(has_equal_intervals(make_interpolant(plain_data({0.1, 0.2, 0.3}, {0.0, 1.0, 0.0}))));
  EXPECT_FALSE(has_equal_intervals(make_interpolant(plain_data({0.1, 0.2, 0.4}, {0.0, 1.0, 0.0}))));
}

}  // namespace
}  // namespace burin::curves::fractal_interpolation
