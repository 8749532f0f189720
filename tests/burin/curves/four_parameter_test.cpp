#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/four_parameter.hpp>
#include <burin/curves/subdivision/convergence.hpp>

#include "naive_schemes.hpp"
#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// Closed forms of curves.md E, its vectors and its table of classes.
namespace burin::curves {
namespace {

using namespace naive;
using nlohmann::json;
using testing::draw_points;
using testing::json_points;

json params_of(const FourParameters& p) {
  return {{"lambda", p.lambda}, {"mu", p.mu}, {"nu", p.nu}, {"omega", p.omega}};
}

FourParameters parameters_from(const json& list) {
  return {list[0], list[1], list[2], list[3]};
}

std::vector<double> mask_of(const FourParameters& p) {
  return four_parameter_mask(p.lambda, p.mu, p.nu, p.omega);
}

FourParameterTheorems theorems_of(const FourParameters& p) {
  return four_parameter_theorems(p.lambda, p.mu, p.nu, p.omega);
}

Points drawn(const Points& base, const FourParameters& p, int levels, const std::string& ends,
             const DrawContext& context = {}) {
  json params = params_of(p);
  params["base"] = {{"points", json_points(base)}, {"closed", ends == "closed"}};
  params["levels"] = levels;
  if (ends != "closed") params["ends"] = ends;
  return draw_points("four-parameter", params, context);
}

void expect_same(const Points& actual, const Points& expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  const double tolerance = 1e-12 * size_of(expected);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_LE(distance(actual[i], expected[i]), tolerance) << what << " point " << i;
  }
}

FourParameters random_parameters(std::uint64_t seed) {
  const double sum = uniform(seed, 11);
  const double share = uniform(seed, 12);
  return {sum * share, sum * (1 - share), uniform(seed, 13), 0.4 * uniform_symmetric(seed, 14)};
}

/// Of each open curve the point set of the paper, ghosts and all.
Points without_outer(Points points) {
  return {points.begin() + 2, points.end() - 2};
}

TEST(FourParameter, TheReferenceVectors) {
  for (const auto& [name, vector] : testing::reference("curves.json")["E_four_param"].items()) {
    SCOPED_TRACE(name);
    json open = params_of(parameters_from(vector["lambda_mu_nu_omega"]));
    json closed = open;
    open["base"] = {{"points", vector["start_open"]}};
    open["ends"] = "given";
    closed["base"] = {{"points", vector["start_closed"]}, {"closed", true}};
    for (std::size_t level = 1; level <= vector["levels"].size(); ++level) {
      open["levels"] = closed["levels"] = level;
      testing::expect_points(draw_points("four-parameter", open), vector["levels"][level - 1]["open"]);
      testing::expect_points(draw_points("four-parameter", closed), vector["levels"][level - 1]["closed"]);
    }
    open["levels"] = closed["levels"] = 6;
    testing::expect_summary(draw_points("four-parameter", open), false, vector["level6_open"]);
    testing::expect_summary(draw_points("four-parameter", closed), true, vector["level6_closed"]);
  }
}

TEST(FourParameter, IsTheSchemeLevelByLevel) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const FourParameters p = random_parameters(seed);
    const int levels = static_cast<int>(seed % 10);
    const Points base = random_points(seed, 6 + seed % 4);
    Points closed = base;
    Points given = base;
    for (int level = 0; level < levels; ++level) {
      closed = four_parameter_closed(closed, p);
      given = four_parameter_open(given, p);
    }
    expect_same(drawn(base, p, levels, "closed"), closed, "closed, seed " + std::to_string(seed));
    expect_same(drawn(base, p, levels, "given"), given, "given, seed " + std::to_string(seed));
    for (const char* ends : {"linear", "reflect", "replicate"}) {
      Points open = with_ghosts(base, ends);
      for (int level = 0; level < levels; ++level) open = four_parameter_open(open, p);
      expect_same(drawn(base, p, levels, ends), without_outer(open), ends + std::to_string(seed));
    }
  }
}

TEST(FourParameter, ShortBases) {
  const FourParameters p{0.1, 0.2, 0.4, 0.05};
  for (const char* ends : {"linear", "reflect", "replicate"}) {
    EXPECT_EQ(drawn(random_points(1, 2), p, 3, ends).size(), 9U);
  }
  EXPECT_EQ(drawn(random_points(1, 2), p, 3, "closed").size(), 16U);
  // Two points reflected again and again go to and fro.
  const Points to_and_fro{{0, 0}, {1, 2}, {0, 0}, {1, 2}, {0, 0}, {1, 2}};
  Points expected = to_and_fro;
  for (int level = 0; level < 3; ++level) expected = four_parameter_open(expected, p);
  expect_same(drawn({{0, 0}, {1, 2}}, p, 3, "reflect"), without_outer(expected), "reflected");
  EXPECT_EQ(testing::read_params("four-parameter",
                                 R"({"ends": "given", "base": {"points": [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0]]}})")
                .problems.size(),
            1U);
}

TEST(FourParameter, MasksAndTheoremsAreTheReferences) {
  for (const auto& [name, vector] : testing::reference("curves.json")["E_four_param"].items()) {
    SCOPED_TRACE(name);
    const FourParameters p = parameters_from(vector["lambda_mu_nu_omega"]);
    const std::vector<double> mask = mask_of(p);
    ASSERT_EQ(mask.size(), vector["mask"].size());
    for (std::size_t i = 0; i < mask.size(); ++i) EXPECT_NEAR(mask[i], vector["mask"][i].get<double>(), 1e-15);
    const FourParameterTheorems theorems = theorems_of(p);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(theorems.applies(static_cast<int>(k) + 1), !vector["theorem_norms"][k].is_null());
      if (vector["theorem_norms"][k].is_null()) continue;
      EXPECT_NEAR(theorems.norms[k], vector["theorem_norms"][k].get<double>(), 1e-12);
    }
    EXPECT_NEAR(theorems.sides[0], vector["side"][0].get<double>(), 1e-12);
    EXPECT_NEAR(theorems.sides[1], vector["side"][1].get<double>(), 1e-12);
    EXPECT_EQ(theorems.covered, vector["printed_class"].get<int>());
  }
}

TEST(FourParameter, ClassesAreTheReferences) {
  for (const auto& [name, vector] : testing::reference("curves.json")["E_four_param"].items()) {
    SCOPED_TRACE(name);
    const FourParameters p = parameters_from(vector["lambda_mu_nu_omega"]);
    const subdivision::Convergence convergence = subdivision::classify(mask_of(p));
    EXPECT_EQ(convergence.sum_rules, vector["sum_rules"].get<int>());
    EXPECT_EQ(convergence.proven, vector["proven_class"].get<int>());
    EXPECT_EQ(convergence.excluded.value_or(-1),
              vector["excluded_class"].is_null() ? -1 : vector["excluded_class"].get<int>());
    EXPECT_NEAR(convergence.exponent_low, vector["holder"][0].get<double>(), 1e-9);
    EXPECT_NEAR(convergence.exponent_high, vector["holder"][1].get<double>(), 1e-9);
    // The reversed scheme is as smooth.
    const FourParameters reversed{p.mu, p.lambda, 1 - p.nu, p.omega};
    EXPECT_EQ(subdivision::classify(mask_of(reversed)).proven, convergence.proven);
    EXPECT_EQ(theorems_of(reversed).covered, theorems_of(p).covered);
  }
}

TEST(FourParameter, TheTableOfClassesLineByLine) {
  struct Row {
    FourParameters p;
    std::array<double, 3> norms;  ///< negative: not applicable
    std::array<double, 2> sides;
    int covered;
    int proven;
    int steps;
    int excluded;
    double low;
    double high;
  };
  const Row rows[] = {{{0, 0, 0.5, 1.0 / 16}, {0.625, 1, 1}, {0, 0}, 0, 1, 2, 2, 2, 2},
                      {{1.0 / 80, 1.0 / 16, 0.5, 1.0 / 32}, {0.6125, -1, -1}, {0.05, -0.25}, 0, 0, 1, 1, 0.909, 0.934},
                      {{1.0 / 16, 1.0 / 16, 0.5, 1.0 / 32}, {0.5625, 0.75, 0.75}, {0, 0}, 2, 2, 1, 3, 2.4150, 2.4150},
                      {{7.0 / 32, 7.0 / 32, 0.5, 3.0 / 64}, {0.59375, 1.25, -1}, {0, 0.75}, 0, 1, 2, 2, 1.670, 1.678},
                      {{7.0 / 32, 7.0 / 32, 0.5, -3.0 / 64}, {0.5, 0.5, 0.5}, {0, 0}, 2, 3, 1, 4, 3.842, 3.872},
                      {{1.0 / 30, 1.0 / 30, 0.5, 1.0 / 3}, {1.166667, 2.8, -1}, {0, 2.3}, -1, 0, 3, 1, 0.470, 0.515},
                      {{1.0 / 8, 1.0 / 8, 0.5, 0}, {0.5, 0.5, 0.5}, {0, 0}, 2, 2, 1, 3, 3, 3},
                      {{3.0 / 16, 3.0 / 16, 0.5, -1.0 / 32}, {0.5, 0.5, 0.5}, {0, 0}, 2, 4, 1, 5, 5, 5},
                      {{0, 0, 0.5, 0}, {0.5, 1, -1}, {0, -0.5}, 0, 0, 1, 1, 1, 1},
                      {{7.0 / 80, 3.0 / 80, 0.3, 1.0 / 32}, {0.5875, 0.75, 0.75}, {0, 0}, 2, 2, 1, 3, 2.4150, 2.4150},
                      {{0, 0, 0.5, -1.0 / 16}, {0.625, 1.5, -1}, {0, -1}, 0, 0, 1, 1, 0.706, 0.728},
                      {{0, 0, 0.5, 0.15}, {0.8, 1.2, -1}, {0, 0.7}, 0, 1, 2, 2, 1.191, 1.223},
                      {{0, 0, 0.5, 0.3}, {1.1, 2.4, -1}, {0, 1.9}, -1, 0, 2, 1, 0.554, 0.609},
                      {{0, 0, 0.5, 0.55}, {1.6, 4.4, -1}, {0, 3.9}, -1, -1, 0, 0, -0.139, -0.138},
                      {{0, 0, 0.5, -0.55}, {1.6, 5.4, -1}, {0, -4.9}, -1, -1, 0, 0, -0.183, -0.138}};
  for (const Row& row : rows) {
    SCOPED_TRACE(params_of(row.p).dump());
    const FourParameterTheorems theorems = theorems_of(row.p);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(theorems.applies(static_cast<int>(k) + 1), row.norms[k] >= 0);
      if (row.norms[k] < 0) continue;
      EXPECT_NEAR(theorems.norms[k], row.norms[k], 1e-6);
    }
    EXPECT_NEAR(theorems.sides[0], row.sides[0], 1e-12);
    EXPECT_NEAR(theorems.sides[1], row.sides[1], 1e-12);
    EXPECT_EQ(theorems.covered, row.covered);
    const subdivision::Convergence convergence = subdivision::classify(mask_of(row.p));
    EXPECT_EQ(convergence.proven, row.proven);
    EXPECT_EQ(convergence.steps, row.steps);
    EXPECT_EQ(convergence.excluded, row.excluded);
    EXPECT_NEAR(convergence.exponent_low, row.low, 6e-4);
    EXPECT_NEAR(convergence.exponent_high, row.high, 6e-4);
  }
}

TEST(FourParameter, TheoremsAreTheNormsOfTheDifferenceSchemes) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    FourParameters p = random_parameters(seed);
    // Half of them meet the first side condition, a quarter both.
    if (seed % 2 == 0) p.mu = p.lambda - 4 * p.omega * (1 - 2 * p.nu);
    if (seed % 4 == 0) p = {0.125 - 4 * p.omega * p.nu, 0.125 - 4 * p.omega * (1 - p.nu), p.nu, p.omega};
    const FourParameterTheorems theorems = theorems_of(p);
    std::vector<double> quotient = mask_of(p);
    for (int k = 1; k <= 3 && theorems.applies(k); ++k) {
      for (std::size_t i = 1; i < quotient.size(); ++i) quotient[i] -= quotient[i - 1];
      EXPECT_NEAR(quotient.back(), 0.0, 1e-12) << "1 + z divides";
      quotient.pop_back();
      const double norm = subdivision::norms_of_powers(quotient, 1)[0];
      EXPECT_NEAR(theorems.norms[static_cast<std::size_t>(k - 1)], norm * (1 << (k - 1)), 1e-12) << seed << ' ' << k;
    }
    EXPECT_EQ(theorems.applies(2), seed % 2 == 0) << seed;
  }
  // The C2 family with nu = 1/2: by Theorem 3 just for -3/16 < omega < 1/16.
  for (const auto& [omega, covered] : {std::pair{-0.1876, 0}, {-0.187, 2}, {-0.1, 2}, {0.06, 2}, {0.0626, 0}}) {
    EXPECT_EQ(theorems_of({0.125 - 2 * omega, 0.125 - 2 * omega, 0.5, omega}).covered, covered) << omega;
  }
  for (const double omega : {-0.06, -0.03, -0.001}) {
    EXPECT_GE(subdivision::classify(mask_of({0.125 - 2 * omega, 0.125 - 2 * omega, 0.5, omega})).proven, 3) << omega;
  }
}

/// The cardinal B-spline of this odd degree about 0, by truncated powers.
double b_spline(int degree, double x) {
  double sum = 0.0;
  double binomial = 1.0;
  for (int k = 0; k <= degree + 1; ++k) {
    const double from_knot = x + 0.5 * (degree + 1) - k;
    if (from_knot > 0) sum += (k % 2 == 0 ? 1 : -1) * binomial * std::pow(from_knot, degree);
    binomial *= static_cast<double>(degree + 1 - k) / (k + 1);
  }
  return sum / std::tgamma(degree + 1);
}

TEST(FourParameter, CubicAndQuinticSetsHitTheirSplines) {
  const Points base = random_points(21, 9);
  const auto spline = [&](int degree, double x) {
    Vec2 value;
    for (int j = -8; j < 24; ++j)
      value = value + b_spline(degree, x - j) * base[static_cast<std::size_t>((j + 18) % 9)];
    return value;
  };
  const auto check = [&](const FourParameters& p, int degree, const std::vector<double>& weights) {
    constexpr int levels = 4;
    const Points curve = drawn(base, p, levels, "closed");
    for (std::size_t k = 0; k < curve.size(); ++k) {
      // The spline's value at a knot of the refined polygon.
      Vec2 value;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        value = value + weights[i] * curve[(k + curve.size() + i - weights.size() / 2) % curve.size()];
      }
      EXPECT_LE(distance(value, spline(degree, static_cast<double>(k) / 16)), 1e-11) << degree << ' ' << k;
    }
  };
  check({0.125, 0.125, 0.5, 0}, 3, {1.0 / 6, 4.0 / 6, 1.0 / 6});
  check({0.1875, 0.1875, 0.5, -1.0 / 32}, 5, {1.0 / 120, 26.0 / 120, 66.0 / 120, 26.0 / 120, 1.0 / 120});
}

/// Where a curve of 1000 levels is at the parameters of its control points.
Points limits_at_control_points(const Points& base, const FourParameters& p) {
  return drawn(base, p, 1000, "closed", {.view = {Box2::everything(), 1e6}});
}

TEST(FourParameter, LimitsAtControlPoints) {
  const Points base = random_points(22, 8);
  const auto check = [&](const FourParameters& p, const std::vector<double>& phi) {
    const Points limits = limits_at_control_points(base, p);
    ASSERT_EQ(limits.size(), base.size());
    for (std::size_t i = 0; i < base.size(); ++i) {
      Vec2 expected;
      for (std::size_t k = 0; k < 5; ++k) expected = expected + phi[4 - k] * base[(i + 6 + k) % 8];
      EXPECT_LE(distance(limits[i], expected), 1e-12) << params_of(p).dump();
    }
  };
  for (const auto& [name, vector] : testing::reference("curves.json")["E_four_param"].items()) {
    if (!vector["phi"].is_null()) check(parameters_from(vector["lambda_mu_nu_omega"]), vector["phi"]);
  }
  check({1.0 / 16, 1.0 / 16, 0.5, 1.0 / 32}, {-1.0 / 312, 30.0 / 312, 254.0 / 312, 30.0 / 312, -1.0 / 312});
  // The closed form for lambda = mu, nu = 1/2.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double lambda = 0.3 * uniform(seed, 1);
    const double omega = 0.1 * uniform_symmetric(seed, 2);
    const double delta = 4 * lambda * lambda + 8 * lambda * omega - 3 * lambda - 2 * omega - 1;
    const double outer = 2 * lambda * omega / delta;
    const double next = 2 * lambda * (lambda - 1) / delta;
    const double middle = (4 * lambda * omega + lambda - 2 * omega - 1) / delta;
    check({lambda, lambda, 0.5, omega}, {outer, next, middle, next, outer});
  }
  // The cubic at a parameter of 1/2.
  const Points cubic = drawn(base, {0.125, 0.125, 0.5, 0}, 14, "closed");
  EXPECT_LE(distance(cubic[1 << 13], (1.0 / 48) * (base[7] + 23 * base[0] + 23 * base[1] + base[2])), 1e-7);
}

TEST(FourParameter, AffineMapsCarryTheCurveAndReversalExchangesTheSides) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Points base = random_points(seed, 7);
    const FourParameters p = random_parameters(seed);
    const Affine2 map = random_affine(seed);
    for (const char* ends : {"closed", "linear", "reflect", "replicate", "given"}) {
      expect_same(drawn(mapped(map, base), p, 5, ends), mapped(map, drawn(base, p, 5, ends)), ends);
      if (std::string(ends) == "closed") continue;
      expect_same(drawn(reversed(base), {p.mu, p.lambda, 1 - p.nu, p.omega}, 5, ends),
                  reversed(drawn(base, p, 5, ends)), ends);
    }
  }
}

TEST(FourParameter, LinesAreReproducedWithAShiftJustUnderTheC1Condition) {
  Points line;
  for (int i = 0; i < 9; ++i) line.push_back({static_cast<double>(i), 2.0 * i - 1});
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    FourParameters p = random_parameters(seed);
    const bool meets_condition = seed % 2 == 0;
    if (meets_condition) p.mu = p.lambda - 4 * p.omega * (1 - 2 * p.nu);
    const Points curve = drawn(line, p, 1, "given");
    double worst = 0.0;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      worst = std::max(worst, std::abs(curve[k].x - (1 + 0.5 * static_cast<double>(k) + p.mu - p.lambda)));
    }
    if (meets_condition) {
      EXPECT_LE(worst, 1e-13) << seed;
    } else {
      EXPECT_GT(worst, 1e-6) << seed;
    }
    // Whatever the parameters, points of a line stay on it.
    for (const Vec2 q : curve) EXPECT_NEAR(q.y, 2 * q.x - 1, 1e-12);
  }
}

TEST(FourParameter, NoPointLeavesTheBoundOfTheNorm) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const FourParameters p = random_parameters(seed);
    const double norm = subdivision::norms_of_powers(mask_of(p), 1)[0];
    EXPECT_NEAR(norm, std::max(1.0, 1 + 4 * p.omega), p.omega >= 0 ? 1e-12 : 10.0);
    const Points base = random_points(seed, 7);
    double farthest = 0.0;
    for (const Vec2 q : base) farthest = std::max(farthest, length(q));
    for (const Vec2 q : drawn(base, p, 3, "closed")) {
      ASSERT_LE(length(q), std::pow(norm, 3) * farthest * (1 + 1e-12)) << seed;
    }
  }
}

}  // namespace
}  // namespace burin::curves
