#include <burin/base/sha256.hpp>
#include <burin/curves/two_point/two_point.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

/// The example that the design shows, without primitives.
constexpr std::string_view winter_card = R"(burin = 1
seed = 19
about = { title = "Winter card", summary = "A wreath of leaves over two mirrored dragons." }
page = { size = "30x40cm", margin = "30mm 30mm 45mm", paper = "oat", bleed = "3mm" }

[knobs]                              # burin draw winter-card -D levels=5 -D motif=bud
levels = { default = 4, min = 0, max = 9, doc = "refinement levels" }
motif = { default = "koch", choices = ["koch", "cesaro", "bud"], doc = "motif of the wreath" }
accent = { default = "tomato", kind = "color", doc = "ink beyond 60 mm" }
lean = { random = [10, 40], doc = "tilt of the leaves in degrees, drawn from the seed" }

[pens]                               # roles; numbered in file order
ink = { color = "black", width = "0.3mm" }
red = { color = "$accent", width = "0.8pt" }

[define]                             # written once, used by name
bud = { points = [[0, 0], [0.3, 0], [0.5, 0.4], [0.7, 0], [1, 0]] }
flake = { family = "two-point", motif = "$motif", base = "triangle", levels = "$levels" }

[slots]                              # x y w h of the live area; one slot = one common frame
top = { at = "0 0 100% 66%" }
foot = { at = "0 70% 100% 22%", grid = [2, 1], gap = "8mm", mirror = "x" }

[[layer]]
curve = "flake"
slot = "top"

[[layer]]
curve = { like = "flake", levels = 3 }
slot = "top"
pen = { by = "pr", at = [60], of = ["ink", "red"] }

[[layer]]
name = "own motif"
slot = "foot"
[layer.curve]
family = "two-point"
base = { points = [[0, 0], [3, 0], [3, 2]], closed = true }
motif = { marks = [["1/3", 0], [0.5, "sqrt(3)/6"], ["2/3", 0]], sign = "constant" }
levels = 4
)";

const curves::TwoPointParams& curve_of(const Piece& piece, std::size_t layer) {
  return *std::any_cast<curves::TwoPointParams>(&piece.layers.at(layer).parameters);
}

void expect_winter_card(const Result<Piece>& piece) {
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(piece->seed, 19U);
  EXPECT_EQ(piece->about.title, "Winter card");
  EXPECT_EQ(piece->page.size.width_mm, 300.0);
  EXPECT_EQ(piece->page.margin.bottom_mm, 45.0);
  EXPECT_EQ(piece->page.bleed.mm, 3.0);
  ASSERT_EQ(piece->pens.size(), 2U);
  EXPECT_EQ(piece->pens[1].pen.color, *parse_colour("tomato"));
  ASSERT_EQ(piece->slots.size(), 2U);
  EXPECT_EQ(piece->slots[1].slot.mirror, Mirror::x);
  ASSERT_EQ(piece->layers.size(), 3U);
  EXPECT_EQ(piece->layers[0].style.name, "flake");
  EXPECT_EQ(piece->layers[1].style.name, "flake 2");
  EXPECT_EQ(piece->layers[1].style.pen.of.size(), 2U);
  EXPECT_EQ(piece->layers[2].style.name, "own motif");
  EXPECT_EQ(curve_of(*piece, 0).levels, 4);
  EXPECT_EQ(curve_of(*piece, 1).levels, 3);
  EXPECT_EQ(curve_of(*piece, 2).base.polylines.front().points.size(), 3U);
}

TEST(Load, ReadsTheExampleOfTheDesign) {
  expect_winter_card(load_text(winter_card));
}

TEST(Load, ReadsForeignLineEndsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : winter_card) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_winter_card(load_text(text));
  const Result<Piece> broken = load_text(
      "\xEF\xBB\xBF"
      "burin = 2\r\n" +
      std::string(one_layer));
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(problems_text(broken.problems()),
            "p.toml:1:9: error: edition 2 is unknown; this burin reads edition 1\n"
            "  burin = 2\n"
            "          ^\n");
}

TEST(Load, AKnobChoosesADefine) {
  Overrides overrides;
  overrides.knobs.emplace_back("motif", "bud");
  const Result<Piece> piece = load_text(winter_card, overrides);
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(curve_of(*piece, 0).motif.stage(1).mark_count(), 3U);
}

TEST(Load, AsksForTheEdition) {
  EXPECT_EQ(complaints(one_layer),
            "p.toml: error: the edition is missing; begin the preset with the line: burin = 1\n");
  EXPECT_EQ(complaints("burin = '1'\n" + std::string(one_layer)),
            "p.toml:1:10: error: the edition is a whole number, not a text; write burin = 1\n");
  EXPECT_EQ(complaints(""),
            "p.toml: error: the edition is missing; begin the preset with the line: burin = 1\n"
            "p.toml: error: a preset needs at least one [[layer]]\n");
}

TEST(Load, NotesItsDataFiles) {
  const ReadFile read_file = [](std::string_view name) -> Result<std::string> {
    if (name == "a.csv") return std::string("0,0\n1,0\n1,1\n");
    return Problem{{std::string(name)}, "no such file"};
  };
  const std::string text =
      "burin = 1\n[[layer]]\ncurve = { family = 'two-point', base = { csv = 'a.csv' } }\n"
      "[[layer]]\ncurve = { family = 'two-point', base = { csv = 'a.csv' } }\n";
  const Result<Piece> piece = load_text(text, {}, read_file);
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  ASSERT_EQ(piece->data.size(), 1U);
  EXPECT_EQ(piece->data[0].name, "a.csv");
  EXPECT_EQ(piece->data[0].sha256, sha256_hex("0,0\n1,0\n1,1\n"));
  EXPECT_NE(complaints(text).find("data file 'a.csv' cannot be read here"), std::string::npos);
  const Result<Piece> missing =
      load_text("burin = 1\n[[layer]]\ncurve = { family = 'two-point', base = { csv = 'b.csv' } }\n", {}, read_file);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.problems().front().message, "'base': 'b.csv' no such file");
}

TEST(Load, ShowsEverythingAtOnceInOrder) {
  Overrides overrides;
  overrides.knobs.emplace_back("levels", "5000");
  overrides.keys.emplace_back("layer.1.opacty", "0.5");
  const Result<Piece> piece = load_text(R"(burin = 1
sed = 3
page = { size = "a44", bleed = -1 }
[pens]
ink = { color = "$accent", width = "0mm" }
[knobs]
levels = { default = 4, max = 1000 }
accent = { default = "tomatoo", kind = "color" }
[define]
flake = { family = "two-point", base = "triangel", levels = "$levls" }
[[layer]]
curve = "flake"
slot = "top"
[[layer]]
curve = "flake"
	pen = "é$nope"
)",
                                        overrides);
  ASSERT_FALSE(piece.ok());
  EXPECT_EQ(problems_text(piece.problems()), R"(-D levels=5000: error: 'levels' = 5000 is outside (-inf, 1000]
--set layer.1.opacty=0.5: error: unknown key 'opacty' in layer 'flake'; did you mean 'opacity'?
p.toml:2:1: error: unknown key 'sed' in the preset; did you mean 'seed'?
  sed = 3
  ^
p.toml:3:18: error: 'size': 'a44' is no paper such as a4 or 30x40cm; did you mean 'a4'?
  page = { size = "a44", bleed = -1 }
                   ^
p.toml:3:32: error: 'bleed' = -1 mm is outside [0, 100] mm
  page = { size = "a44", bleed = -1 }
                                 ^
p.toml:5:37: error: 'width' = 0 mm is outside (0, 100] mm
  ink = { color = "$accent", width = "0mm" }
                                      ^
p.toml:8:23: error: 'accent': 'tomatoo' is no color; did you mean 'tomato'?
  accent = { default = "tomatoo", kind = "color" }
                        ^
p.toml:10:41: error: 'base': 'triangel' is none of the choices; did you mean 'triangle'?
  flake = { family = "two-point", base = "triangel", levels = "$levls" }
                                          ^
p.toml:10:62: error: no knob 'levls'; did you mean 'levels'?
  flake = { family = "two-point", base = "triangel", levels = "$levls" }
                                                               ^
p.toml:13:9: error: no slot 'top': the preset has no [slots]
  slot = "top"
          ^
p.toml:16:9: error: no knob 'nope'; known: seed, levels, accent
  	pen = "é$nope"
  	       ^
)");
}

}  // namespace
}  // namespace burin::preset
