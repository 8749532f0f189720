#include <gtest/gtest.h>

#include <burin/measure/page_ink.hpp>

namespace burin::measure {
namespace {

constexpr double per_mm = 2.0;

/// A page of 40 x 60 mm with these boxes in this grey.
data::Image page_with(const std::vector<Box2>& boxes_mm, std::uint8_t grey = 0) {
  data::Image page{80, 120, std::vector<std::uint8_t>(80 * 120 * 4, 255)};
  for (const Box2& box : boxes_mm) {
    for (int y = static_cast<int>(box.low.y * per_mm); y < box.high.y * per_mm; ++y) {
      for (int x = static_cast<int>(box.low.x * per_mm); x < box.high.x * per_mm; ++x) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          page.rgba[4 * (static_cast<std::size_t>(y) * 80 + static_cast<std::size_t>(x)) + channel] = grey;
        }
      }
    }
  }
  return page;
}

const Box2 live{{5, 5}, {35, 55}};

TEST(PageInk, OfASquareOfInk) {
  const PageInk ink = page_ink(page_with({{{10, 20}, {20, 30}}}), per_mm, live);
  EXPECT_DOUBLE_EQ(ink.ink, 100.0 / 1500.0);
  EXPECT_DOUBLE_EQ(ink.dense, 4.0 / 60.0);
  EXPECT_DOUBLE_EQ(ink.empty, 56.0 / 60.0);
  EXPECT_DOUBLE_EQ(ink.darkest, 1.0);
  EXPECT_DOUBLE_EQ(ink.left_mm, 10.0);
  EXPECT_DOUBLE_EQ(ink.right_mm, 20.0);
  EXPECT_DOUBLE_EQ(ink.top_mm, 20.0);
  EXPECT_DOUBLE_EQ(ink.bottom_mm, 30.0);
}

TEST(PageInk, GreyIsPartlyCovered) {
  const PageInk ink = page_ink(page_with({{{10, 20}, {15, 25}}}, 128), per_mm, live);
  EXPECT_NEAR(ink.darkest, 127.0 / 255.0, 1e-12);
  EXPECT_DOUBLE_EQ(ink.dense, 0.0);
}

TEST(PageInk, InkOutsideTheLiveAreaCountsForTheMarginsOnly) {
  const PageInk ink = page_ink(page_with({{{1, 2}, {3, 4}}}), per_mm, live);
  EXPECT_DOUBLE_EQ(ink.ink, 0.0);
  EXPECT_DOUBLE_EQ(ink.left_mm, 1.0);
  EXPECT_DOUBLE_EQ(ink.top_mm, 2.0);
}

TEST(PageInk, OfABarePage) {
  const PageInk ink = page_ink(page_with({}), per_mm, live);
  EXPECT_DOUBLE_EQ(ink.ink, 0.0);
  EXPECT_DOUBLE_EQ(ink.empty, 1.0);
  EXPECT_DOUBLE_EQ(ink.left_mm, 40.0);
  EXPECT_DOUBLE_EQ(ink.bottom_mm, 60.0);
}

}  // namespace
}  // namespace burin::measure
