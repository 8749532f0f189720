#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

namespace burin::preset {
namespace {

const ReadFile no_files = [](std::string_view) -> Result<std::string> { return Problem{{}, "no files"}; };

Result<Plan> try_plan(const std::string& body, const Overrides& overrides = {}) {
  Result<Piece> piece = load({"test.toml", "burin = 1\n" + body}, overrides, no_files);
  if (!piece) return piece.problems();
  return Plan::make(*std::move(piece));
}

Plan plan_of(const std::string& body, const Overrides& overrides = {}) {
  Result<Plan> plan = try_plan(body, overrides);
  if (!plan) throw std::runtime_error(problems_text(plan.problems()));
  return *std::move(plan);
}

Recording run(const Plan& plan, const RunOptions& options = {}) {
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(plan.run(checked, options), Flow::go);
  return recorder.take();
}

constexpr const char* square_page = "page = { size = \"100x100mm\", margin = \"10mm\" }\n";
constexpr const char* thin_pen = "pens = { ink = { color = \"black\", width = \"2mm\" } }\n";

/// A page of 100 x 100 mm with margins of 10 mm and a pen of 2 mm, then `rest`.
std::string piece(const std::string& rest) {
  return square_page + std::string(thin_pen) + rest;
}

const std::string koch = "[[layer]]\ncurve = { family = \"two-point\", levels = 4 }\n";

void expect_box(const Box2& actual, const Box2& expected) {
  EXPECT_NEAR(actual.low.x, expected.low.x, 1e-9);
  EXPECT_NEAR(actual.low.y, expected.low.y, 1e-9);
  EXPECT_NEAR(actual.high.x, expected.high.x, 1e-9);
  EXPECT_NEAR(actual.high.y, expected.high.y, 1e-9);
}

TEST(Plan, TheInkFillsTheLiveAreaUpToHalfAPen) {
  const Box2 box = run(plan_of(piece(koch))).bounds();
  const double height = 78 * std::sqrt(3.0) / 6;
  expect_box(box, {{11, 50 - height / 2}, {89, 50 + height / 2}});
}

TEST(Plan, YRunsDownOnThePageAndUpInTheModel) {
  const Plan plan = plan_of(piece(koch));
  // The koch motif bumps to the right of travel: down in the model, so down on the page, where y is larger.
  const Recording page = run(plan);
  EXPECT_GT(page.bounds().high.y, page.all_points().front().y);
  const Recording model = run(plan, {.space = Space::model});
  expect_box(model.bounds(), {{0, -std::sqrt(3.0) / 6}, {1, 0}});
}

TEST(Plan, ASlotHasOneFitForAllItsLayers) {
  const Recording drawn = run(plan_of(
      piece("[[layer]]\ncurve = { family = \"two-point\", levels = 0 }\n"
            "[[layer]]\ncurve = { family = \"two-point\", levels = 0, base = { points = [[1, 0], [2, 0]] } }\n")));
  ASSERT_EQ(drawn.paths().size(), 2U);
  EXPECT_NEAR(drawn.all_points()[0].x, 11, 1e-12);
  EXPECT_NEAR(drawn.all_points()[1].x, 50, 1e-12);
  EXPECT_NEAR(drawn.all_points()[3].x, 89, 1e-12);
  EXPECT_EQ(drawn.paths()[1].head.layer, 1U);
}

TEST(Plan, FillsComeUnderTheirStrokes) {
  const Plan plan =
      plan_of(square_page + std::string("[pens]\nink = { color = \"black\" }\nwash = { color = \"red\" }\n") +
              "[[layer]]\ncurve = { family = \"two-point\", base = \"square\", levels = 0 }\nfill = \"wash\"\nrule = "
              "\"evenodd\"\n"
              "[[layer]]\ncurve = { family = \"two-point\", base = \"square\", levels = 0 }\nfill = \"wash\"\nstroke = "
              "\"none\"\n");
  ASSERT_EQ(plan.sheet().layers.size(), 3U);
  EXPECT_EQ(plan.sheet().layers[0].paint, Paint::fill_evenodd);
  EXPECT_EQ(plan.sheet().layers[0].pen, 1U);
  EXPECT_EQ(plan.sheet().layers[1].paint, Paint::stroke);
  EXPECT_EQ(plan.sheet().layers[1].pen, 0U);
  EXPECT_EQ(plan.sheet().layers[2].paint, Paint::fill_nonzero);
  const Recording drawn = run(plan);
  ASSERT_EQ(drawn.paths().size(), 3U);
  EXPECT_EQ(drawn.paths()[0].head.paint, Paint::fill_evenodd);
  EXPECT_TRUE(drawn.paths()[0].head.closed);
}

TEST(Plan, BandsSplitALayerByPenAndLoseNothing) {
  const std::string pens = "[pens]\nink = { color = \"black\" }\nred = { color = \"red\" }\n";
  const auto length_of = [](const Recording& recording) {
    double sum = 0;
    for (const Recording::Path& path : recording.paths()) {
      for (const Recording::Contour& contour : recording.contours(path)) {
        const std::span<const Vec2> p = recording.points(contour);
        for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += distance(p[i], p[i + 1]);
      }
    }
    return sum;
  };
  const Plan banded =
      plan_of(square_page + pens + koch + "pen = { by = \"pr\", at = [20], of = [\"ink\", \"red\"] }\n");
  ASSERT_EQ(banded.sheet().layers.size(), 2U);
  EXPECT_EQ(layer_label(banded.sheet(), 0), "1 ink 0.3");
  EXPECT_EQ(layer_label(banded.sheet(), 1), "2 red 0.3");
  const Plan plain = plan_of(square_page + pens + koch);
  EXPECT_NEAR(length_of(run(banded)), length_of(run(plain)), 1e-6);
  const Recording inner = run(banded, {.wanted = [](const SheetLayer& layer) { return layer.pen == 0; }});
  for (const Vec2 p : inner.all_points()) EXPECT_LE(distance(p, {50, 50}), 20 + 1e-6);
}

TEST(Plan, CopiesOfAGridHaveTheirOwnSeedsAndSymmetricOnesShareThem) {
  const std::string random =
      "[[layer]]\nslot = \"s\"\ncurve = { family = \"two-point\", levels = 3, sign = \"random\" }\n";
  const Recording grid = run(plan_of(piece("[slots]\ns = { grid = [2, 1] }\n" + random)), {.space = Space::model});
  const std::vector<Vec2>& points = grid.all_points();
  const std::size_t half = points.size() / 2;
  EXPECT_NE(std::vector(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half)),
            std::vector(points.begin() + static_cast<std::ptrdiff_t>(half), points.end()));
  const Recording rosette =
      run(plan_of(piece("[slots]\ns = { symmetry = \"c2\" }\n" + random)), {.space = Space::model});
  for (std::size_t i = 0; i < half; ++i) {
    EXPECT_NEAR(rosette.all_points()[i].x, -rosette.all_points()[i + half].x, 1e-12);
    EXPECT_NEAR(rosette.all_points()[i].y, -rosette.all_points()[i + half].y, 1e-12);
  }
}

TEST(Plan, ALayersSeedChangesItAlone) {
  const std::string layer = "[[layer]]\ncurve = { family = \"two-point\", levels = 3, sign = \"random\" }\n";
  const auto lengths = [&](const std::string& second) {
    return run(plan_of(piece(layer + layer + second)), {.space = Space::model}).all_points();
  };
  const std::vector<Vec2> same = lengths("");
  const std::vector<Vec2> mixed = lengths("seed = 5\n");
  const std::size_t half = same.size() / 2;
  for (std::size_t i = 0; i < half; ++i) EXPECT_EQ(same[i], same[i + half]);
  EXPECT_TRUE(std::equal(same.begin(), same.begin() + static_cast<std::ptrdiff_t>(half), mixed.begin()));
  EXPECT_NE(same, mixed);
}

TEST(Plan, TheSeedChangesThePictureAndNothingElseDoes) {
  const std::string random = piece("[[layer]]\ncurve = { family = \"two-point\", levels = 3, sign = \"random\" }\n");
  EXPECT_TRUE(plan_of(random).uses_seed());
  EXPECT_FALSE(plan_of(piece(koch)).uses_seed());
  EXPECT_TRUE(plan_of(piece("[knobs]\nturn = { random = [0, 90] }\n[slots]\ns = { rotate = \"$turn\" }\n" + koch +
                            "slot = \"s\"\n"))
                  .uses_seed());
  const auto drawn = [&](std::uint64_t seed) {
    Overrides overrides;
    overrides.seed = seed;
    return run(plan_of(random, overrides), {.space = Space::model}).all_points();
  };
  EXPECT_EQ(drawn(3), drawn(3));
  EXPECT_NE(drawn(3), drawn(4));
}

TEST(Plan, TheForecastIsWhatIsDrawn) {
  for (const std::string& body :
       {piece(koch), piece("[slots]\ns = { grid = [3, 2], symmetry = \"d3\" }\n" + koch + "slot = \"s\"\n")}) {
    const Plan plan = plan_of(body);
    for (const double tolerance : {0.0, 0.05, 1.0}) {
      const RunOptions options{.tolerance_mm = tolerance};
      const Forecast forecast = plan.forecast(options, 1e9);
      EXPECT_TRUE(forecast.exact);
      EXPECT_EQ(forecast.points, static_cast<double>(run(plan, options).all_points().size()));
    }
  }
}

TEST(Plan, TooMuchIsRefusedBeforeTheWork) {
  const Plan plan = plan_of(piece("[[layer]]\nname = \"deep\"\ncurve = { family = \"two-point\", levels = 200 }\n"));
  const Result<Forecast> refused = plan.check_size({}, 5e7);
  ASSERT_FALSE(refused.ok());
  const Problem& problem = refused.problems().front();
  EXPECT_EQ(problem.trouble, Trouble::limit);
  EXPECT_NE(problem.message.find("layer 'deep'"), std::string::npos) << problem.message;
  EXPECT_NE(problem.message.find("'levels'"), std::string::npos) << problem.message;
  EXPECT_NE(problem.message.find("--max-points"), std::string::npos) << problem.message;
  EXPECT_GT(problem.where.line, 0);
  EXPECT_TRUE(plan.check_size({.tolerance_mm = 0.1}, 5e7).ok());
}

TEST(Plan, ACurveWithoutBoundsIsRefusedWithItsKnob) {
  const Result<Plan> plan = try_plan(
      piece("[[layer]]\ncurve = { family = \"two-point\", levels = 60, motif = { marks = [[0.5, \"0.1*rand\"]] } }\n"));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.problems().front().trouble, Trouble::limit);
  EXPECT_NE(plan.problems().front().message.find("lower 'levels'"), std::string::npos);
  const Result<Plan> huge = try_plan(
      piece("[[layer]]\ncurve = { family = \"two-point\", levels = 4, motif = { marks = [[0.5, 1e200]] } }\n"));
  ASSERT_FALSE(huge.ok());
  EXPECT_EQ(huge.problems().front().trouble, Trouble::input);
}

TEST(Plan, NumbersTooLargeOrSmallToMapAreRefused) {
  const std::string koch_of = "curve = { family = \"two-point\", levels = 1000";
  for (const std::string& text :
       {"[[layer]]\n" + koch_of + ", base = { points = [[1e300, 0], [-1e300, 0]] } }\n",
        "[[layer]]\n" + koch_of + ", base = { points = [[0, 0], [1e-300, 0]] } }\n",
        "[slots]\ns = { scale = \"1e-200mm\" }\n[[layer]]\nslot = \"s\"\n" + koch_of + " }\n",
        "[slots]\ns = { scale = \"1e200mm\" }\n[[layer]]\nslot = \"s\"\n" + koch_of + " }\n",
        "[slots]\ns = { frame = [-1e300, 0, 1e300, 1] }\n[[layer]]\nslot = \"s\"\n" + koch_of + " }\n"}) {
    const Result<Plan> plan = try_plan(piece(text));
    ASSERT_FALSE(plan.ok()) << text;
    const Problem& problem = plan.problems().front();
    EXPECT_EQ(problem.trouble, Trouble::input) << text;
    EXPECT_NE(problem.message.find("mm for a model unit are outside"), std::string::npos) << problem.message;
    EXPECT_GT(problem.where.line, 0) << text;
  }
}

TEST(Plan, ASlotThatCannotBePlacedIsOneProblem) {
  const std::string wild = "curve = { family = \"two-point\", levels = 4, motif = { marks = [[0.5, 1e200]] } }\n";
  const Result<Plan> unbounded = try_plan(piece(koch + "[[layer]]\nname = \"wild\"\n" + wild));
  ASSERT_FALSE(unbounded.ok());
  ASSERT_EQ(unbounded.problems().size(), 1U);
  EXPECT_NE(unbounded.problems().front().message.find("layer 'wild'"), std::string::npos);
  EXPECT_NE(unbounded.problems().front().message.find("not a number"), std::string::npos);

  // A slot that is too small is not blamed on the levels.
  const Result<Plan> small = try_plan(
      "page = { size = \"a4\" }\npens = { ink = { width = \"99mm\" } }\nslots = { s = { at = \"0 0 50mm 50mm\" } }\n"
      "[[layer]]\nslot = \"s\"\ncurve = { family = \"two-point\", levels = 1000 }\n");
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.problems().front().trouble, Trouble::input);
  EXPECT_NE(small.problems().front().message.find("too small to draw in with a pen of 99 mm"), std::string::npos);
}

TEST(Plan, AStopEndsItEarly) {
  const Plan plan = plan_of(piece("[[layer]]\ncurve = { family = \"two-point\", levels = 12 }\n"));
  std::stop_source stop;
  stop.request_stop();
  Recorder recorder;
  EXPECT_EQ(plan.run(recorder, {.stop = stop.get_token()}), Flow::stop);
  EXPECT_TRUE(recorder.recording().empty());
}

TEST(Plan, ThePenShrinksTheFitOfItsSlotAlone) {
  const Plan plan = plan_of(
      square_page +
      std::string(
          "[pens]\nink = { color = \"black\", width = \"1mm\" }\nbroad = { color = \"black\", width = \"4mm\" }\n"
          "[slots]\nleft = { at = \"0 0 50% 100%\" }\nright = { at = \"50% 0 50% 100%\" }\n"
          "[[layer]]\nslot = \"left\"\ncurve = { family = \"two-point\", levels = 0 }\n"
          "[[layer]]\nslot = \"right\"\npen = \"broad\"\ncurve = { family = \"two-point\", levels = 0 }\n"));
  const std::vector<Vec2> points = run(plan).all_points();
  EXPECT_NEAR(points[0].x, 10.5, 1e-12);
  EXPECT_NEAR(points[1].x, 49.5, 1e-12);
  EXPECT_NEAR(points[2].x, 52, 1e-12);
  EXPECT_NEAR(points[3].x, 88, 1e-12);
}

}  // namespace
}  // namespace burin::preset
