#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <burin/path/colour.hpp>

namespace burin {
namespace {

TEST(Colour, HexadecimalFormsAreRead) {
  EXPECT_EQ(parse_colour("#000000"), (Colour{0, 0, 0}));
  EXPECT_EQ(parse_colour("#12aBeF"), (Colour{0x12, 0xab, 0xef}));
  EXPECT_EQ(parse_colour("#1aF"), (Colour{0x11, 0xaa, 0xff}));
}

TEST(Colour, OtherFormsAreRefused) {
  for (const char* text : {"", "#", "#1", "#12", "#1234", "#12345", "#1234567", "#12345g", "#+12", "#-12", "# 12",
                           "#0x1", " red", "red ", "reddish", "re", "rgb(0,0,0)", "12aabb"}) {
    EXPECT_FALSE(parse_colour(text)) << text;
  }
  EXPECT_FALSE(parse_colour(std::string_view("red\0", 4)));
}

TEST(Colour, CssNamesHaveTheValuesOfCss) {
  // The first and the last name, those where X11 and CSS differ, and those that CSS spells twice.
  EXPECT_EQ(parse_colour("aliceblue"), parse_colour("#f0f8ff"));
  EXPECT_EQ(parse_colour("yellowgreen"), parse_colour("#9acd32"));
  EXPECT_EQ(parse_colour("gray"), parse_colour("#808080"));
  EXPECT_EQ(parse_colour("green"), parse_colour("#008000"));
  EXPECT_EQ(parse_colour("maroon"), parse_colour("#800000"));
  EXPECT_EQ(parse_colour("purple"), parse_colour("#800080"));
  EXPECT_EQ(parse_colour("lime"), parse_colour("#00ff00"));
  EXPECT_EQ(parse_colour("rebeccapurple"), parse_colour("#663399"));
  EXPECT_EQ(parse_colour("tomato"), parse_colour("#ff6347"));
  EXPECT_EQ(parse_colour("ivory"), parse_colour("#fffff0"));
  EXPECT_EQ(parse_colour("linen"), parse_colour("#faf0e6"));
  EXPECT_EQ(parse_colour("lightgoldenrodyellow"), parse_colour("#fafad2"));
  EXPECT_EQ(parse_colour("cyan"), parse_colour("aqua"));
  EXPECT_EQ(parse_colour("magenta"), parse_colour("fuchsia"));
  for (const char* grey :
       {"grey", "darkgrey", "dimgrey", "lightgrey", "slategrey", "darkslategrey", "lightslategrey"}) {
    std::string gray = grey;
    gray[gray.find("grey") + 2] = 'a';
    ASSERT_TRUE(parse_colour(grey)) << grey;
    EXPECT_EQ(parse_colour(grey), parse_colour(gray)) << grey;
  }
}

TEST(Colour, NamesAreReadInAnyCase) {
  EXPECT_EQ(parse_colour("DarkSlateBlue"), parse_colour("darkslateblue"));
  EXPECT_EQ(parse_colour("OAT"), parse_colour("oat"));
}

TEST(Colour, EveryNameIsSortedOnceAndReadable) {
  const std::vector<std::string_view> names = colour_names();
  EXPECT_EQ(names.size(), 148U + 13U);
  EXPECT_TRUE(std::ranges::is_sorted(names));
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  for (const std::string_view name : names) EXPECT_TRUE(parse_colour(name)) << name;
}

TEST(Colour, PapersAreLightAndNearlyGrey) {
  for (const char* paper :
       {"bone", "chalk", "cream", "eggshell", "mist", "newsprint", "oat", "parchment", "porcelain", "sand", "vellum"}) {
    const std::optional<Colour> colour = parse_colour(paper);
    ASSERT_TRUE(colour) << paper;
    const auto [low, high] = std::minmax({colour->red, colour->green, colour->blue});
    EXPECT_GE(low, 190) << paper;
    EXPECT_LE(high - low, 40) << paper;
  }
}

TEST(Colour, TextReadsBack) {
  for (int value = 0; value < 256; ++value) {
    const auto byte = static_cast<std::uint8_t>(value);
    const Colour colour{byte, static_cast<std::uint8_t>(255 - byte), static_cast<std::uint8_t>(byte ^ 0x5AU)};
    EXPECT_EQ(parse_colour(colour_text(colour)), colour);
  }
  EXPECT_EQ(colour_text({1, 2, 255}), "#0102ff");
}

}  // namespace
}  // namespace burin
