#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/utf8.hpp>
#include <burin/curves/text/glyph.hpp>
#include <burin/curves/text/recipes.hpp>

/// The letters: every font has every character, they stand on their line, and accents sit where they belong.
namespace burin::curves::lettering {
namespace {

std::u32string characters() {
  std::u32string all;
  for (char32_t c = U' '; c <= U'~'; ++c) all += c;
  for (char32_t c = 0xA0; c <= 0xFF; ++c) all += c == 0xAD ? U' ' : c;  // a soft hyphen is not drawn
  return all + U"–—‘’“”‚„…•‹›€™Œœ−←→ŠšŽžŸČčŘřĚěŇňŁłĐđĞğİıŐőŰűĄąĘęŻżŞşŢţȘșȚțĀāŪū";
}

Glyph glyph(Font font, char32_t character) {
  std::optional<Glyph> found = glyph_of(font, character);
  EXPECT_TRUE(found.has_value()) << utf8_text(character);
  return found.value_or(Glyph{});
}

/// What stands above a height.
Box2 box_above(const Glyph& glyph, double height) {
  Box2 box;
  for (const Stroke& stroke : glyph.strokes) {
    const Glyph one{0.0, {stroke}};
    if (one.box().low.y > height) box.add(one.box());
  }
  return box;
}

class Fonts : public ::testing::TestWithParam<Font> {};

TEST_P(Fonts, HaveEveryCharacter) {
  std::set<std::vector<Stroke>, bool (*)(const std::vector<Stroke>&, const std::vector<Stroke>&)> seen(
      [](const std::vector<Stroke>& a, const std::vector<Stroke>& b) {
        return std::lexicographical_compare(
            a.begin(), a.end(), b.begin(), b.end(), [](const Stroke& s, const Stroke& t) {
              return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), [](Vec2 p, Vec2 q) {
                return p.x < q.x || (p.x == q.x && p.y < q.y);
              });
            });
      });
  for (const char32_t c : characters()) {
    SCOPED_TRACE(utf8_text(c));
    const Glyph drawn = glyph(GetParam(), c);
    EXPECT_GT(drawn.advance, 0.0);
    EXPECT_LT(drawn.advance, 2.0 * units_per_cap);
    EXPECT_EQ(drawn.strokes.empty(), c == U' ' || c == 0xA0);
    for (const Stroke& stroke : drawn.strokes) {
      EXPECT_GE(stroke.size(), 2U);
      for (const Vec2 p : stroke) EXPECT_TRUE(is_finite(p));
    }
    const Box2 box = drawn.box();
    if (drawn.strokes.empty()) continue;
    EXPECT_GE(box.low.y, -16.0);
    EXPECT_LE(box.high.y, 32.0);
    EXPECT_GE(box.low.x, -8.0) << "far into the letter before";
    EXPECT_LE(box.high.x, drawn.advance + 8.0) << "far into the letter after";
    // I of the sans is a bar, as is l.
    const bool twin = std::u32string_view(U"‘’−‚¯").find(c) != std::u32string_view::npos || c == U'Đ' || c == U'l';
    EXPECT_TRUE(seen.insert(drawn.strokes).second || twin) << "looks like another character";
  }
}

TEST_P(Fonts, CapitalsAreOneCapHighAndStandOnTheBaseline) {
  for (const char32_t c : U"HEIK") {
    if (c == 0) continue;
    const Box2 box = glyph(GetParam(), c).box();
    EXPECT_EQ(box.low.y, 0.0) << utf8_text(c);
    EXPECT_EQ(box.high.y, units_per_cap) << utf8_text(c);
  }
  EXPECT_EQ(glyph(GetParam(), U'.').box().low.y, 0.0) << "points stand on the baseline";
}

TEST_P(Fonts, MarksStandAboveTheirLetters) {
  const std::u32string bases = U"AEIOUNYaeounyi";
  const std::u32string acute = U"ÁÉÍÓÚŃÝáéóúńýí";
  for (std::size_t i = 0; i < bases.size(); ++i) {
    SCOPED_TRACE(utf8_text(acute[i]));
    const double top =
        bases[i] == U'i' ? glyph(GetParam(), U'ı').box().high.y : glyph(GetParam(), bases[i]).box().high.y;
    const Box2 mark = box_above(glyph(GetParam(), acute[i]), top + 0.5);
    ASSERT_FALSE(mark.empty());
    EXPECT_GT(mark.low.y, top + 1.0) << "clear of the letter";
    EXPECT_LT(mark.low.y, top + 4.0) << "near the letter";
    EXPECT_GT(mark.high.y, mark.low.y + 3.0);
  }
}

TEST_P(Fonts, ADotMakesWayForAMark) {
  const Glyph plain = glyph(GetParam(), U'i');
  const Glyph dotless = glyph(GetParam(), U'ı');
  EXPECT_LT(dotless.strokes.size(), plain.strokes.size());
  EXPECT_LT(dotless.box().high.y, plain.box().high.y);
  EXPECT_EQ(glyph(GetParam(), U'ï').strokes.size() - dotless.strokes.size(),
            2 * (plain.strokes.size() - dotless.strokes.size()))
      << "two dots, as they stand on i";
  EXPECT_EQ(glyph(GetParam(), U'į').strokes.size(), plain.strokes.size() + 1) << "a mark below leaves the dot";
}

TEST_P(Fonts, MarksBelowHang) {
  for (const char32_t c : {U'ç', U'Ç', U'ą', U'ş', U'ț'}) {
    EXPECT_LT(glyph(GetParam(), c).box().low.y, -4.0) << utf8_text(c);
  }
}

TEST_P(Fonts, TurnedMarksHangFromTheSmallLetters) {
  for (const auto& [turned, mark] : {std::pair{U'¡', U'!'}, std::pair{U'¿', U'?'}}) {
    const Box2 upright = glyph(GetParam(), mark).box();
    const Box2 hanging = glyph(GetParam(), turned).box();
    EXPECT_EQ(hanging.high.y, 14.0 - upright.low.y);
    EXPECT_NEAR(hanging.height(), upright.height(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Fonts, ::testing::ValuesIn([] {
                           std::vector<Font> all;
                           for (const auto& word : words(Font{})) all.push_back(word.value);
                           return all;
                         }()),
                         [](const auto& font) {
                           std::string name = params::ValueType<Font>::text(font.param);
                           std::erase_if(name, [](char c) { return c == '"' || c == '-'; });
                           return name;
                         });

TEST(Glyphs, CopyTheData) {
  // rowmans: "L" is "HYLFL[ RL[X[".
  const Glyph l = glyph(Font::sans, U'L');
  EXPECT_EQ(l.advance, 'Y' - 'H');
  EXPECT_EQ(l.strokes, (std::vector<Stroke>{{{4.0, 21.0}, {4.0, 0.0}}, {{4.0, 0.0}, {16.0, 0.0}}}));
}

TEST(Glyphs, SansAccentsAreCentred) {
  for (const auto& [letter, base] : {std::pair{U'Ô', U'O'}, std::pair{U'Ä', U'A'}, std::pair{U'î', U'ı'}}) {
    const Box2 below = glyph(Font::sans, base).box();
    const Glyph whole = glyph(Font::sans, letter);
    const double shift = 0.5 * (whole.advance - glyph(Font::sans, base).advance);
    EXPECT_NEAR(box_above(whole, below.high.y).center().x - shift, below.center().x, 1e-12) << utf8_text(letter);
  }
}

TEST(Glyphs, AMarkWiderThanItsLetterKeepsItsDistance) {
  for (const char32_t c : {U'î', U'ï', U'Î', U'Ï'}) {
    const Glyph wide = glyph(Font::sans, c);
    EXPECT_GE(wide.box().low.x, 1.0);
    EXPECT_LE(wide.box().high.x, wide.advance - 1.0);
  }
}

TEST(Glyphs, HeavyStrokesOfOursAreTwoLines) {
  // A dash is 13 long at 7: its outline is half a unit away on both sides.
  const Box2 light = glyph(Font::sans, U'–').box();
  const Box2 heavy = glyph(Font::sans_bold, U'–').box();
  EXPECT_EQ(light.height(), 0.0);
  EXPECT_EQ(heavy.height(), 1.0);
  EXPECT_EQ(heavy.center().y, light.center().y);
  EXPECT_EQ(heavy.width(), light.width());
}

TEST(Glyphs, UnknownCharactersHaveNone) {
  for (const char32_t c : {U'\0', U'\n', U'\t', U'\x7F', U'\u00AD', U'ж', U'漢', U'\uFFFF', char32_t{0x10FFFF}}) {
    EXPECT_FALSE(glyph_of(Font::sans, c).has_value()) << static_cast<unsigned>(c);
  }
}

TEST(Recipes, EveryMarkedLetterHasALetterOfAscii) {
  for (char32_t c = 0xA0; c < 0x250; ++c) {
    const MarkedLetter marked = marked_letter(c);
    if (marked.letter == 0) continue;
    EXPECT_TRUE(marked.letter == U' ' || (marked.letter >= U'A' && marked.letter <= U'z')) << utf8_text(c);
    EXPECT_TRUE(recipe_of(c, false).empty()) << utf8_text(c) << " has two ways to be drawn";
  }
}

}  // namespace
}  // namespace burin::curves::lettering
