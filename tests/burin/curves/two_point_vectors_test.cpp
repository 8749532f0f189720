#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// Reference vectors for the two-point scheme: curves.json (A_generators and A_rules), and planepath.json, which has
/// the first points of curves as the Perl module Math::PlanePath computes them.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::draw_points;
using testing::expect_points;
using testing::expect_summary;
using testing::two_point;

json generator_marks(const json& generator) {
  json marks = json::array();
  for (std::size_t j = 0; j < generator["alpha"].size(); ++j) {
    marks.push_back({generator["alpha"][j], generator["beta"][j]});
  }
  return marks;
}

void expect_generator(const json& generator, json params) {
  for (int level = 1; level <= 3; ++level) {
    params["levels"] = level;
    expect_points(draw_points(two_point(params.dump())), generator["edge_0_1"][static_cast<std::size_t>(level - 1)]);
  }
  params["levels"] = generator["high_level"];
  expect_summary(draw_points(two_point(params.dump())), false, generator["high"]);
}

TEST(TwoPointVectors, TheNamedMotifsAreTheReferencesGenerators) {
  const json generators = testing::reference("curves.json")["A_generators"];
  for (const auto& [name, generator] : generators.items()) {
    SCOPED_TRACE(name);
    expect_generator(generator, {{"motif", name == "cesaro85" ? "cesaro" : name}});
  }
}

TEST(TwoPointVectors, ThePrintedVariantsGoByAName) {
  const json rules = testing::reference("curves.json")["A_rules"];
  const std::pair<const char*, const char*> names[] = {{"printed_koch_literal", "koch-printed"},
                                                       {"printed_minkowski_literal", "minkowski-printed"},
                                                       {"printed_dragon_literal", "dragon-printed"},
                                                       {"printed_dragon_rule", "dragon-printed-sign"}};
  for (const auto& [reference_name, name] : names) {
    SCOPED_TRACE(name);
    const json& rule = rules[reference_name];
    json params = {{"motif", name}};
    for (std::size_t level = 1; level <= rule["levels"].size(); ++level) {
      params["levels"] = level;
      expect_points(draw_points(two_point(params.dump())), rule["levels"][level - 1]);
    }
    params["levels"] = rule["high_level"];
    expect_summary(draw_points(two_point(params.dump())), false, rule["high"]);
  }
}

/// Whether a similarity carries one sequence of points into the other: the one that carries their ends, after a
/// reflection or not.
bool similar(const std::vector<Vec2>& points, const std::vector<Vec2>& expected, bool reflected) {
  const auto seen = [&](Vec2 p) { return reflected ? Vec2{p.x, -p.y} : p; };
  const Vec2 from = seen(points.back()) - seen(points.front());
  const Vec2 to = expected.back() - expected.front();
  // to / from, as complex numbers.
  const Vec2 factor = (1.0 / length_squared(from)) * Vec2{dot(from, to), cross(from, to)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 image = expected.front() + complex_product(factor, seen(points[i]) - seen(points.front()));
    if (distance(image, expected[i]) > 1e-9 * length(to)) return false;
  }
  return true;
}

TEST(TwoPointVectors, NamedMotifsAreTheCurvesOfMathPlanePath) {
  const json curves = testing::reference("planepath.json")["curves"];
  ASSERT_EQ(curves.size(), 29U);
  for (const auto& [name, curve] : curves.items()) {
    const json& flat = curve["points"];
    const double row_height = curve["triangular"].get<bool>() ? std::sqrt(3.0) : 1.0;
    std::vector<Vec2> expected;
    for (std::size_t i = 0; i < flat.size(); i += 2) {
      expected.push_back({flat[i].get<double>(), row_height * flat[i + 1].get<double>()});
    }
    for (const json& levels : curve["levels"]) {
      const std::vector<Vec2> points =
          draw_points(two_point(json({{"motif", curve["motif"]}, {"levels", levels}}).dump()));
      ASSERT_GE(points.size(), 2U) << name;
      ASSERT_LE(points.size(), expected.size()) << name;
      const std::vector<Vec2> begin(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(points.size()));
      EXPECT_TRUE(similar(points, begin, false) || similar(points, begin, true)) << name << " level " << levels;
    }
  }
}

TEST(TwoPointVectors, EveryGeneratorCanBeWrittenAsMarksWithFlags) {
  const json generators = testing::reference("curves.json")["A_generators"];
  ASSERT_EQ(generators.size(), 18U);
  for (const auto& [name, generator] : generators.items()) {
    SCOPED_TRACE(name);
    expect_generator(
        generator,
        {{"motif",
          {{"marks", generator_marks(generator)}, {"flip", generator["flip"]}, {"reverse", generator["rev"]}}}});
  }
}

TEST(TwoPointVectors, TurtleWordsAreTheReferencesGenerators) {
  const json generators = testing::reference("curves.json")["A_generators"];
  expect_generator(generators["quad18"], {{"motif", {{"turtle", "F+FF-FF-F-F+F+FF-F-F+F+FF+FF-F"}}}});
  expect_generator(generators["quad5"], {{"motif", {{"turtle", "F-F+F|-F-F"}}}});
  expect_generator(generators["gosper"], {{"motif", {{"turtle", "A-B--B+A++AA+B-"}, {"angle", 60}, {"reverse", "B"}}}});
  expect_generator(generators["pentadendrite"], {{"motif", {{"turtle", "F+F-F--F+F+F"}, {"angle", 72}}}});
}

TEST(TwoPointVectors, VerticesAreTheReferencesGenerators) {
  const json generators = testing::reference("curves.json")["A_generators"];
  expect_generator(generators["fret"], json::parse(R"({"motif": {"points":
      [[0, 0], [0, 3], [3, 3], [3, 1], [2, 1], [2, 2], [1, 2], [1, 0], [4, 0]]}})"));
  expect_generator(generators["peano9"], json::parse(R"({"motif": {"points":
      [[0, 0], [1, 1], [0, 2], [1, 3], [2, 2], [1, 1], [2, 0], [3, 1], [2, 2], [3, 3]],
      "flip": [0, 1, 0, 1, 0, 1, 0, 1, 0]}})"));
}

/// The sign rule of a case of A_rules in burin's words.
std::string sign_word(const std::string& reference_word) {
  if (reference_word == "const") return "constant";
  if (reference_word == "alt_i") return "edge";
  if (reference_word == "alt_m") return "level";
  if (reference_word == "alt_mi") return "level-edge";
  return "random";
}

json rule_motif(const json& rule) {
  if (rule.contains("alpha_by_level")) {
    json levels = json::array();
    for (std::size_t l = 0; l < rule["alpha_by_level"].size(); ++l) {
      levels.push_back(
          {{"marks", generator_marks({{"alpha", rule["alpha_by_level"][l]}, {"beta", rule["beta_by_level"][l]}})}});
    }
    return {{"by_level", levels}};
  }
  json motif = {{"marks", generator_marks(rule)}};
  if (rule.contains("absolute")) motif["beta"] = "absolute";
  if (rule.contains("decay")) motif["decay"] = rule["decay"];
  return motif;
}

TEST(TwoPointVectors, EverySignRuleIsTheReferences) {
  const json rules = testing::reference("curves.json")["A_rules"];
  ASSERT_EQ(rules.size(), 13U);
  for (const auto& [name, rule] : rules.items()) {
    SCOPED_TRACE(name);
    json params = {{"base", {{"points", rule["start"]}, {"closed", rule["closed"]}}},
                   {"motif", rule_motif(rule)},
                   {"sign", sign_word(rule["sign"])}};
    for (std::size_t level = 1; level <= rule["levels"].size(); ++level) {
      params["levels"] = level;
      expect_points(draw_points(two_point(params.dump()), 12345), rule["levels"][level - 1]);
    }
    params["levels"] = rule["high_level"];
    expect_summary(draw_points(two_point(params.dump()), 12345), rule["closed"], rule["high"]);
  }
}

}  // namespace
}  // namespace burin::curves
