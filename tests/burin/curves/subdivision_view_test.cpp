#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>

#include "naive_schemes.hpp"
#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// What the subdivision families promise under a view, and of their boxes.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::draw_points;

struct Case {
  std::string family;
  json params;
};

/// Smooth, fractal, one-sided, divergent, with every rule for ends; `levels` is left to the test.
std::vector<Case> cases() {
  const json open = {{"points", testing::json_points(naive::random_points(31, 6))}};
  const json closed = {{"points", testing::json_points(naive::random_points(32, 5))}, {"closed", true}};
  return {
      {"de-rham", {{"t", 0.25}, {"base", closed}}},
      {"de-rham", {{"t", 0.4}, {"base", open}, {"ends", "clamp"}}},
      {"de-rham", {{"t", 0.1}, {"base", open}}},
      {"de-rham", {{"t", 0.7}, {"base", closed}}},
      {"de-rham", {{"t", 0.6}, {"base", open}, {"ends", "clamp"}}},
      {"de-rham", {{"t", -0.2}, {"base", closed}}},
      {"de-rham", {{"t", -0.2}, {"base", open}, {"normalize", true}}},
      {"four-point", {{"base", closed}}},
      {"four-point", {{"base", open}}},
      {"four-point", {{"t", 0.4}, {"base", open}, {"ends", "reflect"}}},
      {"four-point", {{"t", -0.6}, {"base", open}, {"ends", "replicate"}}},
      {"four-parameter", {{"lambda", 0.125}, {"mu", 0.125}, {"omega", 0}, {"base", closed}}},
      {"four-parameter", {{"lambda", "7/80"}, {"mu", "3/80"}, {"nu", 0.3}, {"omega", "1/32"}, {"base", open}}},
      {"four-parameter", {{"lambda", 0.3}, {"mu", 0.1}, {"nu", 0.1}, {"omega", 0.0625}, {"base", open}}},
      {"four-parameter", {{"lambda", "1/80"}, {"mu", "1/16"}, {"omega", "1/32"}, {"base", open}, {"ends", "given"}}},
      {"four-parameter", {{"lambda", "1/30"}, {"mu", "1/30"}, {"omega", "1/3"}, {"base", closed}}}};
}

json at_level(json params, int levels) {
  params["levels"] = levels;
  return params;
}

double to_chord(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t = length_squared(d) > 0 ? std::clamp(dot(p - a, d) / length_squared(d), 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

TEST(SubdivisionView, HidesNothingLargerThanItsTolerance) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.family + c.params.dump());
    const json params = at_level(c.params, 7);
    const bool closed = c.params["base"].contains("closed");
    const std::vector<Vec2> full = draw_points(c.family, params);
    for (const double tolerance : {0.5, 0.05, 0.005}) {
      for (std::uint64_t trial = 0; trial < 3; ++trial) {
        View view{Box2::everything(), tolerance};
        if (trial > 0) {
          const Vec2 centre = full[random_bits(7, trial) % full.size()];
          view.box = Box2{centre, centre}.grown(2.0 * uniform(8, trial));
        }
        const std::vector<Vec2> seen = draw_points(c.family, params, {.view = view});
        // Both go round in the same order: every point seen is the next one of its kind.
        std::size_t at = 0;
        for (std::size_t i = 0; i + 1 < seen.size() + (closed ? 1U : 0U); ++i) {
          while (at < full.size() && full[at] != seen[i]) ++at;
          ASSERT_LT(at, full.size());
          const Vec2 next = seen[(i + 1) % seen.size()];
          const bool last = i + 1 == seen.size();
          for (std::size_t k = at + 1; k < full.size() && (last || full[k] != next); ++k) {
            if (!view.box.contains(full[k])) continue;
            ASSERT_LE(to_chord(full[k], seen[i], next), tolerance) << i << ' ' << k;
          }
          ++at;
        }
      }
    }
  }
}

TEST(SubdivisionView, ForecastsAreExactUnderAView) {
  for (const Case& c : cases()) {
    const json params = at_level(c.params, 8);
    const Family& family = *find_family(c.family);
    const std::any read = *testing::read_params(c.family, params.dump()).params;
    for (const double tolerance : {0.3, 0.003}) {
      const DrawContext context{.view = {Box2{{-1, -1}, {1, 2}}, tolerance}, .origin = {0.3, 0.2}};
      const Forecast forecast = family.forecast(read, context, 1e9);
      EXPECT_EQ(forecast.points, static_cast<double>(testing::record(c.family, read, context).all_points().size()));
      EXPECT_TRUE(forecast.exact);
      const Forecast cut = family.forecast(read, context, 3);
      EXPECT_FALSE(cut.exact);
      EXPECT_GT(cut.points, 3);
    }
  }
}

TEST(SubdivisionView, LevelsBeyondAllNumbersCostWhatIsSeen) {
  for (const Case& c : cases()) {
    if (c.params.value("t", 0.0) == -0.2) continue;  // grows, or goes to and fro, with every level
    const json params = at_level(c.params, 1000);
    SCOPED_TRACE(params.dump());
    const Family& family = *find_family(c.family);
    const std::any read = *testing::read_params(c.family, params.dump()).params;
    const std::optional<Box2> box = family.bounds(read, {}, {});
    ASSERT_TRUE(box.has_value());
    const DrawContext context{.view = {*box, 0.02}};
    const Forecast forecast = family.forecast(read, context, 1e7);
    EXPECT_TRUE(forecast.exact);
    EXPECT_GT(forecast.asked_points, 1e300);
    EXPECT_LT(forecast.points, 1e5);
    const std::vector<Vec2> points = draw_points(c.family, params, context);
    EXPECT_EQ(forecast.points, static_cast<double>(points.size()));
    for (const Vec2 p : points) ASSERT_TRUE(box->grown(1e-9).contains(p));
  }
}

TEST(SubdivisionView, SmoothCurvesNeedFewPointsWhateverTheirLevel) {
  // A circle-like curve within a thousandth: the chords' sagitta counts, not their length.
  for (const Case& c : {Case{"de-rham", {{"t", 0.25}}}, Case{"de-rham", {{"t", 0.3}}}, Case{"four-point", {}},
                        Case{"four-parameter", {{"lambda", 0.125}, {"mu", 0.125}, {"omega", 0}}}}) {
    json params = at_level(c.params, 1000);
    const std::vector<Vec2> points = draw_points(c.family, params, {.view = {Box2::everything(), 1e-3}});
    EXPECT_LT(points.size(), 400U) << c.family << params.dump();
    EXPECT_GT(points.size(), 16U) << c.family << params.dump();
  }
}

TEST(SubdivisionView, AZoomCostsWhatItShows) {
  for (const Case& c : cases()) {
    if (c.params.value("t", 0.0) == -0.2) continue;
    const json params = at_level(c.params, 200);
    SCOPED_TRACE(params.dump());
    const std::vector<Vec2> coarse = draw_points(c.family, params, {.view = {Box2::everything(), 0.01}});
    const Vec2 target = coarse[coarse.size() / 3];
    for (const double zoom : {1e3, 1e6, 1e9}) {
      // Counted from the target, where numbers are finest.
      const DrawContext context{.view = {Box2{{0, 0}, {0, 0}}.grown(0.5 / zoom), 1e-2 / zoom}, .origin = target};
      const std::vector<Vec2> seen = draw_points(c.family, params, context);
      std::size_t inside = 0;
      for (const Vec2 p : seen) inside += context.view.box.contains(p) ? 1U : 0U;
      EXPECT_GE(inside, 1U) << zoom;
      EXPECT_LT(seen.size(), 50'000U) << zoom;
    }
  }
}

TEST(SubdivisionView, BoxesAreThoseOfTheReplay) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::vector<Case> all = cases();
    Case c = all[seed % all.size()];
    c.params["base"]["points"] = testing::json_points(naive::random_points(seed, 6));
    c.params["levels"] = seed % 9;
    const Affine2 frame = naive::random_affine(seed);
    Box2 replayed;
    for (const Vec2 p : draw_points(c.family, c.params)) replayed.add(frame(p));
    const std::any read = *testing::read_params(c.family, c.params.dump()).params;
    const std::optional<Box2> box = find_family(c.family)->bounds(read, {}, frame);
    ASSERT_TRUE(box.has_value());
    const double tolerance = 1e-12 * (1 + replayed.width() + replayed.height());
    EXPECT_NEAR(box->low.x, replayed.low.x, tolerance) << c.family << c.params.dump();
    EXPECT_NEAR(box->low.y, replayed.low.y, tolerance) << c.family << c.params.dump();
    EXPECT_NEAR(box->high.x, replayed.high.x, tolerance) << c.family << c.params.dump();
    EXPECT_NEAR(box->high.y, replayed.high.y, tolerance) << c.family << c.params.dump();
  }
}

TEST(SubdivisionView, WhatGrowsBeyondNumbersHasNoBox) {
  const auto box = [](const std::string& family, const char* params) {
    return find_family(family)->bounds(*testing::read_params(family, params).params, {}, {});
  };
  EXPECT_FALSE(box("de-rham", R"({"t": -5, "levels": 1000})").has_value());
  EXPECT_FALSE(box("four-point", R"({"t": 3, "levels": 1000})").has_value());
  EXPECT_TRUE(box("de-rham", R"({"t": -0.2, "levels": 6})").has_value());
}

}  // namespace
}  // namespace burin::curves
