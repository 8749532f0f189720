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
  TileMemory memory;
  MaskTiles tiles(part, memory);
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

/// The pixels that a round segment gets wrong, on a part of the page that begins at (0, 0).
int wrong_pixels(const Kernel& kernel, RoundPen& pen, const RoundSegment& segment) {
  constexpr PixelBox small{0, 0, 32, 24};
  TileMemory memory;
  MaskTiles tiles(small, memory);
  kernel.cover_round(pen, std::array{segment.to, segment.from}, small, tiles);
  int wrong = 0;
  for (int j = 0; j < small.bottom; ++j) {
    for (int i = 0; i < small.right; ++i) {
      const Samples found = *tiles.at(i, j, 0);
      const Samples needed = samples_in(segment_body(segment.from, segment.to, pen.half_width), i, j) |
                             samples_in(disc(segment.to, pen.half_width), i, j);
      const Samples allowed = needed | samples_in(disc(segment.from, pen.half_width), i, j);
      wrong += (needed & ~found) != 0 || (found & ~allowed) != 0 ? 1 : 0;
    }
  }
  return wrong;
}

TEST(Kernels, DrawRoundSegmentsByTheirDefinition) {
  Dice dice(14);
  for (const double half_width : {3.0, 40.5, 512.0, 512.01, 700.0, 3000.0}) {
    RoundPen best(half_width);
    RoundPen portable(half_width);
    for (int turn = 0; turn < 120; ++turn) {
      constexpr double sizes[] = {0.02, 0.1, 0.5, 1.2, 5.0, 12.0};
      const double size = sizes[dice.below(6)];
      const Point from = random_point(dice, 0.0, 24.0);
      Point step = random_point(dice, -size, size);
      if (step == Point{}) step.x = 1;
      const RoundSegment segment{from, {from.x + step.x, from.y + step.y}};
      EXPECT_EQ(wrong_pixels(best_kernel(), best, segment), 0) << half_width << ", turn " << turn;
      EXPECT_EQ(wrong_pixels(portable_kernel(), portable, segment), 0) << half_width << ", turn " << turn;
    }
  }
}

/// Level, upright and along the rows and columns of the samples, from everywhere within a sample's reach.
TEST(Kernels, DrawRoundSegmentsWhoseBordersGoThroughSamples) {
  Dice dice(15);
  for (const double half_width : {8.0, 511.5, 512.0, 512.03, 520.0, 1024.0}) {
    RoundPen pen(half_width);
    for (int turn = 0; turn < 200; ++turn) {
      constexpr Point ways[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {8, -1}, {1, 8}, {1, 1}, {3, 4}};
      const Point way = ways[dice.below(8)];
      const int length = 1 + static_cast<int>(dice.below(way.x * way.y == 0 ? 3000 : 400));
      // Where a border may meet samples, or just miss them.
      const Point sample = sample_position(10, 8, static_cast<int>(dice.below(8)), static_cast<int>(dice.below(8)));
      const Point from{sample.x + static_cast<int>(dice.below(5)) - 2, sample.y + static_cast<int>(dice.below(5)) - 2};
      const RoundSegment segment{from, {from.x + way.x * length, from.y + way.y * length}};
      EXPECT_EQ(wrong_pixels(best_kernel(), pen, segment), 0) << half_width << ", turn " << turn;
    }
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
