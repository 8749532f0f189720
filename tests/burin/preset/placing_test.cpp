#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "plan_text.hpp"

/// Figures along curves and layered drawing, from the preset's text to what is drawn on the page.
namespace burin::preset {
namespace {

/// box.svg is a square around its anchor; flag.svg, a mast of length 1 from its anchor with a triangle to its right,
/// has no symmetry.
const ReadFile figures = [](std::string_view name) -> Result<std::string> {
  const std::string head =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\">";
  const std::string style = " fill=\"none\" stroke=\"black\"/>";
  if (name == "box.svg") return head + "<path d=\"M0 0H10V10H0Z\"" + style + "</svg>";
  if (name == "flag.svg") {
    return head + "<path d=\"M5 10V0\"" + style + "<path d=\"M5 0L9 2L5 4Z\"" + style +
           "<path id=\"anchor\" d=\"M5 10V9\"" + style + "</svg>";
  }
  return Problem{{}, "no file '" + std::string(name) + "'"};
};

const std::string page =
    "burin = 1\npage = { size = \"100x100mm\", margin = \"10mm\" }\npens = { ink = { width = \"2mm\" }, red = { color "
    "= "
    "\"red\", width = \"0.5mm\" } }\n";

Plan plan_of(const std::string& text) {
  return plan_text(page + text, figures);
}

std::string complaint(const std::string& text) {
  return first_complaint(page + text, figures);
}

std::string layer(const std::string& curve, const std::string& placing, const std::string& more = "") {
  return "[[layer]]\ncurve = { family = \"two-point\", " + curve + " }\nprimitives = { " + placing + " }\n" + more +
         "\n";
}

/// What is placed, and on which sheet layer and level.
struct Placed {
  LayerId layer = 0;
  int level = 0;
  Affine2 at;
};

class PlacedSink final : public PathSink {
 public:
  Flow begin(const PathHead&) override { return Flow::stop; }
  Flow points(std::span<const Vec2>) override { return Flow::stop; }
  Flow contour() override { return Flow::stop; }
  Flow end() override { return Flow::stop; }
  Flow place(const PathHead& head, const Figure&, const Affine2& at) override {
    placed.push_back({head.layer, head.level, at});
    return Flow::go;
  }
  std::vector<Placed> placed;
};

std::vector<Placed> placed_by(const Plan& plan, const RunOptions& options = {}) {
  PlacedSink sink;
  EXPECT_EQ(plan.run(sink, options), Flow::go);
  return sink.placed;
}

Recording run(const Plan& plan, const RunOptions& options = {}) {
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(plan.run(checked, options), Flow::go);
  return recorder.take();
}

TEST(Primitives, FiguresKeepTheirMillimetresAndTheFitCountsThem) {
  // Squares of 12 mm about the ends of a line, and half a pen of 2 mm: the line itself is left 80 - 2 - 12 mm.
  const Plan plan = plan_of(layer("levels = 0", "use = \"box.svg\", scale = 12"));
  const Box2 box = run(plan).bounds();
  EXPECT_NEAR(box.low.x, 11, 1e-4);
  EXPECT_NEAR(box.high.x, 89, 1e-4);
  EXPECT_NEAR(box.height(), 12, 1e-9);
  const std::vector<Placed> placed = placed_by(plan);
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_NEAR(placed[0].at.scale(), 12, 1e-9);
  EXPECT_NEAR(distance(placed[0].at({}), placed[1].at({})), 66, 1e-3);
  EXPECT_EQ(plan.sheet().pens[0].width_mm, 2.0);
}

TEST(Primitives, TheFitFollowsFiguresOfEverySizeAndPlace) {
  for (const char* placing : {"use = \"flag.svg\", scale = \"0.4*length\", rotate = \"normal\"",
                              "use = \"flag.svg\", scale = \"lerp(4, 14, u)\", rotate = \"tangent\", every = \"3mm\"",
                              "use = \"flag.svg\", scale = \"20*0.5^level\", rotate = \"random\", jitter = \"5mm\"",
                              "use = \"box.svg\", scale = 3, when = \"x < 0.4\"",
                              "use = [\"flag.svg\", \"box.svg\"], scale = 25, every = 40"}) {
    const Box2 box = run(plan_of(layer("levels = 3", placing))).bounds();
    const double size = std::max(box.width(), box.height());
    // Figures that step along a line in millimetres come and go with the scale, and the fit jumps.
    const double slack = std::string(placing).find("every = \"") == std::string::npos ? 1e-3 : 4;
    EXPECT_LE(size, 78 + 1e-3) << placing;
    EXPECT_GE(size, 78 - slack) << placing;
    EXPECT_NEAR(box.center().x, 50, std::max(1e-3, 0.02 * slack)) << placing;
    EXPECT_NEAR(box.center().y, 50, std::max(1e-3, 0.02 * slack)) << placing;
  }
}

TEST(Primitives, APinnedSlotKeepsItsScaleAndCentresWhatIsDrawn) {
  const std::string slot = "slots = { top = { scale = \"20mm\" } }\n";
  const Plan plan =
      plan_of(slot + layer("levels = 0", "use = \"flag.svg\", scale = 10, when = \"x > 0.5\"", "slot = \"top\""));
  const std::vector<Placed> placed = placed_by(plan);
  ASSERT_EQ(placed.size(), 1U);
  const Box2 box = run(plan).bounds();
  EXPECT_NEAR(box.height(), 10, 1e-9);
  EXPECT_NEAR(box.center().y, 50, 1e-9);
}

TEST(Primitives, MirroredCopiesMirrorTheirFigures) {
  const std::string slot = "slots = { top = { symmetry = \"d6\" } }\n";
  const Plan plan =
      plan_of(slot + layer("levels = 3, base = { points = [[0.2, 0.1], [1, 0.3]] }",
                           "use = \"flag.svg\", every = \"4mm\", rotate = \"tangent + 20\", scale = \"5 + "
                           "2*rand\", jitter = \"1mm\", mirror = \"random\"",
                           "slot = \"top\""));
  const Recording drawn = run(plan);
  const Vec2 centre = drawn.bounds().center();
  std::vector<Vec2> sorted = drawn.all_points();
  const auto has = [&](Vec2 p) { return std::ranges::any_of(sorted, [&](Vec2 q) { return distance(p, q) < 1e-9; }); };
  // Every point's mirror images and turns are points as well.
  for (std::size_t i = 0; i < sorted.size(); i += 97) {
    const Vec2 p = sorted[i] - centre;
    EXPECT_TRUE(has(centre + Vec2{-p.x, p.y}));
    EXPECT_TRUE(has(centre + Vec2{p.x, -p.y}));
    EXPECT_TRUE(has(centre + rotation_degrees(60).linear(p)));
  }
}

TEST(Primitives, NoViewLeavesOutAnyOfThem) {
  const Plan plan = plan_of(layer("levels = 7", "use = \"box.svg\", scale = 0.1"));
  EXPECT_EQ(placed_by(plan).size(), 16385U);
  EXPECT_EQ(placed_by(plan, {.tolerance_mm = 1.0}).size(), 16385U);
}

TEST(Primitives, TheForecastIsExactOrABound) {
  const auto forecast = [](const std::string& placing, bool exact) {
    const Plan plan = plan_of(layer("levels = 5", placing));
    const double drawn = static_cast<double>(run(plan).all_points().size());
    const Forecast made = plan.forecast({}, 1e9);
    EXPECT_EQ(made.exact, exact) << placing;
    EXPECT_GE(made.points, drawn);
    if (exact) {
      EXPECT_EQ(made.points, drawn);
    }
    return made.points;
  };
  EXPECT_EQ(forecast("use = \"box.svg\"", true), 1025.0 * 4);
  forecast("use = \"box.svg\", rotate = \"random\", jitter = 1", true);
  forecast("use = \"box.svg\", every = \"2mm\"", true);
  forecast("use = \"box.svg\", every = 3", true);
  forecast("use = [\"box.svg\", \"flag.svg\"]", false);
  forecast("use = \"box.svg\", when = \"x - 0.5\"", false);
  forecast("use = \"box.svg\", mode = \"new\"", false);
}

TEST(Primitives, TooManyAreRefusedAndFewEnoughAreCounted) {
  const Plan plan = plan_of(layer("levels = 6", "use = \"box.svg\", scale = 1"));
  const Result<Forecast> refused = plan.check_size({}, 16000);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.problems().front().message.find("asks for 16,388 points"), std::string::npos)
      << refused.problems().front().message;
  // A bound that is too high is no reason to refuse: the figures are counted.
  const Plan sparse = plan_of(layer("levels = 6", "use = \"box.svg\", scale = 1, apart = \"5mm\""));
  EXPECT_TRUE(sparse.check_size({}, 16000).ok());
  EXPECT_NE(complaint(layer("motif = \"dragon\", levels = 30", "use = \"box.svg\"")).find("lower 'levels'"),
            std::string::npos);
}

TEST(Primitives, FillsFillTheFiguresAreas) {
  const Plan plan = plan_of(layer("levels = 0", "use = \"flag.svg\", scale = 10", "fill = \"red\""));
  ASSERT_EQ(plan.sheet().layers.size(), 2U);
  const Recording drawn = run(plan);
  std::size_t fills = 0;
  for (const Recording::Path& path : drawn.paths()) {
    EXPECT_EQ(path.head.layer == 0, path.head.paint != Paint::stroke);
    fills += path.head.layer == 0 ? 1 : 0;
  }
  EXPECT_EQ(fills, 2U);  // of each flag its triangle, not its mast
  EXPECT_EQ(drawn.paths().size(), 6U);
}

TEST(Primitives, PensShareOutTheFigures) {
  const Plan bands = plan_of(layer("levels = 4", "use = \"box.svg\", scale = 1, apart = \"2mm\"",
                                   "pen = { by = \"px\", at = [-10, 10], of = [\"ink\", \"none\", \"red\"] }"));
  const Plan plain = plan_of(layer("levels = 4", "use = \"box.svg\", scale = 1, apart = \"2mm\""));
  EXPECT_EQ(bands.sheet().layers.size(), 2U);
  std::size_t ink = 0;
  std::size_t red = 0;
  for (const Placed& each : placed_by(bands)) {
    const double px = each.at({}).x - 50;
    EXPECT_TRUE(each.layer == 0 ? px < -10 : px >= 10);
    ++(each.layer == 0 ? ink : red);
  }
  const std::vector<Placed> all = placed_by(plain);
  const auto in_the_middle =
      std::ranges::count_if(all, [](const Placed& each) { return std::abs(each.at({}).x - 50) < 10; });
  EXPECT_NEAR(static_cast<double>(ink + red), static_cast<double>(all.size() - static_cast<std::size_t>(in_the_middle)),
              1);
  EXPECT_GT(red, 5U);
}

TEST(Primitives, DoNotHangOnThreads) {
  const Plan plan = plan_of(layer("levels = 4", "use = \"flag.svg\", scale = \"lerp(2, 4, u)\", rotate = \"random\""));
  EXPECT_EQ(run(plan).all_points(), run(plan).all_points());
  EXPECT_TRUE(plan.uses_seed());
  EXPECT_FALSE(plan_of(layer("levels = 4", "use = \"flag.svg\"")).uses_seed());
}

TEST(Primitives, SaysWhatIsWrong) {
  EXPECT_EQ(complaint(layer("levels = 1", "use = \"none.svg\"")), "p.toml:6:23: error: no file 'none.svg'");
  EXPECT_EQ(complaint(layer("levels = 1", "evry = 3")),
            "p.toml:6:16: error: 'primitives': unknown key 'evry' in primitives; did you mean 'every'?");
}

std::vector<std::size_t> counts_by_level(const std::vector<Placed>& placed) {
  std::vector<std::size_t> counts;
  for (const Placed& each : placed) {
    counts.resize(std::max(counts.size(), static_cast<std::size_t>(each.level) + 1));
    ++counts[static_cast<std::size_t>(each.level)];
  }
  return counts;
}

TEST(Levels, AllAndNewDrawEveryLevelInOrder) {
  const auto counts = [](const std::string& base, const std::string& mode) {
    const std::vector<Placed> placed =
        placed_by(plan_of(layer("base = \"" + base + "\", levels = \"0..4\"", "use = \"box.svg\", scale = 1" + mode)));
    EXPECT_TRUE(std::ranges::is_sorted(placed, {}, &Placed::level));
    return counts_by_level(placed);
  };
  EXPECT_EQ(counts("segment", ""), (std::vector<std::size_t>{2, 5, 17, 65, 257}));
  EXPECT_EQ(counts("segment", ", mode = \"new\""), (std::vector<std::size_t>{2, 3, 12, 48, 192}));
  EXPECT_EQ(counts("square", ", mode = \"new\""), (std::vector<std::size_t>{4, 12, 48, 192, 768}));
}

TEST(Levels, LinesAreDrawnOneOverTheOther) {
  const Plan plan = plan_of("[[layer]]\ncurve = { family = \"two-point\", levels = \"1..3\" }\n");
  const Recording drawn = run(plan);
  ASSERT_EQ(drawn.paths().size(), 3U);
  EXPECT_EQ(drawn.all_points().size(), 5U + 17U + 65U);
  EXPECT_EQ(drawn.paths()[0].head.level, 1);
  EXPECT_EQ(drawn.paths()[2].head.level, 3);
  const Forecast forecast = plan.forecast({}, 1e9);
  EXPECT_EQ(forecast.points, 87.0);
  EXPECT_TRUE(forecast.exact);
}

TEST(Levels, ListsTakeTurnsLevelByLevel) {
  const Plan plan =
      plan_of(layer("levels = \"1..4\"", "use = [\"box.svg\", \"none\"], scale = [\"1mm\", \"2mm\", \"3mm\"]",
                    "pen = [\"ink\", \"red\"]"));
  ASSERT_EQ(plan.sheet().layers.size(), 2U);
  for (const Placed& each : placed_by(plan)) {
    EXPECT_EQ(each.level % 2, 1);  // levels 2 and 4 have no figure
    EXPECT_EQ(each.layer, 0U);     // and were the red pen's
    EXPECT_NEAR(each.at.scale(), each.level == 1 ? 1.0 : 3.0, 1e-9);
  }
  const Plan lines =
      plan_of("[[layer]]\ncurve = { family = \"two-point\", levels = \"0..3\" }\npen = [\"ink\", \"red\"]\n");
  std::set<std::pair<LayerId, int>> drawn;
  const Recording recorded = run(lines);
  for (const Recording::Path& path : recorded.paths()) drawn.emplace(path.head.layer, path.head.level);
  EXPECT_EQ(drawn, (std::set<std::pair<LayerId, int>>{{0, 0}, {0, 2}, {1, 1}, {1, 3}}));
  EXPECT_EQ(lines.forecast({}, 1e9).points, 2.0 + 5 + 17 + 65);
}

TEST(Levels, AGradientMakesAPenForEach) {
  const Plan plan = plan_of(
      "[[layer]]\ncurve = { family = \"two-point\", levels = \"0..3\" }\npen = { from = \"ink\", to = \"red\" }\n");
  const Sheet& sheet = plan.sheet();
  ASSERT_EQ(sheet.layers.size(), 4U);
  ASSERT_EQ(sheet.pens.size(), 4U);
  EXPECT_EQ(sheet.pens[sheet.layers[0].pen].name, "ink");
  EXPECT_EQ(sheet.pens[sheet.layers[1].pen].name, "ink to red 2/4");
  EXPECT_EQ(sheet.pens[sheet.layers[2].pen].width_mm, 1.0);
  EXPECT_EQ(sheet.pens[sheet.layers[3].pen].name, "red");
  const Plan bands = plan_of(
      "[[layer]]\ncurve = { family = \"two-point\" }\npen = { from = \"ink\", to = \"red\", by = \"u\", at = [0.3, "
      "0.6] }\n");
  ASSERT_EQ(bands.sheet().layers.size(), 3U);
  EXPECT_EQ(bands.sheet().pens[2].name, "ink to red 2/3");
}

TEST(Levels, SaysWhatIsWrong) {
  const auto levels = [](const std::string& range) {
    return complaint("[[layer]]\ncurve = { family = \"two-point\", levels = \"" + range + "\" }\n");
  };
  EXPECT_EQ(levels("3..1"),
            "p.toml:5:43: error: 'levels': '3..1' is no range of at most 100 levels, the coarsest first, "
            "such as \"0..5\"");
  EXPECT_NE(levels("0..2000").find("at most 100 levels"), std::string::npos);
  EXPECT_EQ(levels("990..1001"), "p.toml:5:43: error: 'levels' = 1001 is outside [0, 1000]");
  EXPECT_NE(levels("0..x"), "");
  EXPECT_EQ(
      complaint("[[layer]]\ncurve = { family = \"two-point\" }\npen = { from = \"ink\", to = \"red\" }\n"),
      "p.toml:4:1: error: layer 'two-point': pens from 'ink' to 'red' need several levels, as in levels = \"0..5\", "
      "or bands: 'by' and 'at'");
  EXPECT_EQ(complaint("[[layer]]\ncurve = { family = \"two-point\", levels = \"0..3\" }\npen = { from = \"ink\" }\n"),
            "p.toml:6:7: error: 'pen': a gradient of pens needs 'from' and 'to': { from = \"ink\", to = \"red\" }");
  EXPECT_EQ(complaint("[[layer]]\ncurve = { family = \"two-point\", levels = \"0..3\" }\npen = { from = \"ink\", to = "
                      "\"rad\" }\n"),
            "p.toml:6:29: error: no pen 'rad'; did you mean 'red'?");
}

}  // namespace
}  // namespace burin::preset
