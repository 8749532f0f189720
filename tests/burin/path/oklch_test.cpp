#include <gtest/gtest.h>

#include <burin/path/oklch.hpp>

namespace burin {
namespace {

TEST(Oklch, EndsAreTheColoursThemselves) {
  const Colour a{12, 200, 77};
  const Colour b{255, 0, 3};
  EXPECT_EQ(mix_colours(a, b, 0.0), a);
  EXPECT_EQ(mix_colours(a, b, 1.0), b);
  EXPECT_EQ(mix_colours(a, a, 0.37), a);
}

TEST(Oklch, GreysStayGreyAndLightnessIsEven) {
  // Black to white by halves: lightness 0.5 is linear 0.125, in sRGB 0.3885 (#636363), as browsers' color-mix gives.
  EXPECT_EQ(mix_colours({0, 0, 0}, {255, 255, 255}, 0.5), (Colour{99, 99, 99}));
}

TEST(Oklch, AgreesWithBrowsersColorMix) {
  // color-mix(in oklch, #ff0000, #0000ff) is rgb(186, 0, 194) after clipping; the short way goes through purple.
  const Colour purple = mix_colours({255, 0, 0}, {0, 0, 255}, 0.5);
  EXPECT_NEAR(purple.red, 186, 1);
  EXPECT_EQ(purple.green, 0);
  EXPECT_NEAR(purple.blue, 194, 1);
}

TEST(Oklch, AGreyTakesTheOthersHue) {
  const Colour pink = mix_colours({255, 255, 255}, {255, 0, 0}, 0.5);
  EXPECT_GT(pink.red, 250);
  EXPECT_NEAR(pink.green, pink.blue, 30);
  EXPECT_GT(pink.green, 100);
}

}  // namespace
}  // namespace burin
