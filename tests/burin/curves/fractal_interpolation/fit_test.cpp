#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include <burin/curves/fractal_interpolation/contour.hpp>
#include <burin/curves/fractal_interpolation/fit.hpp>
#include <burin/curves/fractal_interpolation/least_squares.hpp>
#include <burin/curves/fractal_interpolation/refine.hpp>
#include <burin/curves/fractal_interpolation/source_points.hpp>

#include "made_data.hpp"
#include "support/json_value.hpp"

/// Fits against the reference's vectors and its measured errors, interpolation_results.json.
namespace burin::curves::fractal_interpolation {
namespace {

using nlohmann::json;

/// A* A and A* b of rows.
struct Normal {
  std::vector<double> gram;
  std::vector<double> moment;
};

Normal normal_equations(const json& rows, const json& right) {
  const std::size_t k = rows[0].size();
  Normal normal{std::vector<double>(k * k), std::vector<double>(k)};
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t a = 0; a < k; ++a) {
      normal.moment[a] += rows[j][a].get<double>() * right[j].get<double>();
      for (std::size_t b = 0; b < k; ++b) normal.gram[a * k + b] += rows[j][a].get<double>() * rows[j][b].get<double>();
    }
  }
  return normal;
}

TEST(LeastSquares, KeepWithinTheBallAsTheReference) {
  const json lsq = testing::reference("interpolation.json")["lsq_l1"];
  const Normal normal = normal_equations(lsq["A"], lsq["b"]);
  const std::vector<double> c = least_squares_within(normal.gram, normal.moment, lsq["radius"]);
  for (std::size_t k = 0; k < c.size(); ++k) EXPECT_NEAR(c[k], lsq["c"][k].get<double>(), lsq["tol"].get<double>());
  for (const json& row : lsq["project"]) {
    const std::vector<double> p = project_on_l1_ball(row["c"].get<std::vector<double>>(), row["r"]);
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p[k], row["p"][k].get<double>(), 1e-15);
  }
}

TEST(LeastSquares, AreFreeInsideAndTakeDependentColumns) {
  // 2 c0 + c1 = 1, c0 + c1 = 0.4; then the second column twice the first.
  EXPECT_NEAR(least_squares_within(std::vector{5.0, 3.0, 3.0, 2.0}, std::vector{2.4, 1.4}, 0.9)[0], 0.6, 1e-12);
  const std::vector<double> dependent =
      least_squares_within(std::vector{1.0, 2.0, 2.0, 4.0}, std::vector{0.5, 1.0}, 0.9);
  EXPECT_EQ(dependent, (std::vector{0.5, 0.0}));
  EXPECT_EQ(least_squares_within(std::vector{0.0}, std::vector{0.0}, 0.9), std::vector{0.0});
}

/// Level set 2 of the reference's known interpolant, and its nodes in it.
struct KnownData {
  InterpolationData truth;
  std::vector<double> t;
  std::vector<double> g;
  std::vector<std::size_t> knots;

  DenseData dense() const { return {t, g, knots, Ends::open}; }
};

KnownData known_data() {
  const json fit = testing::reference("interpolation.json")["fit"];
  KnownData known{data_from(fit["truth"]), {}, {}, fit["knots"]};
  for (const Vec2 p : level_set(make_interpolant(known.truth), 2)) {
    known.t.push_back(p.x);
    known.g.push_back(p.y);
  }
  return known;
}

TEST(Fit, CollageAtTheTrueShapeFindsTheTrueScaling) {
  const json fit = testing::reference("interpolation.json")["fit"];
  const KnownData known = known_data();
  ASSERT_EQ(known.t.size(), fit["data_count"].get<std::size_t>());
  for (const auto& [name, coefficients] :
       {std::pair{"collage_fixed_shape_K2", 2U}, std::pair{"collage_fixed_shape_K1", 1U}}) {
    const CoordinateFit found = collage_fit(known.dense(), known.truth.derivatives, known.truth.shapes, coefficients);
    const json& expected = fit[name];
    for (std::size_t i = 0; i < found.data.scalings.size(); ++i) {
      for (std::size_t k = 0; k < coefficients; ++k) {
        EXPECT_NEAR(found.data.scalings[i].c[k], expected["c"][i][k].get<double>(), 1e-12);
      }
    }
    EXPECT_NEAR(std::sqrt(found.mean_square), expected["rmse"].get<double>(), 1e-9);
  }
}

TEST(Fit, RefinementFindsTheUnknownShape) {
  const KnownData known = known_data();
  const std::size_t n = known.truth.shapes.size();
  const CoordinateFit start = collage_fit(known.dense(), known.truth.derivatives, std::vector<Shape>(n), 2);
  EXPECT_GT(std::sqrt(start.mean_square), 1e-3);
  const CoordinateFit found = refined(known.dense(), start, {});
  const json expected = testing::reference("interpolation.json")["fit"]["refined_from_alpha_beta_3"];
  EXPECT_LT(std::sqrt(found.mean_square), expected["must_be_below"].get<double>());
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(found.data.shapes[i].alpha, known.truth.shapes[i].alpha, 1e-5);
  // Nothing that must not move does, and the error never grows.
  const CoordinateFit fixed = refined(known.dense(), start, {.scalings = true, .shapes = false});
  EXPECT_EQ(fixed.data.shapes, start.data.shapes);
  EXPECT_LE(fixed.mean_square, start.mean_square);
}

TEST(Fit, MoreFreedomIsNeverWorse) {
  const KnownData known = known_data();
  std::vector<double> errors;
  for (const auto& word : words(Method{})) errors.push_back(fit_by(word.value, known.dense()).mean_square);
  EXPECT_LE(errors[1], errors[0]);
  EXPECT_LE(errors[2], errors[0]);
  EXPECT_LE(errors[3], std::min(errors[1], errors[2]));
  EXPECT_LT(std::sqrt(errors[3]), 0.02);
}

SourcePoints shipped(const std::string& name, bool lonlat) {
  std::ostringstream text;
  text << std::ifstream(std::string(BURIN_SOURCE_DIR) + "/presets/data/" + name).rdbuf();
  Result<SourcePoints> source = points_of_csv(text.str(), name);
  EXPECT_TRUE(source.ok());
  if (lonlat) project_from_degrees(source->points);
  return *std::move(source);
}

struct DataSet {
  const char* name;
  const char* file;
  bool lonlat;
  Ends ends;
};

class FitOfData : public ::testing::TestWithParam<DataSet> {};

/// Within 1.1 times the reference's error with either derivative rule, and in the paper's order.
TEST_P(FitOfData, IsAsNearAsTheReferences) {
  const json runs = testing::reference("interpolation_results.json")["runs"];
  const SourcePoints source = shipped(GetParam().file, GetParam().lonlat);
  std::map<int, Comparison> by_intervals;
  for (const json& run : runs) {
    if (run["data"] != GetParam().name) continue;
    SCOPED_TRACE(run["intervals"].dump() + " " + run["d"].get<std::string>());
    const int intervals = run["intervals"];
    if (by_intervals.count(intervals) == 0) {
      by_intervals[intervals] = compare_methods(source.points, intervals, GetParam().ends);
    }
    const Comparison& ours = by_intervals[intervals];
    EXPECT_EQ(ours.knots.size(), run["intervals"].get<std::size_t>() + 1);
    const std::array<const char*, method_count> names{"cubic spline", "poly fn", "rat const", "rat fn"};
    for (std::size_t m = 0; m < method_count; ++m) {
      EXPECT_LE(ours.fits[m].rmse, 1.1 * run["rmse"][names[m]].get<double>()) << names[m];
      EXPECT_EQ(stored_numbers(words(Method{})[m].value, ours.knots.size() - 1),
                run["floats"][names[m]].get<std::size_t>());
      if (m > 0) {
        EXPECT_LT(ours.fits[m].rmse, ours.fits[m - 1].rmse) << names[m];
      }
    }
    EXPECT_NEAR(ours.fits[0].rmse, run["rmse"]["cubic spline"].get<double>(), 1e-9);
  }
  EXPECT_FALSE(by_intervals.empty());
}

INSTANTIATE_TEST_SUITE_P(Data, FitOfData,
                         ::testing::Values(DataSet{"spiral", "fibonacci_spiral.csv", false, Ends::open},
                                           DataSet{"beetle", "beetle_outline.csv", false, Ends::periodic},
                                           DataSet{"maine", "coastline_maine.csv", true, Ends::open},
                                           DataSet{"cornwall", "coastline_cornwall.csv", true, Ends::open}),
                         [](const auto& test) { return test.param.name; });

TEST(Fit, OfVeryManyPointsTakesASample) {
  const auto spiral = [](std::size_t count) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k <= count; ++k) {
      const double t = 9.0 * static_cast<double>(k) / static_cast<double>(count);
      points.push_back({(1.0 + t) * std::cos(t), (1.0 + t) * std::sin(t)});
    }
    return points;
  };
  const Comparison many = compare_methods(spiral(250'000), 6, Ends::open);
  const Comparison few = compare_methods(spiral(2'500), 6, Ends::open);
  EXPECT_EQ(many.step, 2U);
  EXPECT_EQ(few.step, 1U);
  EXPECT_EQ(many.t.size(), 250'001U);
  for (std::size_t m = 0; m < method_count; ++m) {
    EXPECT_NEAR(many.fits[m].rmse, few.fits[m].rmse, 0.02 * few.fits[m].rmse) << m;
  }
}

TEST(Contour, KnotsAreSpreadAndDistinct) {
  const std::vector<double> t{0.0, 0.1, 0.2, 0.9, 1.0};
  EXPECT_EQ(spread_knots(t, 2), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(spread_knots(t, 4), (std::vector<std::size_t>{0, 2, 3, 4}));
  const std::vector<Vec2> line{{0.0, 0.0}, {3.0, 4.0}, {3.0, 9.0}};
  EXPECT_EQ(chord_parameters(line), (std::vector{0.0, 0.5, 1.0}));
  EXPECT_EQ(chord_length(line), 10.0);
}

TEST(SourcePointsTest, RepetitionsAreCountedAndLinesKept) {
  Result<SourcePoints> source = points_of_csv("lat;lon\r\n1;2\r\n1;2\r\n1;2\r\n3;4\r\n", "d.csv");
  ASSERT_TRUE(source.ok());
  EXPECT_EQ(source->points.front(), (Vec2{2.0, 1.0}));
  const Repetitions repeated = drop_repeated(*source);
  EXPECT_EQ(repeated.count, 2U);
  EXPECT_EQ(repeated.first.line, 3);
  EXPECT_EQ(source->points.size(), 2U);
  EXPECT_EQ(source->where(1).line, 5);
  EXPECT_TRUE(check_increasing(*source).ok());
  close_up(*source);
  EXPECT_EQ(source->points.size(), 3U);
  const Result<Done> back = check_increasing(*source);
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.problems().front().where.line, 2);
}

}  // namespace
}  // namespace burin::curves::fractal_interpolation
