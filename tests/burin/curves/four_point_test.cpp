#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/four_point.hpp>
#include <burin/curves/subdivision/convergence.hpp>

#include "naive_schemes.hpp"
#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// Closed forms of curves.md D, and its vectors.
namespace burin::curves {
namespace {

using namespace naive;
using nlohmann::json;
using testing::draw_points;
using testing::json_points;

constexpr const char* rules[] = {"linear", "reflect", "replicate"};

Points drawn(const Points& base, bool closed, double t, int levels, const std::string& ends = "linear") {
  return draw_points(
      "four-point",
      {{"base", {{"points", json_points(base)}, {"closed", closed}}}, {"t", t}, {"levels", levels}, {"ends", ends}});
}

void expect_same(const Points& actual, const Points& expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  const double tolerance = 1e-12 * size_of(expected);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_LE(distance(actual[i], expected[i]), tolerance) << what << " point " << i;
  }
}

double random_t(std::uint64_t seed) {
  return 1.2 * uniform_symmetric(seed, 9);
}

TEST(FourPoint, TheReferenceVectors) {
  for (const json& vector : testing::reference("curves.json")["D_four_point"]) {
    json params = {{"base", {{"points", vector["start"]}, {"closed", vector["closed"]}}}, {"t", vector["t"]}};
    if (!vector["closed"]) params["ends"] = vector["ends"];
    SCOPED_TRACE(params.dump());
    for (std::size_t level = 1; level <= vector["levels"].size(); ++level) {
      params["levels"] = level;
      testing::expect_points(draw_points("four-point", params), vector["levels"][level - 1]);
    }
    params["levels"] = vector["high_level"];
    testing::expect_summary(draw_points("four-point", params), vector["closed"], vector["high"]);
    params.erase("t");
    params["w"] = vector["w"];
    testing::expect_summary(draw_points("four-point", params), vector["closed"], vector["high"]);
  }
}

TEST(FourPoint, IsTheSchemeLevelByLevel) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Points base = random_points(seed, 2 + seed % 6);
    const double t = random_t(seed);
    const int levels = static_cast<int>(seed % 11);
    for (const bool closed : {false, true}) {
      const std::string ends = rules[seed % 3];
      Points expected = base;
      for (int level = 0; level < levels; ++level) expected = four_point(expected, t, closed, ends);
      expect_same(drawn(base, closed, t, levels, ends), expected, "seed " + std::to_string(seed) + ends);
    }
  }
}

TEST(FourPoint, ALevelKeepsThePointsOfTheOneBeforeBitForBit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Points base = random_points(seed, 5);
    for (const bool closed : {false, true}) {
      for (int level = 1; level <= 10; ++level) {
        const Points coarse = drawn(base, closed, random_t(seed), level - 1, rules[seed % 3]);
        const Points fine = drawn(base, closed, random_t(seed), level, rules[seed % 3]);
        ASSERT_EQ(fine.size(), closed ? 2 * coarse.size() : 2 * coarse.size() - 1);
        for (std::size_t i = 0; i < coarse.size(); ++i) ASSERT_EQ(fine[2 * i], coarse[i]);
      }
    }
  }
}

TEST(FourPoint, LinesAreReproducedForEveryTAndCubicsForMinusOneEighthOnly) {
  const auto worst_error = [](double t, int degree) {
    Points base;
    const auto value = [&](double x) { return std::pow(x, degree); };
    for (int i = 0; i <= 12; ++i) base.push_back({static_cast<double>(i), value(i)});
    const Points curve = drawn(base, false, t, 4);
    double worst = 0.0;
    // Away from the ends, whose ghosts lie on lines.
    for (std::size_t i = 16 * 4; i <= 16 * 8; ++i) {
      const double x = static_cast<double>(i) / 16;
      worst = std::max(worst, distance(curve[i], {x, value(x)}));
    }
    return worst;
  };
  for (const double t : {-0.8, -0.3, -0.125, 0.0, 0.2, 0.7}) {
    EXPECT_LE(worst_error(t, 1), 1e-12) << t;
    for (const int degree : {2, 3}) {
      if (t == -0.125) {
        EXPECT_LE(worst_error(t, degree), 1e-10);
      } else {
        EXPECT_GE(worst_error(t, degree), 1e-3) << t << " degree " << degree;
      }
    }
  }
  // With linear ghosts a line is kept up to its ends.
  const Points line = drawn({{0, 1}, {1, 3}, {2, 5}}, false, 0.6, 5);
  for (const Vec2 p : line) EXPECT_NEAR(p.y, 1 + 2 * p.x, 1e-13);
}

TEST(FourPoint, IsTheFourParameterSchemeOfOmegaW) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Points base = random_points(seed, 6);
    const double t = random_t(seed);
    const Points other = draw_points("four-parameter", {{"base", {{"points", json_points(base)}, {"closed", true}}},
                                                        {"lambda", 0},
                                                        {"mu", 0},
                                                        {"nu", 0.5},
                                                        {"omega", -0.5 * t},
                                                        {"levels", 6}});
    expect_same(drawn(base, true, t, 6), other, "seed " + std::to_string(seed));
  }
}

TEST(FourPoint, AffineMapsCarryTheCurveAndReversalReversesIt) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Points base = random_points(seed, 5);
    const Affine2 map = random_affine(seed);
    const std::string ends = rules[seed % 3];
    const double t = random_t(seed);
    for (const bool closed : {false, true}) {
      expect_same(drawn(mapped(map, base), closed, t, 6, ends), mapped(map, drawn(base, closed, t, 6, ends)), "mapped");
    }
    expect_same(drawn(reversed(base), false, t, 6, ends), reversed(drawn(base, false, t, 6, ends)), "reversed");
    Points closed_reversed = reversed(drawn(base, true, t, 6));
    std::rotate(closed_reversed.begin(), closed_reversed.begin() + 63, closed_reversed.end());
    expect_same(drawn(reversed(base), true, t, 6), closed_reversed, "closed");
  }
}

TEST(FourPoint, WhereItConverges) {
  const auto mask = [](double w) { return std::vector{-w, 0.0, 0.5 + w, 1.0, 0.5 + w, 0.0, -w}; };
  for (const double w : {-0.45, -0.3, -0.1, 0.2, 0.45}) EXPECT_GE(subdivision::classify(mask(w)).proven, 0) << w;
  for (const double w : {-0.6, -0.51, 0.51, 0.6}) EXPECT_EQ(subdivision::classify(mask(w)).excluded, 0) << w;
  // C1 for 0 < w < w*, 32 w*^3 + 4 w* - 1 = 0; proven up to 0.18 by powers up to 12.
  for (const double w : {0.01, 0.0625, 0.1, 0.1545, 0.18}) EXPECT_GE(subdivision::classify(mask(w)).proven, 1) << w;
  for (const double w : {-0.2, -0.001, 0.1928, 0.3}) EXPECT_EQ(subdivision::classify(mask(w)).excluded, 1) << w;
  EXPECT_NE(subdivision::classify(mask(0.1927)).excluded, 1);
  // One step never proves C1; two do up to (sqrt 5 - 1)/8.
  const auto second = [](double w) { return std::vector{-2 * w, 4 * w, 1 - 4 * w, 4 * w, -2 * w}; };
  for (const double w : {-0.3, 0.01, 0.125, 0.2}) EXPECT_GE(subdivision::norms_of_powers(second(w), 1)[0], 1 - 1e-12);
  EXPECT_NEAR(subdivision::norms_of_powers(second((std::sqrt(5.0) - 1) / 8), 2)[1], 1.0, 1e-12);
}

TEST(FourPoint, ContradictionsAreReported) {
  EXPECT_EQ(testing::read_params("four-point", R"({"t": 0.3, "w": 1})").problems.size(), 1U);
  EXPECT_EQ(testing::read_params("four-point", R"({"ends": "given"})").problems.size(), 1U);
}

}  // namespace
}  // namespace burin::curves
