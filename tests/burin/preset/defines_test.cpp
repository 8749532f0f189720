#include <burin/curves/two_point/two_point.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

int levels_of(const Piece& piece, std::size_t layer) {
  return std::any_cast<curves::TwoPointParams>(&piece.layers.at(layer).parameters)->levels;
}

TEST(Like, MergesBelowTheTablesOwnKeys) {
  const Result<Piece> piece = load_text(R"(burin = 1
[define]
flake = { family = "two-point", base = "triangle", levels = 4 }
small = { like = "flake", levels = 2 }
thin = { width = "0.1mm", color = "red" }
[pens]
a = { like = "thin", color = "#00f" }
[[layer]]
curve = "flake"
[[layer]]
curve = { like = "small" }
[[layer]]
curve = { like = "small", levels = 1 }
)");
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(levels_of(*piece, 0), 4);
  EXPECT_EQ(levels_of(*piece, 1), 2);
  EXPECT_EQ(levels_of(*piece, 2), 1);
  const auto* params = std::any_cast<curves::TwoPointParams>(&piece->layers[2].parameters);
  EXPECT_EQ(params->base.polylines.front().points.size(), 3U);
  EXPECT_EQ(piece->pens[0].pen.width.mm, 0.1);
  EXPECT_EQ(piece->pens[0].pen.color, (Colour{0, 0, 255}));
}

TEST(Like, AKnobMayChooseTheDefine) {
  const Result<Piece> piece = load_text(R"(burin = 1
knobs.which = { default = "b" }
define.a = { family = "two-point", levels = 1 }
define.b = { family = "two-point", levels = 2 }
[[layer]]
curve = { like = "$which" }
)");
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(levels_of(*piece, 0), 2);
}

TEST(Like, IsAnOrdinaryNameAmongNames) {
  const Piece piece = piece_of("pens.like = { width = 1 }\ndefine.like = { width = 2 }\nslots.like = {}");
  EXPECT_EQ(piece.pens[0].name, "like");
  EXPECT_EQ(piece.slots[0].name, "like");
}

TEST(Like, ReportsWhatItCannotFollow) {
  EXPECT_EQ(
      complaints_in("define.a = { like = \"b\" }\ndefine.b = { like = \"c\" }\ndefine.c = { x = { like = \"a\" } }"),
      "p.toml:4:28: error: 'a' is like itself; break the circle\n");
  EXPECT_EQ(complaints_in("define.flake = { x = 1 }\npage = { like = \"flak\" }"),
            "p.toml:3:18: error: no 'flak' in [define]; did you mean 'flake'?\n");
  EXPECT_EQ(complaints_in("define.n = 3\npage = { like = \"n\" }\nabout = { like = 4 }"),
            "p.toml:3:18: error: 'n' in [define] is a whole number, not a table\n"
            "p.toml:4:18: error: 'like' names a define in a text, found a whole number\n");
  EXPECT_EQ(complaints_in("define = 3"), "p.toml:2:10: error: 'define' is a table: [define], not a whole number\n");
}

TEST(Like, DoesNotGrowWithoutEnd) {
  std::string text = "define.d0 = { x = 1 }\n";
  for (int i = 1; i < 40; ++i) {
    text += "define.d" + std::to_string(i) + " = { a = { like = \"d" + std::to_string(i - 1) +
            "\" }, b = { like = \"d" + std::to_string(i - 1) + "\" } }\n";
  }
  EXPECT_NE(complaints_in(text).find("grow beyond 100000 values"), std::string::npos);
}

TEST(Like, LongChainsAreRefused) {
  std::string text;
  for (int i = 100; i > 0; --i) {
    text += "define.d" + std::to_string(i) + " = { like = \"d" + std::to_string(i - 1) + "\" }\n";
  }
  EXPECT_NE(complaints_in(text + "define.d0 = { x = 1 }").find("more than 64 defines"), std::string::npos);
}

}  // namespace
}  // namespace burin::preset
