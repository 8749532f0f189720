#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/path/decorators.hpp>

#include "made_data.hpp"
#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::curves {
namespace {

using fractal_interpolation::level_set;
using fractal_interpolation::make_interpolant;
using fractal_interpolation::plain_data;
using fractal_interpolation::with_scaling;

constexpr const char* family_name = "fractal-interpolation";

std::any params_of(const std::string& json, const ReadFile& files = {}) {
  const testing::ReadParams read = testing::read_params(family_name, json, files);
  EXPECT_TRUE(read.params.has_value()) << json << '\n' << problems_text(read.problems);
  return read.params.value_or(std::any());
}

std::vector<Vec2> drawn(const std::string& json, const DrawContext& context = {}) {
  return testing::record(family_name, params_of(json), context).all_points();
}

std::string problem_of(const std::string& json, const ReadFile& files = {}) {
  const testing::ReadParams read = testing::read_params(family_name, json, files);
  EXPECT_FALSE(read.params.has_value()) << json;
  return problems_text(read.problems);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string five = R"("points": [[0, 0], [0.25, 0.8], [0.5, 0.2], [0.75, 1], [1, 0.3]])";

TEST(FractalFamily, DrawsTheLevelSets) {
  const auto data = with_scaling(plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.8, 0.2, 1.0, 0.3}),
                                 fractal_interpolation::constant_scaling(0.6));
  for (int level = 0; level <= 4; ++level) {
    const std::vector<Vec2> points =
        drawn("{" + five + R"(, "scaling": 0.6, "levels": )" + std::to_string(level) + "}");
    EXPECT_EQ(points, level_set(make_interpolant(data), level)) << level;
  }
}

TEST(FractalFamily, FiveNodesBecomeSeventeenPoints) {
  EXPECT_EQ(drawn("{" + five + R"(, "levels": 1})").size(), 17U);  // the paper's Fig. 1
}

TEST(FractalFamily, ALevelKeepsThePointsOfTheOneBefore) {
  const auto every = [](const std::string& json) { return find_family(family_name)->retained_every(params_of(json)); };
  const std::string json = "{" + five + R"(, "scaling": 0.6, "levels": )";
  const std::vector<Vec2> before = drawn(json + "2}");
  const std::vector<Vec2> points = drawn(json + "3}");
  ASSERT_EQ(every(json + "3}"), 4U);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(points[4 * k].y, before[k].y, 1e-14);
  EXPECT_EQ(every(json + "0}"), 0U);
  EXPECT_EQ(every(json + R"(3, "block": 2})"), 2U);
  EXPECT_EQ(every(json + R"(3, "part": [0.1, 0.9]})"), 0U);
}

TEST(FractalFamily, AViewShowsASubsetToTheBitAndMissesNothing) {
  const std::string json = "{" + five + R"(, "scaling": [0.6, -0.4, [0.3, 0.2], 0.5], "levels": 6})";
  const std::vector<Vec2> all = drawn(json);
  std::set<std::pair<double, double>> known;
  for (const Vec2 p : all) known.insert({p.x, p.y});
  const View view{{{0.3, 0.2}, {0.45, 0.9}}, 0.002};
  const std::vector<Vec2> seen = drawn(json, {.view = view});
  EXPECT_LT(seen.size(), all.size() / 3);
  for (const Vec2 p : seen) EXPECT_TRUE(known.count({p.x, p.y}) == 1) << p.x;
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; }));
  // Every point of the full run in the view lies near the seen polyline.
  std::size_t segment = 0;
  for (const Vec2 p : all) {
    if (!view.box.contains(p)) continue;
    while (seen[segment + 1].x < p.x) ++segment;
    const Vec2 a = seen[segment];
    const Vec2 b = seen[segment + 1];
    const bool narrow = b.x - a.x <= view.tolerance;
    EXPECT_TRUE(narrow || std::abs(lerp(a, b, (p.x - a.x) / (b.x - a.x)).y - p.y) <= view.tolerance) << p.x;
  }
  EXPECT_EQ(find_family(family_name)->forecast(params_of(json), {.view = view}, 1e9).points,
            static_cast<double>(seen.size()));
}

TEST(FractalFamily, DeepZoomCostsWhatIsSeen) {
  const std::string json = "{" + five + R"(, "scaling": 0.5, "levels": 1000})";
  const double x = 0.3712;
  const double y =
      value_at(make_interpolant(with_scaling(plain_data({0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 0.8, 0.2, 1.0, 0.3}),
                                             fractal_interpolation::constant_scaling(0.5))),
               x);
  for (const double size : {1e-2, 1e-4, 1e-6}) {
    const View view{Box2{{x, y}, {x, y}}.grown(size), size / 1000.0};
    const std::vector<Vec2> seen = drawn(json, {.view = view});
    EXPECT_LT(seen.size(), 30000U) << size;
    EXPECT_GT(std::count_if(seen.begin(), seen.end(), [&](Vec2 p) { return view.box.contains(p); }), 0) << size;
  }
}

TEST(FractalFamily, ContoursCloseAndKeepToTheirNodes) {
  const std::string square =
      R"({"points": [[0, 0], [2, 0], [2, 1], [0, 1]], "closed": true, "scaling": 0.3, "levels": )";
  EXPECT_EQ(drawn(square + "0}"), (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  const Recording curve = testing::record(family_name, params_of(square + "3}"));
  EXPECT_TRUE(curve.paths().front().head.closed);
  EXPECT_EQ(curve.all_points().size(), 256U);
  EXPECT_EQ(curve.all_points()[128], (Vec2{2, 1}));
  // Smooth in both coordinates as long as s < a: then x and y may differ in all they have.
  const std::vector<Vec2> own = drawn(
      R"({"points": [[0, 0], [1, 0], [1, 1]], "over": "chords", "x": {"scaling": 0.2, "alpha": 5}, "levels": 2})");
  EXPECT_EQ(own.size(), 9U);
}

TEST(FractalFamily, BlocksAreFractalsOfTheirOwn) {
  const std::string points = R"({"points": [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0], [5, 1], [6, 0]], "scaling": 0.4)";
  const std::vector<Vec2> blocks = drawn(points + R"(, "block": 2, "levels": 1})");
  EXPECT_EQ(blocks.size(), 13U);
  EXPECT_EQ(blocks[4], (Vec2{2, 0}));
  // A rest of one interval joins the last block.
  EXPECT_EQ(drawn(points + R"(, "block": 5, "levels": 1})").size(), 37U);
  EXPECT_EQ(drawn(points + R"(, "block": 4, "levels": 1})").size(), 21U);
}

TEST(FractalFamily, PartsAreCutOutOfTheWhole) {
  const std::string json = "{" + five + R"(, "scaling": 0.5, "levels": 3)";
  const std::vector<Vec2> all = drawn(json + "}");
  std::vector<Vec2> expected;
  for (const Vec2 p : all) {
    if (p.x >= 0.3 && p.x <= 0.6) expected.push_back(p);
  }
  EXPECT_EQ(drawn(json + R"(, "part": [0.3, 0.6]})"), expected);
  EXPECT_TRUE(drawn(json + R"(, "part": [0.3001, 0.3002]})").empty());
}

TEST(FractalFamily, BoundsHoldWhereNoReplayIsPossible) {
  for (const char* scaling : {"0.7", "[[0.3, 0.2], 0.5, -0.6, 0.1]"}) {
    const std::string json = "{" + five + R"(, "scaling": )" + scaling + R"(, "levels": )";
    const Affine2 frame{};
    const std::optional<Box2> exact = find_family(family_name)->bounds(params_of(json + "7}"), {}, frame);
    const std::optional<Box2> safe = find_family(family_name)->bounds(params_of(json + "900}"), {}, frame);
    ASSERT_TRUE(exact && safe);
    EXPECT_LE(safe->low.y, exact->low.y);
    EXPECT_GE(safe->high.y, exact->high.y);
    EXPECT_LT(safe->height(), 1.2 * exact->height());
    EXPECT_EQ(safe->low.x, 0.0);
    EXPECT_EQ(safe->high.x, 1.0);
  }
}

TEST(FractalFamily, PlotsNodesErrorsAndPerturbations) {
  const std::string sine = R"({"points": [[0.1, 0.0998], [0.2, 0.1987], [0.3, 0.2955], [0.4, 0.3894], [0.5, 0.4794]],
      "scaling": 0.02, "levels": 2, "alpha": [1, 1, 0.002, 0.01], "beta": [0.8, 0.8, 0.004, 0.04])";
  const std::vector<Vec2> curve = drawn(sine + "}");
  const std::vector<Vec2> error = drawn(sine + R"json(, "plot": "error", "exact": "sin(x)", "stretch": 100})json");
  ASSERT_EQ(error.size(), curve.size());
  for (std::size_t k = 0; k < curve.size(); ++k) {
    EXPECT_NEAR(error[k].y, 100.0 * (math::sin(curve[k].x) - curve[k].y), 1e-12);
  }
  const Recording nodes = testing::record(family_name, params_of(sine + R"(, "plot": "nodes"})"));
  EXPECT_EQ(nodes.paths().size(), 5U);
  EXPECT_EQ(nodes.all_points()[4], (Vec2{0.5, 0.4794}));
  const std::vector<Vec2> change =
      drawn(sine + R"(, "plot": "perturbation", "perturbation": [0.002, -0.001, 0.0015, -0.002, 0.001]})");
  std::string moved = sine;
  for (const auto& [from, to] :
       {std::pair{"0.0998", "0.1018"}, std::pair{"0.1987", "0.1977"}, std::pair{"0.2955", "0.297"},
        std::pair{"0.3894", "0.3874"}, std::pair{"0.4794", "0.4804"}}) {
    moved.replace(moved.find(from), 6, to);
  }
  const std::vector<Vec2> star = drawn(moved + "}");
  for (std::size_t k = 0; k < curve.size(); ++k) EXPECT_NEAR(change[k].y, curve[k].y - star[k].y, 1e-12);
}

TEST(FractalFamily, SplineAndGivenDerivatives) {
  const std::vector<Vec2> spline = drawn(R"({"points": [[0, 0], [1, 1], [2, 8], [3, 27]], "derivatives": "spline"})");
  for (const Vec2 p : spline) EXPECT_NEAR(p.y, p.x * p.x * p.x, 1e-11);
  const std::vector<Vec2> given =
      drawn(R"({"points": [[0, 0], [1, 1], [2, 8], [3, 27]], "derivatives": [0, 3, 12, 27]})");
  for (const Vec2 p : given) EXPECT_NEAR(p.y, p.x * p.x * p.x, 1e-11);
}

TEST(FractalFamily, ReadsDataOfManyKinds) {
  const auto with = [](const std::string& text) {
    return [text](std::string_view) -> Result<std::string> { return text; };
  };
  const std::string json = R"({"data": "d.csv", "levels": 0})";
  for (const char* text : {"0,1\n1,3\n2,2\n", "x,y\r\n0,1\r\n1,3\r\n2,2\r\n", "y;x\n1;0\n3;1\n2;2\n",
                           "\xEF\xBB\xBF# a note\n0 1\n1 3\n1 3\n2 2"}) {
    EXPECT_EQ(testing::record(family_name, params_of(json, with(text))).all_points(),
              (std::vector<Vec2>{{0, 1}, {1, 3}, {2, 2}}))
        << text;
  }
  EXPECT_TRUE(has(problem_of(json, with("x,y\n0,1\n2,2\n1,3\n")), "d.csv:4:1: error: x must increase")) << "unsorted";
  EXPECT_TRUE(has(problem_of(json, with("0,1\n0,2\n1,3\n")), "d.csv:2:1: error: x must increase")) << "upright";
  EXPECT_TRUE(
      has(problem_of(json, with("0,1\n")), "d.csv: error: a fractal interpolation needs at least 3 points, found 1"));
  EXPECT_TRUE(has(problem_of(json, with("0,1\n1,nan\n2,3\n")), "d.csv:2:3: error: expected a number"));
  EXPECT_TRUE(has(problem_of(json, with("")), "has no points"));
}

TEST(FractalFamily, RefusesBadParametersWithAdvice) {
  const std::string json = "{" + five;
  EXPECT_TRUE(has(problem_of("{}"), "exactly one of 'points' and 'data'"));
  EXPECT_TRUE(has(problem_of(json + R"(, "scaling": 1})"), "must stay below 1"));
  EXPECT_TRUE(has(problem_of(json + R"(, "scaling": [[0.6, -0.4]]})"), "interval 1 may reach 1 "));
  EXPECT_TRUE(has(problem_of(json + R"(, "scaling": {"sine": [0.1, 0.2]}})"), "'sine' takes 4 numbers, not 2"));
  EXPECT_TRUE(has(problem_of(json + R"(, "scaling": {}})"), "exactly one of"));
  EXPECT_TRUE(has(problem_of(json + R"(, "scaling": []})"), "empty"));
  EXPECT_TRUE(has(problem_of(json + R"(, "alpha": -1})"), "'alpha' of interval 1 is -1; it must be 0 or more"));
  EXPECT_TRUE(has(problem_of(json + R"(, "alpha": [1, 2, 3]})"), "'alpha' has 3 entries for 4 intervals"));
  EXPECT_TRUE(has(problem_of(json + R"(, "derivatives": [1, 2]})"), "'derivatives' has 2 numbers for 5 points"));
  EXPECT_TRUE(has(problem_of(json + R"(, "closed": true, "over": "x"})"), "cannot be closed"));
  EXPECT_TRUE(has(problem_of(json + R"(, "at": [0, 1]})"), "over = \"chords\""));
  EXPECT_TRUE(has(problem_of(json + R"(, "over": "chords", "at": [0, 1]})"), "'at' has 2 numbers for 5 points"));
  EXPECT_TRUE(has(problem_of(json + R"(, "over": "chords", "at": [0, 2, 1, 3, 4]})"), "must increase"));
  EXPECT_TRUE(has(problem_of(json + R"(, "fit": "rational-function"})"), "'fit' needs 'intervals'"));
  EXPECT_TRUE(has(problem_of(json + R"(, "intervals": 9})"), "9 intervals need more than 5 points"));
  EXPECT_TRUE(has(problem_of(json + R"(, "plot": "error"})"), "'exact'"));
  EXPECT_TRUE(has(problem_of(json + R"json(, "plot": "error", "exact": "sin(z)"})json"), "z"));
  EXPECT_TRUE(has(problem_of(json + R"(, "plot": "perturbation"})"), "'perturbation'"));
  EXPECT_TRUE(has(problem_of(json + R"(, "part": [0.5, 0.5]})"), "from < to"));
  EXPECT_TRUE(has(problem_of(R"({"points": [[0, 0], [1, 1], [1, 1]]})"), "at least 3 points, found 2"));
}

}  // namespace
}  // namespace burin::curves
