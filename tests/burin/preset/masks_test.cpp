#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "plan_text.hpp"
#include "support/polygons.hpp"

/// Layers that hide and clip others, from the preset's text to what is drawn on the page.
namespace burin::preset {
namespace {

/// A page of 100 mm whose slot has millimetres as model units, its centre at the origin. The pens take no room.
const std::string page = R"(burin = 1
page = { size = "100x100mm", margin = "0mm" }
[pens]
ink = { width = "0.000000001mm" }
red = { color = "red", width = "0.000000001mm" }
[slots]
all = { at = "0 0 100% 100%", frame = [-50, -50, 50, 50] }
)";

/// A layer with the polygon or line of these points.
std::string layer(const std::string& name, const std::string& points, bool closed, const std::string& more = "") {
  return "[[layer]]\nname = \"" + name + "\"\nslot = \"all\"\ncurve = { family = \"two-point\", levels = 0, base = { " +
         "points = [" + points + "], closed = " + (closed ? "true" : "false") + " } }\n" + more + "\n";
}

const std::string row = "[-40, 5], [40, 5]";
const std::string box = "[0, 0], [20, 0], [20, 20], [0, 20]";

Plan plan_of(const std::string& text) {
  return plan_text(page + text);
}

std::string complaint(const std::string& text) {
  return first_complaint(page + text);
}

/// The length of what a layer of the sheet draws.
double length_of(const Plan& plan, const std::string& layer_name, RunOptions options = {}) {
  options.wanted = [&](const SheetLayer& sheet_layer) { return sheet_layer.name == layer_name; };
  return test::stroke_length(drawn(plan, options));
}

TEST(Masks, ALayerHidesWhatLiesUnderIt) {
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, true, "hide = true"));
  EXPECT_NEAR(length_of(plan, "row"), 60.0, 1e-9);
  EXPECT_NEAR(length_of(plan, "box"), 80.0, 1e-9);
}

TEST(Masks, WhatComesLaterIsNotHidden) {
  const Plan plan = plan_of(layer("box", box, true, "hide = true") + layer("row", row, false));
  EXPECT_NEAR(length_of(plan, "row"), 80.0, 1e-9);
}

TEST(Masks, OpenPathsHideNothing) {
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, false, "hide = true"));
  EXPECT_NEAR(length_of(plan, "row"), 80.0, 1e-9);
}

TEST(Masks, HiddenPartsMayHaveAPenOfTheirOwn) {
  const Plan plan = plan_of(layer("row", row, false, "hidden = \"red\"") + layer("box", box, true, "hide = true"));
  ASSERT_EQ(plan.sheet().layers.size(), 3U);
  EXPECT_EQ(plan.sheet().layers[1].name, "row hidden");
  EXPECT_EQ(plan.sheet().pens[plan.sheet().layers[1].pen].name, "red");
  EXPECT_NEAR(length_of(plan, "row"), 60.0, 1e-9);
  EXPECT_NEAR(length_of(plan, "row hidden"), 20.0, 1e-9);
}

TEST(Masks, WhatIsClippedAwayHidesNothing) {
  const std::string clip = "hide = true\nclip = { shape = \"rectangle\", width = \"20mm\", height = \"90mm\" }";
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, true, clip));
  EXPECT_NEAR(length_of(plan, "row"), 70.0, 1e-5);
}

TEST(Masks, ALayerMayHideAndNotBeDrawn) {
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, true, "hide = true\nstroke = \"none\""));
  EXPECT_EQ(plan.sheet().layers.size(), 1U);
  EXPECT_NEAR(length_of(plan, "row"), 60.0, 1e-9);
}

TEST(Masks, FiguresHideThoseBeforeThem) {
  // Circles of radius 5 every 8 mm: each covers a part of the one before.
  const std::string figures =
      "[[layer]]\nname = \"beads\"\nslot = \"all\"\ncurve = { family = \"two-point\", levels = 0, base = { points = [" +
      row + "] } }\nprimitives = { use = \"circle\", every = \"8mm\", scale = \"10mm\", rotate = 0 }\nhide = ";
  const double all = length_of(plan_of(figures + "false"), "beads");
  const double seen = length_of(plan_of(figures + "true"), "beads");
  // An arc of 2 acos(4 / 5) radians is gone of each but the last one.
  EXPECT_NEAR(all, 10.0 * 31.41592, 0.1);
  EXPECT_NEAR(all - seen, 9.0 * 5.0 * 2.0 * 0.6435011, 0.1);
}

TEST(Masks, PensByBandsHideAsOneDoes) {
  const std::string back = layer("row", row, false);
  const auto beads = [&](const std::string& pen) {
    return back + "[[layer]]\nname = \"beads\"\nslot = \"all\"\nhide = true\npen = " + pen +
           "\ncurve = { family = \"two-point\", levels = 1, motif = \"koch\", base = { points = [" + row +
           "] } }\nprimitives = { use = \"circle\", every = \"6mm\", scale = \"11mm\", rotate = 0 }\n";
  };
  const Plan one = plan_of(beads("\"ink\""));
  const Plan two = plan_of(beads("{ by = \"px\", at = [0], of = [\"ink\", \"red\"] }"));
  EXPECT_EQ(two.sheet().layers.size(), 3U);
  EXPECT_NEAR(length_of(two, "beads"), length_of(one, "beads"), 1e-9);
  EXPECT_NEAR(length_of(two, "row"), length_of(one, "row"), 1e-9);
  EXPECT_LT(length_of(one, "row"), 60.0);
}

TEST(Masks, FillsAreCutToo) {
  const Plan plan =
      plan_of(layer("field", "[-10, -10], [10, -10], [10, 10], [-10, 10]", true, "fill = \"red\"\nstroke = \"none\"") +
              layer("box", box, true, "hide = true"));
  RunOptions fills;
  fills.wanted = [](const SheetLayer& sheet_layer) { return sheet_layer.paint != Paint::stroke; };
  EXPECT_NEAR(std::abs(test::signed_area(test::contours_of(drawn(plan, fills)))), 300.0, 1e-4);
}

TEST(Masks, TheRuleSaysWhatALayerCovers) {
  const std::string star = "[-20, -20], [0, 25], [20, -20], [-25, 10], [25, 10]";
  const auto seen = [&](const std::string& rule) {
    return length_of(
        plan_of(layer("row", row, false) + layer("star", star, true, "hide = true\nrule = \"" + rule + "\"")), "row");
  };
  EXPECT_GT(seen("evenodd"), seen("nonzero") + 1.0);
}

TEST(Clips, APlainShapeCutsLines) {
  EXPECT_NEAR(length_of(plan_of(layer("row", row, false, "clip = { shape = \"disc\", r = \"13mm\" }")), "row"), 24.0,
              1e-3);
  EXPECT_NEAR(length_of(plan_of(layer("row", row, false, "outside = { shape = \"disc\", r = \"13mm\" }")), "row"), 56.0,
              1e-3);
  const std::string at =
      "clip = { shape = \"rectangle\", width = \"10mm\", height = \"20mm\", at = [\"-40mm\", \"5mm\"] }";
  EXPECT_NEAR(length_of(plan_of(layer("row", row, false, at)), "row"), 5.0, 1e-9);
  EXPECT_NEAR(length_of(plan_of(layer("row", "[-70, 0], [30, 0]", false, "clip = { shape = \"page\" }")), "row"), 80.0,
              1e-9);
}

TEST(Clips, ALayerCutsAnother) {
  const std::string mask = layer("box", box, true, "stroke = \"none\"");
  const Plan inside = plan_of(mask + layer("row", row, false, "clip = \"box\""));
  EXPECT_EQ(inside.sheet().layers.size(), 1U);
  EXPECT_NEAR(length_of(inside, "row"), 20.0, 1e-9);
  // A later layer may be the shape, too.
  EXPECT_NEAR(length_of(plan_of(layer("row", row, false, "outside = \"box\"") + mask), "row"), 60.0, 1e-9);
}

TEST(Clips, BothTogether) {
  const Plan plan = plan_of(layer("box", box, true) +
                            layer("row", row, false, "clip = { shape = \"disc\", r = \"13mm\" }\noutside = \"box\""));
  EXPECT_NEAR(length_of(plan, "row"), 12.0, 1e-3);
}

TEST(Masks, AWindowShowsTheSamePictureLarger) {
  const Plan plan = plan_of(layer("row", row, false, "clip = { shape = \"disc\", r = \"30mm\" }") +
                            layer("box", box, true, "hide = true"));
  for (const double zoom : {2.0, 64.0, 1e6}) {
    // About the point where the row goes under the box, at (0, 5) of the slot; at twice the size it comes out again.
    RunOptions options;
    options.tolerance_mm = 1e-4;
    options.window = PageWindow{{50.0, 45.0}, 100.0 / zoom};
    EXPECT_NEAR(length_of(plan, "row", options), zoom > 2.0 ? 50.0 : 60.0, 0.01) << zoom;
  }
}

TEST(Masks, APartOfThePageHasWhatTheWholeHas) {
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, true, "hide = true"));
  RunOptions part;
  part.tolerance_mm = 1e-3;
  part.part_mm = {{60, 40}, {65, 50}};
  // All of it lies under the box.
  for (const std::vector<Vec2>& contour : test::contours_of(drawn(plan, part))) {
    for (std::size_t i = 1; i < contour.size(); ++i) {
      const Vec2 middle = lerp(contour[i - 1], contour[i], 0.5);
      EXPECT_FALSE(middle.x > 50.1 && middle.x < 69.9 && middle.y > 30.1 && middle.y < 49.9);
    }
  }
}

TEST(Masks, DashesGoOnUnderWhatHidesThem) {
  // Dashes of 6 mm every 10 mm from x = 10 on; the box hides 50..70, which cuts the fifth, all of the sixth and a gap.
  const std::string dashed = layer("row", row, false, "dashes = [\"6mm\", \"4mm\"]");
  const std::string box_7mm = layer("box", "[3, 0], [22, 0], [22, 20], [3, 20]", true, "hide = true");
  const auto dashes = [](const Plan& plan) {
    RunOptions options;
    options.wanted = [](const SheetLayer& sheet_layer) { return sheet_layer.name == "row"; };
    std::vector<std::pair<double, double>> all;
    for (const std::vector<Vec2>& contour : test::contours_of(drawn(plan, options))) {
      all.emplace_back(std::round(1e6 * contour.front().x) / 1e6, std::round(1e6 * contour.back().x) / 1e6);
    }
    return all;
  };
  const Plan cut = plan_of(dashed + box_7mm);
  EXPECT_TRUE(cut.sheet().layers[0].dashes_mm.empty());
  EXPECT_EQ(dashes(cut), (std::vector<std::pair<double, double>>{
                             {10, 16}, {20, 26}, {30, 36}, {40, 46}, {50, 53}, {72, 76}, {80, 86}}));
  const Plan clipped = plan_of(layer("row", row, false,
                                     "dashes = [\"6mm\", \"4mm\"]\nclip = { shape = \"rectangle\", width = "
                                     "\"30mm\", height = \"90mm\" }"));
  EXPECT_EQ(dashes(clipped), (std::vector<std::pair<double, double>>{{35, 36}, {40, 46}, {50, 56}, {60, 65}}));
  // Whole lines are left to the format.
  EXPECT_EQ(plan_of(dashed).sheet().layers[0].dashes_mm, (std::vector<double>{6.0, 4.0}));
  EXPECT_EQ(plan_of(box_7mm + dashed).sheet().layers[1].dashes_mm, (std::vector<double>{6.0, 4.0}));
}

TEST(Masks, ModelUnitsHaveTheWholeCurves) {
  const Plan plan = plan_of(layer("row", row, false) + layer("box", box, true, "hide = true"));
  EXPECT_NEAR(length_of(plan, "row", {.space = Space::model}), 80.0, 1e-12);
}

TEST(Masks, MistakesTeach) {
  EXPECT_EQ(complaint(layer("row", row, false, "clip = \"bix\"") + layer("box", box, true)),
            "p.toml:12:9: error: no layer 'bix'; did you mean 'box'? A plain shape is a table: { shape = \"disc\", r = "
            "\"70mm\" }");
  EXPECT_NE(complaint(layer("row", row, false, "clip = \"row\"")).find("cannot be clipped by itself"),
            std::string::npos);
  EXPECT_NE(complaint(layer("row", row, false, "clip = { shape = \"disc\" }")).find("needs 'r' above 0"),
            std::string::npos);
  EXPECT_NE(
      complaint(layer("row", row, false, "clip = { shape = \"disc\", r = \"1mm\", at = [\"1mm\"] }")).find("[x, y]"),
      std::string::npos);
  EXPECT_NE(complaint(layer("row", row, false, "hidden = \"blue\"")).find("no pen 'blue'"), std::string::npos);
  EXPECT_NE(complaint(layer("row", row, false, "stroke = \"none\"")).find("neither hides nor clips"),
            std::string::npos);
}

}  // namespace
}  // namespace burin::preset
