#include <burin/curves/two_point/two_point.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

constexpr std::string_view preset = R"(burin = 1
[define]
flake = { family = "two-point", levels = 4 }
[pens]
ink = { width = "0.3mm" }
red = {}
[slots]
top = {}
[[layer]]
curve = "flake"
[[layer]]
curve = "flake"
[[layer]]
name = "my own. name"
curve = { family = "two-point" }
)";

Overrides set(std::string key, std::string text) {
  Overrides overrides;
  overrides.keys.emplace_back(std::move(key), std::move(text));
  return overrides;
}

Piece piece_with(const Overrides& overrides) {
  Result<Piece> piece = load_text(preset, overrides);
  if (piece) return *std::move(piece);
  ADD_FAILURE() << problems_text(piece.problems());
  return {};
}

TEST(Set, ReachesEveryTable) {
  EXPECT_EQ(piece_with(set("page.margin", "10mm 5mm")).page.margin.left_mm, 5.0);
  EXPECT_EQ(piece_with(set("page.bleed", "2")).page.bleed.mm, 2.0);
  EXPECT_EQ(piece_with(set("about.title", "My card")).about.title, "My card");
  EXPECT_EQ(piece_with(set("about.title", "2026-01-01")).about.title, "2026-01-01");
  EXPECT_EQ(piece_with(set("about.title", "\"42\"")).about.title, "42");
  EXPECT_EQ(piece_with(set("pens.red.color", "#00f")).pens[1].pen.color, (Colour{0, 0, 255}));
  EXPECT_EQ(piece_with(set("slots.top.rotate", "30/2")).slots[0].slot.rotate, 15.0);
  EXPECT_EQ(piece_with(set("slots.top.grid", "[2, 3]")).slots[0].slot.grid.rows, 3);
  EXPECT_EQ(piece_with(set("seed", "12")).seed, 12U);
  const Piece flatter = piece_with(set("define.flake.levels", "2"));
  EXPECT_EQ(std::any_cast<curves::TwoPointParams>(&flatter.layers[1].parameters)->levels, 2);
}

TEST(Set, FindsLayersByNameAndNumber) {
  EXPECT_EQ(piece_with(set("layer.flake.opacity", "0.5")).layers[0].style.opacity, 0.5);
  EXPECT_EQ(piece_with(set("layer.flake 2.opacity", "0.5")).layers[1].style.opacity, 0.5);
  EXPECT_EQ(piece_with(set("layer.\"my own. name\".opacity", "0.5")).layers[2].style.opacity, 0.5);
  EXPECT_EQ(piece_with(set("layer.3.opacity", "0.5")).layers[2].style.opacity, 0.5);
  const Piece piece = piece_with(set("layer.3.curve.levels", "1"));
  EXPECT_EQ(std::any_cast<curves::TwoPointParams>(&piece.layers[2].parameters)->levels, 1);
}

TEST(Set, KnowsThePenThatIsThereUnasked) {
  const Result<Piece> piece = load_text("burin = 1\n" + std::string(one_layer), set("pens.ink.width", "1mm"));
  ASSERT_TRUE(piece.ok());
  EXPECT_EQ(piece->pens[0].pen.width.mm, 1.0);
}

TEST(Set, ComesBeforeKnobs) {
  const Result<Piece> piece =
      load_text("burin = 1\nknobs.k = { default = 3 }\n" + std::string(one_layer), set("page.bleed", "$k"));
  ASSERT_TRUE(piece.ok());
  EXPECT_EQ(piece->page.bleed.mm, 3.0);
}

TEST(Set, ReportsPathsThatLeadNowhere) {
  const auto complaint = [](const std::string& key, const std::string& text) {
    return complaints(preset, set(key, text));
  };
  EXPECT_EQ(complaint("pagee.margin", "1"),
            "--set pagee.margin=1: error: no key 'pagee' in a preset; did you mean 'page'?\n");
  EXPECT_EQ(complaint("page.margn", "1"),
            "--set page.margn=1: error: unknown key 'margn' in page; did you mean 'margin'?\n");
  EXPECT_EQ(complaint("pens.rde.width", "1"),
            "--set pens.rde.width=1: error: no 'rde' in [pens]; did you mean 'red'?\n");
  EXPECT_EQ(complaint("layer.flaek.opacity", "1"),
            "--set layer.flaek.opacity=1: error: no layer 'flaek'; did you mean 'flake'?\n");
  EXPECT_EQ(complaint("layer.4.opacity", "1"),
            "--set layer.4.opacity=1: error: no layer '4'; known: flake, flake 2, my own. name\n");
  EXPECT_EQ(complaint("layer.flake.curve.levels", "1"),
            "--set layer.flake.curve.levels=1: error: 'curve' is a text ('flake'), which has no keys\n");
  EXPECT_EQ(complaint("layer.flake.opacity", "3"),
            "--set layer.flake.opacity=3: error: 'opacity' = 3 is outside [0, 1]\n");
  EXPECT_EQ(complaint("layer.flake", "3"),
            "--set layer.flake=3: error: expected 'layer.NAME.key', NAME being a layer's name or number\n");
  EXPECT_EQ(complaint("page..x", "3"),
            "--set page..x=3: error: expected a path such as page.margin or layer.NAME.opacity\n");
  EXPECT_EQ(complaint("page.bleed", "inf"),
            "--set page.bleed=inf: error: 'inf' cannot be drawn; write a finite number\n");
  // What would be two keys in a file is a text here, and no length.
  EXPECT_EQ(complaint("page.bleed", "1\nx=2").substr(0, 40), "--set page.bleed=1\nx=2: error: 'bleed': ");
}

TEST(PageOptions, ReplaceWhatThePresetSays) {
  Overrides overrides;
  overrides.page_size = "20x10cm";
  overrides.margin = "5mm";
  EXPECT_EQ(piece_with(overrides).page.size.width_mm, 200.0);
  EXPECT_EQ(piece_with(overrides).page.margin.bottom_mm, 5.0);
  overrides.page_size = "a4";
  overrides.landscape = true;
  EXPECT_EQ(piece_with(overrides).page.size.width_mm, 297.0);
  overrides.page_size = "a44";
  overrides.margin = "x";
  EXPECT_EQ(complaints(preset, overrides),
            "--page a44: error: 'size': 'a44' is no paper such as a4 or 30x40cm; did you mean 'a4'?\n"
            "--margin x: error: 'margin': expected a length such as 15mm, 1.5cm, 0.5in or 2pt, found 'x'\n");
}

}  // namespace
}  // namespace burin::preset
