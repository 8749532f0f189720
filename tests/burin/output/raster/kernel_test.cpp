#include <gtest/gtest.h>

#include <burin/output/raster/kernel.hpp>

#include "sample_reference.hpp"
#include "support/random_paths.hpp"

/// That all kernels have the bits of samples_in().
namespace burin::test {
namespace {

using namespace output::raster;

constexpr PixelBox part{0, 0, 80, 64};

Point random_point(Dice& dice, double low, double high) {
  return {static_cast<std::int32_t>(1024.0 * dice.between(low, high)),
          static_cast<std::int32_t>(1024.0 * dice.between(low, high))};
}

/// Any shape of a stroke, from a hair to far wider than the part, from within a pixel to beyond the page.
Convex random_shape(Dice& dice) {
  constexpr double sizes[] = {0.01, 0.5, 1.0, 4.0, 20.0, 300.0, 20'000.0};
  const double size = sizes[dice.below(7)];
  const double half_width = 1024.0 * sizes[dice.below(6)] * dice.between(0.3, 1.0);
  const Point a = dice.below(4) == 0 ? random_point(dice, -size, 80.0 + size) : random_point(dice, -2.0, 82.0);
  Point step = random_point(dice, -size, size);
  Point other = random_point(dice, -size, size);
  if (dice.below(5) == 0) step.x = 0;
  if (dice.below(5) == 0) step.y = 0;
  if (step == Point{}) step.x = 1;
  if (other == Point{}) other.y = 1;
  const Point b{a.x + step.x, a.y + step.y};
  const bool parallel = std::int64_t{step.x} * other.y == std::int64_t{step.y} * other.x;
  switch (dice.below(parallel ? 4 : 6)) {
    case 0:
      return segment_body(a, b, half_width);
    case 1:
      return disc(a, half_width);
    case 2:
      return square_cap(a, b, half_width);
    case 3:
      return join_sector(a, step, other, half_width);
    case 4:
      return join_bevel(a, step, other, half_width);
    default:
      return join_miter(a, step, other, half_width);
  }
}

int wrong_samples(const Kernel& kernel, const Convex& shape) {
  MaskTiles tiles(part);
  kernel.cover(shape, part, tiles);
  int wrong = 0;
  for (int j = part.top; j < part.bottom; ++j) {
    for (int i = part.left; i < part.right; ++i) {
      const MaskTiles::Tile* const tile = tiles.tile(i / MaskTiles::width, j / MaskTiles::height);
      const Samples found = tile == nullptr ? 0 : *tiles.at(i, j, 0);
      wrong += found != samples_in(shape, i, j) ? 1 : 0;
    }
  }
  return wrong;
}

TEST(Kernels, HaveTheBitsOfTheDefinition) {
  Dice dice(11);
  for (int turn = 0; turn < 600; ++turn) {
    const Convex shape = random_shape(dice);
    EXPECT_EQ(wrong_samples(best_kernel(), shape), 0) << "best, turn " << turn;
    EXPECT_EQ(wrong_samples(portable_kernel(), shape), 0) << "portable, turn " << turn;
  }
}

TEST(Kernels, AreExactOnBordersThroughSamples) {
  // Every border of these goes through a sample, or as close by as positions can be.
  Dice dice(12);
  for (int turn = 0; turn < 600; ++turn) {
    const auto sample = [&] {
      const int i = static_cast<int>(dice.below(40));
      const int j = static_cast<int>(dice.below(40));
      const Point p = sample_position(i, j, static_cast<int>(dice.below(8)), static_cast<int>(dice.below(8)));
      return Point{p.x + static_cast<int>(dice.below(3)) - 1, p.y + static_cast<int>(dice.below(3)) - 1};
    };
    const Point a = sample();
    const Point b = sample();
    const Point c = sample();
    if (a == b || a == c) continue;
    const double radius = length(Vec2{static_cast<double>(c.x - a.x), static_cast<double>(c.y - a.y)});
    EXPECT_EQ(wrong_samples(best_kernel(), segment_body(a, b, radius)), 0) << "turn " << turn;
    EXPECT_EQ(wrong_samples(best_kernel(), disc(a, radius)), 0) << "turn " << turn;
    EXPECT_EQ(wrong_samples(portable_kernel(), disc(a, radius)), 0) << "turn " << turn;
  }
}

TEST(Kernels, CountSamples) {
  Dice dice(13);
  MaskTiles::Tile masks;
  for (Samples& samples : masks) {
    samples = 0;
    for (std::size_t k = dice.below(65); k > 0; --k) samples |= Samples{1} << dice.below(64);
  }
  masks[0] = 0;
  masks[1] = all_samples;
  std::array<std::uint8_t, std::tuple_size_v<MaskTiles::Tile>> counts{};
  for (const Kernel* kernel : {&portable_kernel(), &best_kernel()}) {
    kernel->count(masks, counts.data());
    for (std::size_t k = 0; k < counts.size(); ++k) {
      int bits = 0;
      for (Samples left = masks[k]; left != 0; left >>= 1U) bits += static_cast<int>(left & 1U);
      EXPECT_EQ(counts[k], bits);
    }
  }
}

}  // namespace
}  // namespace burin::test
