#include <string>

#include "plan_text.hpp"
#include "support/polygons.hpp"

/// Presets within presets.
namespace burin::preset {
namespace {

/// "flag.toml" has a line in ink and a filled square in red; "self.toml" draws itself; "library" has another.
const ReadFile files = [](std::string_view name) -> Result<std::string> {
  const std::string head = "burin = 1\npage = { size = \"100x100mm\", margin = \"10mm\" }\n";
  if (name == "art/flag.toml" || name == "flag.toml") {
    return head +
           "[knobs]\nside = { default = 2.0, min = 1.0, max = 9.0, doc = \"of the square\" }\n[pens]\nink = { width = "
           "\"1mm\" }\nred = { color = \"red\", width = \"0.5mm\" }\n[slots]\nall = { at = \"0 0 100% 100%\", frame = "
           "[0, 0, 10, 10] }\n[[layer]]\nslot = \"all\"\ncurve = { family = \"two-point\", levels = 0, base = { points "
           "= [[0, 0], [10, 0]] } }\n[[layer]]\nslot = \"all\"\nfill = \"red\"\nstroke = \"none\"\nopacity = "
           "0.5\ncurve = { family = \"two-point\", levels = 0, base = { points = [[0, 0], [\"$side\", 0], [\"$side\", "
           "\"$side\"], [0, \"$side\"]], closed = true } }\n";
  }
  if (name == "burin:presets/shipped.toml") return head + "[[layer]]\ncurve = { family = \"two-point\" }\n";
  if (name == "self.toml") return head + "[[layer]]\npiece = \"self\"\n";
  if (name == "art/lost.toml") return head + "[[layer]]\nsvg = \"gone.svg\"\n";
  return Problem{{}, "no file '" + std::string(name) + "'"};
};

const std::string page =
    "burin = 1\npage = { size = \"200x200mm\", margin = \"0mm\" }\n[pens]\nblack = { width = \"1mm\" }\n";

Plan plan_of(const std::string& layers) {
  return plan_text(page + layers, files);
}

std::string complaint(const std::string& layers) {
  return first_complaint(page + layers, files);
}

Recording drawn(const Plan& plan, Paint paint) {
  RunOptions options;
  options.wanted = [&](const SheetLayer& layer) { return layer.paint == paint; };
  return drawn(plan, options);
}

TEST(NestedPiece, ItsLayersComeWithTheirPensAndLooks) {
  const Plan plan = plan_of("[[layer]]\nname = \"flag\"\npiece = \"art/flag\"\n");
  const Sheet& sheet = plan.sheet();
  ASSERT_EQ(sheet.layers.size(), 2U);
  EXPECT_EQ(sheet.layers[0].name, "flag");
  EXPECT_EQ(sheet.layers[1].paint, Paint::fill_nonzero);
  EXPECT_EQ(sheet.layers[1].opacity, 0.5);
  // Black of 1 mm is there already; red is new.
  EXPECT_EQ(sheet.pens[sheet.layers[0].pen].name, "black");
  EXPECT_EQ(sheet.pens[sheet.layers[1].pen].name, "red");
  EXPECT_EQ(sheet.pens.size(), 2U);
}

TEST(NestedPiece, ItFillsItsSlotAsOne) {
  const Plan plan = plan_of("[[layer]]\npiece = \"art/flag\"\n");
  // The line of 80 mm, its square at the lower left, both on 199 mm: half a pen is kept free.
  const Box2 line = drawn(plan, Paint::stroke).bounds();
  const Box2 square = drawn(plan, Paint::fill_nonzero).bounds();
  EXPECT_NEAR(line.width(), 199.0, 1e-9);
  EXPECT_NEAR(square.width(), 199.0 * 0.2, 1e-9);
  EXPECT_NEAR(square.low.x, line.low.x, 1e-9);
  EXPECT_NEAR(square.high.y, line.low.y, 1e-9);
}

TEST(NestedPiece, KnobsSeedsAndAPenMayBeGiven) {
  const Plan plan =
      plan_of("[[layer]]\npen = \"black\"\npiece = { file = \"art/flag\", knobs = { side = 5 }, seed = 3 }\n");
  EXPECT_EQ(plan.sheet().pens.size(), 1U);
  EXPECT_NEAR(drawn(plan, Paint::fill_nonzero).bounds().width(), 199.0 * 0.5, 1e-9);
}

TEST(NestedPiece, NamesOfTheLibraryNeedNoFolder) {
  EXPECT_EQ(plan_of("[[layer]]\npiece = \"shipped\"\n").sheet().layers.size(), 1U);
}

TEST(NestedPiece, AZoomShowsWhatItShows) {
  const Plan plan = plan_of("[[layer]]\npiece = \"art/flag\"\n");
  RunOptions options;
  options.tolerance_mm = 0.01;
  options.window = PageWindow{{100.0, 100.0}, 20.0};
  Recorder recorder;
  EXPECT_EQ(plan.run(recorder, options), Flow::go);
  for (const Vec2 p : recorder.recording().all_points()) EXPECT_TRUE(is_finite(p));
}

TEST(NestedPiece, MistakesTeach) {
  EXPECT_NE(complaint("[[layer]]\npiece = \"self\"\n").find("at most 8 deep"), std::string::npos);
  EXPECT_NE(complaint("[[layer]]\npiece = \"none\"\n").find("no file"), std::string::npos);
  EXPECT_NE(complaint("[[layer]]\npiece = 3\n").find("the name of a preset"), std::string::npos);
  EXPECT_NE(complaint("[[layer]]\npiece = { file = \"flag\", knobs = { syde = 3 } }\n").find("syde"),
            std::string::npos);
  EXPECT_NE(complaint("[[layer]]\npiece = \"art/lost\"\n").find("gone.svg"), std::string::npos);
  EXPECT_NE(complaint("[[layer]]\npiece = \"flag\"\ntext = \"a\"\n").find("give each its own layer"),
            std::string::npos);
}

TEST(NestedPiece, AllOfItClipsOthers) {
  // Of the flag's sheet layers the line in ink encloses nothing, the red square does.
  const std::string row =
      "[slots]\npage = { at = \"0 0 100% 100%\", frame = [0, 0, 200, 200] }\n[[layer]]\nname = \"row\"\nslot = "
      "\"page\"\ncurve = { family = \"two-point\", levels = 0, base = { points = [[0, 100], [200, 100]] } }\n";
  const auto length_of = [&](const std::string& clip) {
    const Plan plan = plan_of(row + clip + "[[layer]]\nname = \"flag\"\npiece = \"flag\"\n");
    RunOptions options;
    options.wanted = [](const SheetLayer& layer) { return layer.name == "row"; };
    return test::stroke_length(drawn(plan, options));
  };
  const Plan plan = plan_of("[[layer]]\npiece = \"flag\"\n");
  const Box2 square = drawn(plan, Paint::fill_nonzero).bounds();
  const double whole = length_of("");
  EXPECT_NEAR(length_of("clip = \"flag\"\n"), square.width(), 1e-6);
  EXPECT_NEAR(length_of("outside = \"flag\"\n"), whole - square.width(), 1e-6);
}

}  // namespace
}  // namespace burin::preset
