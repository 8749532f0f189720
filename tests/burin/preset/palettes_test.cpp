#include <algorithm>
#include <cmath>
#include <set>

#include <burin/preset/palettes.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

double luminance(Colour colour) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

/// WCAG 2.1: from 1 to 21.
double contrast(Colour a, Colour b) {
  const double la = luminance(a);
  const double lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Palettes, InksCanBeReadOnTheirPaper) {
  std::set<std::string_view> names;
  for (const Palette& palette : palettes()) {
    EXPECT_TRUE(names.insert(palette.name).second);
    EXPECT_FALSE(palette.summary.empty());
    EXPECT_GE(contrast(palette.ink, palette.paper), 7.0) << palette.name;
    EXPECT_GE(contrast(palette.accent, palette.paper), 3.0) << palette.name;
    EXPECT_GE(contrast(palette.soft, palette.paper), 1.8) << palette.name;
    EXPECT_GT(contrast(palette.ink, palette.paper), 1.5 * contrast(palette.soft, palette.paper)) << palette.name;
    EXPECT_EQ(find_palette(palette.name), &palette);
  }
  EXPECT_EQ(find_palette("puce"), nullptr);
}

TEST(Palettes, GiveColoursWhereNoneIsWritten) {
  const Palette& dusk = *find_palette("dusk");
  const Piece plain = piece_of("palette = 'dusk'");
  ASSERT_EQ(plain.pens.size(), 3U);
  EXPECT_EQ(plain.page.paper, dusk.paper);
  EXPECT_EQ(plain.pens[0].pen.color, dusk.ink);
  EXPECT_EQ(plain.pens[1].name, "accent");
  EXPECT_EQ(plain.pens[1].pen.color, dusk.accent);
  EXPECT_EQ(plain.layers[0].style.pen.of, std::vector<std::string>{"ink"});
  const Piece own = piece_of(
      "palette = 'dusk'\npage = { paper = 'white' }\npens = { soft = { width = '1mm' }, accent = { color = 'red' }, x "
      "= {} }");
  EXPECT_EQ(own.page.paper, (Colour{255, 255, 255}));
  EXPECT_EQ(own.pens[0].pen.color, dusk.soft);
  EXPECT_EQ(own.pens[0].pen.width.mm, 1.0);
  EXPECT_EQ(own.pens[1].pen.color, (Colour{255, 0, 0}));
  EXPECT_EQ(own.pens[2].pen.color, (Colour{0, 0, 0}));
}

TEST(Palettes, AreTurnedByKnobsAndOverrides) {
  const std::string preset = "palette = '$p'\nknobs.p = { default = 'dusk', choices = ['dusk', 'frost'] }";
  Overrides overrides;
  overrides.knobs = {{"p", "frost"}};
  EXPECT_EQ(piece_of(preset, overrides).page.paper, find_palette("frost")->paper);
  overrides = {};
  overrides.keys = {{"palette", "moss"}};
  EXPECT_EQ(piece_of(preset, overrides).page.paper, find_palette("moss")->paper);
}

TEST(Palettes, UnknownOnesAreReported) {
  EXPECT_EQ(complaints_in("palette = 'dsuk'"), "p.toml:2:12: error: no palette 'dsuk'; did you mean 'dusk'?\n");
}

}  // namespace
}  // namespace burin::preset
