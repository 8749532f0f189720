#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/curves/two_point/automaton.hpp>
#include <burin/curves/two_point/block_tables.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::curves {
namespace {

using nlohmann::json;
using testing::draw_points;
using testing::two_point;

Box2 box_of(const TwoPointParams& params, const Affine2& frame = {}, std::uint64_t seed = 0) {
  const std::optional<Box2> box = find_family("two-point")->bounds(params, {.seed = seed}, frame);
  EXPECT_TRUE(box.has_value());
  return box.value_or(Box2{});
}

void expect_near(const Box2& actual, const Box2& expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(actual.low.x, expected.low.x, tolerance) << what;
  EXPECT_NEAR(actual.low.y, expected.low.y, tolerance) << what;
  EXPECT_NEAR(actual.high.x, expected.high.x, tolerance) << what;
  EXPECT_NEAR(actual.high.y, expected.high.y, tolerance) << what;
}

Box2 box_from(const json& bbox) {
  return {{bbox[0], bbox[1]}, {bbox[2], bbox[3]}};
}

json generator_params(const json& generator, int levels) {
  json marks = json::array();
  for (std::size_t j = 0; j < generator["alpha"].size(); ++j)
    marks.push_back({generator["alpha"][j], generator["beta"][j]});
  return {{"levels", levels},
          {"motif", {{"marks", marks}, {"flip", generator["flip"]}, {"reverse", generator["rev"]}}}};
}

TEST(TwoPointBounds, LimitBoxesAreTheReferences) {
  const json generators = testing::reference("curves.json")["A_generators"];
  for (const auto& [name, generator] : generators.items()) {
    if (generator["bbox_kind"] != "exact") continue;
    expect_near(box_of(two_point(generator_params(generator, 1000).dump())), box_from(generator["bbox"]), 1e-9, name);
  }
}

TEST(TwoPointBounds, TheCullingRadiusLiesWithinTheReferencesBounds) {
  const json generators = testing::reference("curves.json")["A_generators"];
  for (const auto& [name, generator] : generators.items()) {
    const TwoPointParams params = two_point(generator_params(generator, 1).dump());
    const two_point::BlockTables tables = two_point::make_block_tables(*two_point::make_automaton(params.motif, {}));
    EXPECT_GE(tables.reach, generator["disc_lower"].get<double>() - 1e-12) << name;
    EXPECT_LE(tables.reach, generator["disc1"].get<double>() * (1 + 1e-6)) << name;
  }
}

TEST(TwoPointBounds, WhatAnEdgeGeneratesLiesWithinTheDeviationFromIt) {
  const json generators = testing::reference("curves.json")["A_generators"];
  for (const auto& [name, generator] : generators.items()) {
    const TwoPointParams params = two_point(generator_params(generator, 5).dump());
    const two_point::BlockTables tables = two_point::make_block_tables(*two_point::make_automaton(params.motif, {}));
    double farthest = 0.0;
    for (const Vec2 p : draw_points(params)) {
      farthest = std::max(farthest, distance(p, {std::clamp(p.x, 0.0, 1.0), 0.0}));
    }
    EXPECT_LE(farthest, tables.deviation) << name;
    EXPECT_LE(tables.deviation, tables.reach) << name;
    if (name == "koch") {
      EXPECT_NEAR(tables.deviation, std::sqrt(3.0) / 6.0, 3e-3);
    }
  }
}

/// A motif with contracting sub-edges, drawn from a seed.
json random_motif(std::uint64_t seed) {
  const std::size_t marks_count = 1 + random_bits(seed, 1) % 5;
  json marks = json::array();
  json flip = json::array();
  json reverse = json::array();
  Vec2 before{0, 0};
  const auto far = [&](Vec2 p) { return distance(before, p) > 0.95; };
  for (std::size_t j = 0; j < marks_count; ++j) {
    Vec2 p;
    std::uint64_t trial = 0;
    do {
      p = {-0.3 + 1.6 * uniform(seed, 2, j, trial), 0.7 * uniform_symmetric(seed, 3, j, trial)};
      ++trial;
    } while (far(p) || (j + 1 == marks_count && distance(p, {1, 0}) > 0.95));
    marks.push_back({p.x, p.y});
    before = p;
  }
  for (std::size_t j = 0; j <= marks_count; ++j) {
    flip.push_back(random_bits(seed, 4, j) % 2);
    reverse.push_back(random_bits(seed, 5, j) % 2);
  }
  return {{"marks", marks}, {"flip", flip}, {"reverse", reverse}};
}

TEST(TwoPointBounds, BranchAndBoundIsTheBoxOfTheReplay) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const json motif = random_motif(seed);
    const auto levels = static_cast<int>(random_bits(seed, 6) % 5);
    const char* bases[] = {"segment", "triangle", "square"};
    const TwoPointParams params =
        two_point(json{{"motif", motif}, {"levels", levels}, {"base", bases[seed % 3]}}.dump());
    const Affine2 frame = scaling(seed % 2 == 0 ? -2.0 : 1.0, 1.5) * rotation_degrees(360 * uniform(seed, 7));
    Box2 replayed;
    for (const Vec2 p : draw_points(params)) replayed.add(frame(p));
    expect_near(box_of(params, frame), replayed, 1e-12, "seed " + std::to_string(seed) + ' ' + motif.dump());
  }
}

TEST(TwoPointBounds, NothingLeavesTheCullingDisc) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const TwoPointParams params = two_point(json{{"motif", random_motif(seed)}, {"levels", 4}}.dump());
    const two_point::BlockTables tables = two_point::make_block_tables(*two_point::make_automaton(params.motif, {}));
    for (const Vec2 p : draw_points(params)) ASSERT_LE(distance(p, {0.5, 0}), tables.reach) << seed;
  }
}

TEST(TwoPointBounds, TheGeneralRuleIsBoundedToo) {
  const char* cases[] = {
      R"({"motif": "koch", "sign": "random", "levels": 6, "base": "triangle"})",
      R"({"motif": {"marks": [[0.3, {"random": [0, 0.3]}], [{"random": [0.5, 0.7]}, -0.1]]}, "levels": 6})",
      R"({"motif": {"marks": [[0.3, 0.5], [0.6, -0.25]], "beta": "absolute", "decay": 0.5}, "sign": "edge", "levels": 6})",
      R"({"motif": {"marks": [[0.5, 0.4]], "decay": 0.8}, "sign": "level", "levels": 10})",
      R"({"motif": {"marks": [["1/3", 0], [0.5, 0.2], ["2/3", 0]], "beta": "absolute", "decay": 0.3}, "levels": 5})",
      // No bound is known for an expression: the curve is run through.
      R"j({"motif": {"marks": [[0.5, "0.3*sin(edge)"]]}, "levels": 8})j",
      // Nor for a motif that grows.
      R"({"motif": {"marks": [[0.5, 2]]}, "levels": 6})"};
  for (const char* text : cases) {
    const TwoPointParams params = two_point(text);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Box2 replayed;
      for (const Vec2 p : draw_points(params, seed)) replayed.add(p);
      expect_near(box_of(params, {}, seed), replayed, 1e-12, text);
    }
  }
}

TEST(TwoPointBounds, DeepRandomCurvesHaveBoxes) {
  const TwoPointParams params = two_point(R"({"motif": "koch", "sign": "random", "levels": 1000})");
  const Box2 deep = box_of(params, {}, 12345);
  Box2 replayed;
  for (const Vec2 p : draw_points(two_point(R"({"motif": "koch", "sign": "random", "levels": 9})"), 12345))
    replayed.add(p);
  expect_near(deep, replayed, 1e-4, "random koch");
}

TEST(TwoPointBounds, WhatCannotBeBoundedIsRefused) {
  const Family& family = *find_family("two-point");
  // 2^200 points and no bound.
  EXPECT_FALSE(
      family.bounds(two_point(R"({"motif": {"marks": [[0.5, "0.1*rand"]]}, "levels": 200})"), {}, {}).has_value());
  EXPECT_FALSE(family.bounds(two_point(R"({"motif": {"marks": [[0.5, 1e9]]}, "levels": 1000})"), {}, {}).has_value());
  // Beyond the range of numbers.
  EXPECT_FALSE(family.bounds(two_point(R"({"motif": {"marks": [[0.5, 1e200]]}, "levels": 4})"), {}, {}).has_value());
  const char* not_a_number = R"j({"motif": {"marks": [[0.5, "sqrt(-level)"]]}, "levels": 2})j";
  EXPECT_FALSE(family.bounds(two_point(not_a_number), {}, {}).has_value());
}

}  // namespace
}  // namespace burin::curves
