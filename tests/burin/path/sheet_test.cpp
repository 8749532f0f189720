#include <gtest/gtest.h>

#include <burin/path/sheet.hpp>

namespace burin {
namespace {

Sheet two_pens() {
  Sheet sheet;
  sheet.pens = {{"ink", {}, 0.3}, {"red", {}, 25.4 / 72.0 * 0.8}};
  sheet.layers.resize(3);
  sheet.layers[1].pen = 1;
  return sheet;
}

TEST(LayerLabel, HasThePensNumberNameAndWidth) {
  const Sheet sheet = two_pens();
  EXPECT_EQ(layer_label(sheet, 0), "1 ink 0.3");
  EXPECT_EQ(layer_label(sheet, 1), "2 red 0.282");
  EXPECT_EQ(layer_label(sheet, 2), "1 ink 0.3");
}

TEST(LayerLabelDeathTest, LayersAndPensThatAreNotThere) {
  Sheet sheet = two_pens();
  EXPECT_DEATH((void)layer_label(sheet, 3), "contract broken");
  sheet.layers[0].pen = 2;
  EXPECT_DEATH((void)layer_label(sheet, 0), "contract broken");
}

}  // namespace
}  // namespace burin
