#include <array>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

/// The style of a layer with these lines, in a preset with two pens and a slot.
LayerStyle style_of(std::string_view lines) {
  const Result<Piece> piece = load_text("burin = 1\npens = { ink = {}, red = {} }\nslots = { top = {} }\n" +
                                        std::string(one_layer) + std::string(lines) + "\n");
  if (piece) return piece->layers[0].style;
  ADD_FAILURE() << problems_text(piece.problems());
  return {};
}

/// What is wrong with such a layer; `lines` begin at line 6.
std::string style_complaint(std::string_view lines) {
  return complaints("burin = 1\npens = { ink = {}, red = {} }\nslots = { top = {} }\n" + std::string(one_layer) +
                    std::string(lines) + "\n");
}

TEST(Layer, ReadsItsStyle) {
  const LayerStyle style = style_of(
      "slot = 'top'\npen = 'red'\nfill = 'ink'\nrule = 'evenodd'\nstroke = 'none'\ncaps = 'butt'\njoins = 'bevel'\n"
      "miter = 2\ndashes = ['2mm', 1, 0]\nopacity = 0.5\nseed = -7\nname = 'N'");
  EXPECT_EQ(style.slot, "top");
  EXPECT_EQ(style.pen.of, std::vector<std::string>{"red"});
  EXPECT_EQ(style.fill, "ink");
  EXPECT_EQ(style.rule, FillRule::evenodd);
  EXPECT_EQ(style.stroke, "none");
  EXPECT_EQ(style.caps, Cap::butt);
  EXPECT_EQ(style.joins, Join::bevel);
  EXPECT_EQ(style.miter, 2.0);
  EXPECT_EQ(style.dashes, (std::vector<params::Length>{{2.0}, {1.0}, {0.0}}));
  EXPECT_EQ(style.opacity, 0.5);
  EXPECT_EQ(style.seed, -7);
  EXPECT_EQ(style.name, "N");
}

TEST(Layer, HasItsCurvesNameThePiecesFirstPenAndTheLiveArea) {
  const LayerStyle style = style_of("");
  EXPECT_EQ(style.name, "two-point");
  EXPECT_EQ(style.pen.of, std::vector<std::string>{"ink"});
  EXPECT_EQ(style.slot, "");
}

TEST(Layer, NamesAreDistinct) {
  const Result<Piece> piece = load_text(R"(burin = 1
define.a = { family = "two-point" }
layer = [ { curve = "a" }, { curve = { like = "a" } }, { name = "a 2", curve = "a" }, { curve = "a" } ]
)");
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  const std::array<const char*, 4> names{"a", "a 3", "a 2", "a 4"};
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(piece->layers[i].style.name, names[i]);
  EXPECT_EQ(piece->layers[1].where.line, 3);
  EXPECT_EQ(complaints("burin = 1\ndefine.a = { family = 'two-point' }\n[[layer]]\nname = 'x'\ncurve = 'a'\n"
                       "[[layer]]\nname = 'x'\ncurve = 'a'\n"),
            "p.toml:7:9: error: two layers are called 'x'; give each a name of its own\n");
}

TEST(Layer, PensMayFollowThePlace) {
  const PenChoice pen = style_of("pen = { by = 'pr - 2*u', at = [-1, '60/2'], of = ['ink', 'red', 'ink'] }").pen;
  EXPECT_EQ(pen.of, (std::vector<std::string>{"ink", "red", "ink"}));
  EXPECT_EQ(pen.at, (std::vector<double>{-1.0, 30.0}));
  primitives::PositionValues place{};
  place[6] = 10.0;
  place[7] = 0.5;
  EXPECT_EQ(pen.by(place), 9.0);
}

TEST(Layer, ReportsBandsThatAreNone) {
  EXPECT_EQ(style_complaint("pen = 3"), "p.toml:6:7: error: 'pen': expected a text, found a whole number\n");
  EXPECT_EQ(style_complaint("pen = { by = 'x', of = ['ink'] }"),
            "p.toml:6:7: error: 'pen': bands need 'at': { by = \"f(x,y)\", at = [...], of = [...] }\n");
  EXPECT_EQ(style_complaint("pen = { by = 'x', at = [1], of = ['ink'] }"),
            "p.toml:6:34: error: 'pen': 1 bounds in 'at' need 2 in 'of', found 1\n");
  EXPECT_EQ(style_complaint("pen = { by = 'x', at = [1, 1], of = ['ink', 'red', 'ink'] }"),
            "p.toml:6:28: error: 'pen': bounds must ascend: 1 does not follow 1\n");
  EXPECT_EQ(style_complaint("pen = { by = 'x + foo', at = [1], of = ['ink', 'rde'] }"),
            "p.toml:6:19: error: 'pen': unknown name 'foo'; did you mean 'floor'?\n"
            "p.toml:6:49: error: no pen 'rde'; did you mean 'red'?\n");
}

TEST(Layer, ReportsAStyleThatDrawsNothing) {
  EXPECT_EQ(
      style_complaint("stroke = 'none'"),
      "p.toml:6:11: error: without stroke and 'fill' the layer draws nothing, and it neither hides nor clips others\n");
  EXPECT_EQ(style_complaint("stroke = 'red'"),
            "p.toml:6:11: error: 'stroke' is \"none\" or left out, not 'red'; the pen is chosen by 'pen'\n");
  EXPECT_EQ(style_complaint("dashes = [0, '0mm']"),
            "p.toml:6:10: error: dashes need a length above 0; leave them out for a full line\n");
  EXPECT_EQ(style_complaint("dashes = []"),
            "p.toml:6:10: error: dashes need a length above 0; leave them out for a full line\n");
  EXPECT_EQ(style_complaint("dashes = [1, -1]"), "p.toml:6:10: error: dashes cannot be shorter than 0\n");
  EXPECT_EQ(style_complaint("slot = 'tpo'\nfill = 'rod'\npen = 'blue'"),
            "p.toml:6:9: error: no slot 'tpo'; did you mean 'top'?\n"
            "p.toml:7:9: error: no pen 'rod'; did you mean 'red'?\n"
            "p.toml:8:8: error: no pen 'blue'; known: ink, red\n");
  EXPECT_EQ(style_complaint("form = 'sphere'\nmitre = 3"),
            "p.toml:6:1: error: unknown key 'form' in layer 'two-point'; known: name, slot, pen, fill, rule, stroke, "
            "caps, joins, miter, dashes, opacity, seed, primitives, hide, hidden, clip, outside, curve, piece, text, "
            "svg, shape\n"
            "p.toml:7:1: error: unknown key 'mitre' in layer 'two-point'; did you mean 'miter'?\n");
}

/// Every family, as messages list them.
std::string family_list() {
  std::string list;
  for (const curves::Family& family : curves::catalogue()) {
    list += (list.empty() ? "" : ", ") + std::string(family.name);
  }
  return list;
}

TEST(Layer, NeedsACurve) {
  const auto complaint = [](std::string_view curve) {
    return complaints("burin = 1\ndefine.bud = { points = [[0, 0], [1, 0]] }\ndefine.n = 3\n[[layer]]\n" +
                      std::string(curve) + "\n");
  };
  EXPECT_EQ(complaint(""),
            "p.toml:4:1: error: layer 'layer' draws nothing; give it a 'curve', 'text', 'svg', 'shape' or 'piece'\n");
  EXPECT_EQ(complaint("curve = 3"),
            "p.toml:5:9: error: expected the name of a define or a table with 'family', found a whole number\n");
  EXPECT_EQ(complaint("curve = { levels = 3 }"),
            "p.toml:5:9: error: a curve needs a 'family'; known: " + family_list() + "\n");
  EXPECT_EQ(complaint("curve = { family = 'two-pint' }"),
            "p.toml:5:21: error: no family 'two-pint'; did you mean 'two-point'?\n");
  EXPECT_EQ(complaint("curve = { family = 3 }"),
            "p.toml:5:20: error: expected the name of a family, found a whole number\n");
  EXPECT_EQ(complaint("curve = 'two-point'"),
            "p.toml:5:10: error: 'two-point' is a family; write curve = { family = \"two-point\" }\n");
  EXPECT_EQ(complaint("curve = 'flake'"), "p.toml:5:10: error: no curve 'flake' in [define]\n");
  EXPECT_EQ(complaint("curve = 'bud'"), "p.toml:2:14: error: a curve needs a 'family'; known: " + family_list() + "\n");
  EXPECT_EQ(complaint("curve = { family = 'two-point', amplitud = 1, levels = 4000 }"),
            "p.toml:5:33: error: unknown key 'amplitud' in curve; known: base, motif, sign, levels, family\n"
            "p.toml:5:56: error: 'levels' = 4000 is outside [0, 1000]\n");
  EXPECT_EQ(complaints("burin = 1\n"), "p.toml: error: a preset needs at least one [[layer]]\n");
  EXPECT_EQ(complaints("burin = 1\nlayer = []"), "p.toml:2:9: error: a preset needs at least one [[layer]]\n");
  EXPECT_EQ(complaints("burin = 1\nlayer = [3]"),
            "p.toml:2:10: error: expected a table: [[layer]], found a whole number\n");
}

}  // namespace
}  // namespace burin::preset
