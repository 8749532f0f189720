#include <gtest/gtest.h>

#include <burin/preset/slot_layout.hpp>

namespace burin::preset {
namespace {

/// The unit square with its corner at the origin, whatever the cell.
const ContentBox unit_square = [](const Affine2& map, int) -> std::optional<Box2> {
  return image_box(map, {{0, 0}, {1, 1}});
};

void expect_near(Vec2 actual, Vec2 expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-12);
  EXPECT_NEAR(actual.y, expected.y, 1e-12);
}

const SlotFrame frame{{100, 150}, 80, 60};

std::vector<Copy> copies(const SlotSpec& slot, double inset_mm = 0.0, const ContentBox& content = unit_square) {
  const Result<std::vector<Copy>> made = lay_out(slot, frame, inset_mm, content);
  EXPECT_TRUE(made.ok());
  return made ? *made : std::vector<Copy>{};
}

TEST(SlotLayout, SlotsLieInTheLiveArea) {
  PageSpec page;
  page.size = {200, 300};
  page.margin = {10, 20, 30, 40};
  SlotSpec slot;
  slot.at = {{5, false}, {50, true}, {50, true}, {26, false}};
  const SlotFrame found = slot_frame(page, slot);
  EXPECT_EQ(found.width_mm, 70);
  EXPECT_EQ(found.height_mm, 26);
  expect_near(found.centre_mm, {40 + 5 + 35, 10 + 130 + 13});
  // Page y runs down, slot y up.
  expect_near(found.page_from_slot()({1, 2}), found.centre_mm + Vec2{1, -2});
}

TEST(SlotLayout, TheContentFitsTheNarrowSideAndIsCentred) {
  const Copy copy = copies({}).front();
  expect_near(copy.slot_from_model({0, 0}), {-30, -30});
  expect_near(copy.slot_from_model({1, 1}), {30, 30});
  const Copy inset = copies({}, 2.0).front();
  expect_near(inset.slot_from_model({1, 1}), {28, 28});
}

TEST(SlotLayout, AlignScaleAndFramePinIt) {
  SlotSpec slot;
  slot.align = {-1, 0};
  expect_near(copies(slot).front().slot_from_model({0, 0}), {-40, -30});
  slot.align = {1, -1};
  slot.scale = params::Length{10};
  expect_near(copies(slot).front().slot_from_model({1, 1}), {40, 30});  // right, top
  slot = {};
  slot.frame = {-1, -1, 2, 2};
  expect_near(copies(slot).front().slot_from_model({2, 2}), {30, 30});
  expect_near(copies(slot).front().slot_from_model({0.5, 0.5}), {0, 0});
}

TEST(SlotLayout, RotationAndMirrorComeBeforeTheFit) {
  SlotSpec slot;
  slot.rotate = 45;
  const Copy turned = copies(slot).front();
  expect_near(turned.slot_from_model({1, 1}), {0, 30});
  slot.rotate = 0;
  slot.mirror = Mirror::x;
  expect_near(copies(slot).front().slot_from_model({0, 0}), {30, -30});
}

TEST(SlotLayout, AGridHoldsEqualCopiesWithGaps) {
  SlotSpec slot;
  slot.grid = {2, 2};
  slot.gap.mm = 4;
  slot.mirror = Mirror::x;
  const std::vector<Copy> made = copies(slot);
  ASSERT_EQ(made.size(), 4U);
  // Cells are 38 x 28; the first is at the top left, upright; the second is its mirror image.
  expect_near(made[0].slot_from_model({0.5, 0.5}), {-21, 16});
  expect_near(made[1].slot_from_model({0.5, 0.5}), {21, 16});
  expect_near(made[0].slot_from_model({0, 0}), {-35, 2});
  expect_near(made[1].slot_from_model({0, 0}), {35, 2});
  EXPECT_EQ(made[3].column, 1);
  EXPECT_EQ(made[3].row, 1);
  EXPECT_EQ(made[3].index, 3);
  EXPECT_EQ(made[3].cell, 3);
}

TEST(SlotLayout, GridCellsShareTheScaleOfTheLargest) {
  SlotSpec slot;
  slot.grid = {2, 1};
  const ContentBox growing = [](const Affine2& map, int cell) -> std::optional<Box2> {
    return image_box(map, {{0, 0}, {1.0 + cell, 1}});
  };
  for (const Copy& copy : copies(slot, 0.0, growing)) EXPECT_NEAR(copy.slot_from_model.scale(), 20, 1e-12);
}

TEST(SlotLayout, RosettesTurnAboutTheModelsOrigin) {
  SlotSpec slot;
  slot.symmetry.name = "d4";
  const std::vector<Copy> made = copies(slot);
  ASSERT_EQ(made.size(), 8U);
  for (const Copy& copy : made) {
    expect_near(copy.slot_from_model({0, 0}), {0, 0});
    EXPECT_NEAR(length(copy.slot_from_model({1, 1})), 30 * std::sqrt(2.0), 1e-12);
  }
}

TEST(SlotLayout, TilingsFitTheirDomain) {
  SlotSpec slot;
  slot.symmetry.name = "p4m";
  slot.cell = params::Length{20};
  const std::vector<Copy> made = copies(slot);
  EXPECT_EQ(made.size(), 4U * 3U * 8U);
  for (const Copy& copy : made) EXPECT_NEAR(copy.slot_from_model.scale(), 5, 1e-12);
}

TEST(SlotLayout, PointsAndLinesHaveAFitToo) {
  const ContentBox point = [](const Affine2& map, int) -> std::optional<Box2> {
    return image_box(map, {{2, 3}, {2, 3}});
  };
  expect_near(copies({}, 0, point).front().slot_from_model({2, 3}), {0, 0});
  const ContentBox line = [](const Affine2& map, int) -> std::optional<Box2> {
    return image_box(map, {{0, 3}, {2, 3}});
  };
  expect_near(copies({}, 0, line).front().slot_from_model({2, 3}), {40, 0});
}

TEST(SlotLayout, ImpossibleSlotsAreProblems) {
  EXPECT_FALSE(lay_out({}, frame, 31.0, unit_square).ok());
  SlotSpec slot;
  slot.symmetry.name = "p1";
  slot.cell = params::Length{200};
  EXPECT_FALSE(lay_out(slot, frame, 0, unit_square).ok());
  slot.cell = params::Length{0.01};
  const Result<std::vector<Copy>> many = lay_out(slot, frame, 0, unit_square);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.problems().front().trouble, Trouble::limit);
  const ContentBox none = [](const Affine2&, int) -> std::optional<Box2> { return std::nullopt; };
  EXPECT_FALSE(lay_out({}, frame, 0, none).ok());
  slot = {};
  slot.grid = {1000, 1};
  slot.gap.mm = 1;
  EXPECT_FALSE(lay_out(slot, frame, 0, unit_square).ok());
}

}  // namespace
}  // namespace burin::preset
