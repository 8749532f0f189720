#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/measure/picture_difference.hpp>

namespace burin::measure {
namespace {

using data::Image;

Image plain(int width, int height, std::array<int, 4> colour = {255, 255, 255, 255}) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    for (const int channel : colour) image.rgba.push_back(static_cast<std::uint8_t>(channel));
  }
  return image;
}

void paint(Image& image, int x, int y, std::array<int, 4> colour) {
  for (std::size_t c = 0; c < 4; ++c) {
    image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + c] = static_cast<std::uint8_t>(colour[c]);
  }
}

constexpr std::array<int, 4> black{0, 0, 0, 255};

TEST(PictureDifference, EqualPicturesHaveNone) {
  Image image = plain(7, 5);
  paint(image, 3, 2, black);
  const PictureDifference d = picture_difference(image, image);
  EXPECT_TRUE(d.is_none());
  EXPECT_EQ(d.max, 0);
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(d.mean_on_ink, 0.0);
  EXPECT_EQ(d.block, 0.0);
  EXPECT_DOUBLE_EQ(d.ink_of_first, 1.0 / 35.0);
  EXPECT_DOUBLE_EQ(d.ink_of_second, 1.0 / 35.0);
}

TEST(PictureDifference, OnePixelCountsOnceAndInItsBlock) {
  const Image first = plain(20, 10);
  Image second = first;
  paint(second, 12, 7, {55, 255, 155, 255});
  const PictureDifference d = picture_difference(first, second);
  EXPECT_EQ(d.pixels, 1U);
  EXPECT_EQ(d.max, 200) << "its worst channel";
  EXPECT_EQ(d.max_at, (PixelPlace{12, 7}));
  EXPECT_DOUBLE_EQ(d.mean, 200.0 / 200.0);
  EXPECT_DOUBLE_EQ(d.mean_on_ink, 200.0);
  EXPECT_DOUBLE_EQ(d.block, 200.0 / 16.0);
  EXPECT_EQ(d.block_at, (PixelPlace{9, 4})) << "the first block that has it";
  EXPECT_EQ(d.ink_of_first, 0.0);
  EXPECT_DOUBLE_EQ(d.ink_of_second, 1.0 / 200.0);
}

TEST(PictureDifference, ABlockSeesMovedLinesAndNotTheNoiseOfEdges) {
  Image first = plain(40, 40);
  Image noisy = first;
  Image moved = first;
  for (int y = 0; y < 40; ++y) {
    paint(first, 20, y, {100, 100, 100, 255});
    paint(noisy, 20, y, y % 2 == 0 ? std::array{130, 130, 130, 255} : std::array{70, 70, 70, 255});
    paint(moved, 24, y, {100, 100, 100, 255});
  }
  EXPECT_EQ(picture_difference(first, noisy).max, 30);
  EXPECT_EQ(picture_difference(first, noisy).block, 0.0);
  EXPECT_DOUBLE_EQ(picture_difference(first, moved).block, 155.0 / 4.0);
}

TEST(PictureDifference, ColoursCountAsMuchAsTheirAlphaLetsThem) {
  const Image clear_black = plain(4, 4, {0, 0, 0, 0});
  EXPECT_TRUE(picture_difference(clear_black, plain(4, 4, {200, 10, 0, 0})).is_none()) << "both cannot be seen";
  EXPECT_EQ(picture_difference(clear_black, plain(4, 4)).max, 255) << "white is not nothing";
  EXPECT_EQ(picture_difference(plain(4, 4, {200, 0, 0, 255}), plain(4, 4, {200, 0, 0, 155})).max, 100);
  EXPECT_EQ(picture_difference(plain(4, 4, {255, 0, 0, 51}), plain(4, 4, {0, 0, 0, 51})).max, 51);
}

TEST(PictureDifference, InkIsWhatIsNotTheMostFrequentColour) {
  Image dark = plain(10, 10, {20, 20, 30, 255});
  for (int x = 0; x < 10; ++x) paint(dark, x, 4, {255, 255, 240, 255});
  EXPECT_DOUBLE_EQ(picture_difference(dark, dark).ink_of_first, 0.1);
}

TEST(PictureDifference, SmallPicturesAreOneBlock) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {9, 1}, {2, 9}}) {
    const PictureDifference d = picture_difference(plain(width, height), plain(width, height, {155, 255, 255, 255}));
    EXPECT_DOUBLE_EQ(d.block, 100.0) << width << "x" << height;
    EXPECT_EQ(d.block_at, (PixelPlace{0, 0}));
    EXPECT_DOUBLE_EQ(d.mean, 100.0);
  }
}

/// The same, one block after another.
double block_by_looking(const Image& a, const Image& b) {
  const int columns = std::min(a.width, block_side);
  const int rows = std::min(a.height, block_side);
  double worst = 0.0;
  for (int y = 0; y + rows <= a.height; ++y) {
    for (int x = 0; x + columns <= a.width; ++x) {
      for (int channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int v = y; v < y + rows; ++v) {
          for (int u = x; u < x + columns; ++u) sum += a.pixel(u, v)[channel] - b.pixel(u, v)[channel];
        }
        worst = std::max(worst, std::abs(static_cast<double>(sum)) / (columns * rows));
      }
    }
  }
  return worst;
}

TEST(PictureDifference, SlidingBlocksAreThoseOfLookingAtEach) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const int width = 1 + static_cast<int>(random_bits(seed, 1) % 13);
    const int height = 1 + static_cast<int>(random_bits(seed, 2) % 13);
    Image first = plain(width, height);
    Image second = first;
    for (std::size_t i = 0; i < first.rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      first.rgba[i] = static_cast<std::uint8_t>(random_bits(seed, 3, i));
      second.rgba[i] = static_cast<std::uint8_t>(random_bits(seed, 4, i));
    }
    const PictureDifference d = picture_difference(first, second);
    ASSERT_DOUBLE_EQ(d.block, block_by_looking(first, second)) << "seed " << seed;
    ASSERT_EQ(d.max, pixel_difference(first.pixel(d.max_at.x, d.max_at.y), second.pixel(d.max_at.x, d.max_at.y)));
    const PictureDifference turned = picture_difference(second, first);
    ASSERT_EQ(turned.block, d.block) << "either way round";
    ASSERT_EQ(turned.mean, d.mean);
  }
}

}  // namespace
}  // namespace burin::measure
