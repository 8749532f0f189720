#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <burin/output/raster/body_table.hpp>
#include <burin/output/raster/kernel.hpp>
#include <burin/output/raster/path_stroker.hpp>

#include "sample_reference.hpp"
#include "support/random_paths.hpp"

/// That lines with round joins have the bits of samples_in(), drawn step by step, by tables of the steps that come
/// often, and many points at once.
namespace burin::test {
namespace {

using namespace output::raster;

constexpr std::array<double, 7> half_widths{3.0, 40.5, 511.5, 512.0, 512.03, 1024.0, 1536.0};

Samples samples_of(const WholeBand& band, int x, int y) {
  Samples samples = 0;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const double sum = static_cast<double>(band.a) * (x + sample_x(row, column)) +
                         static_cast<double>(band.b) * (y + sample_y(row, column));
      if (sum >= band.low && sum <= band.high) samples |= sample_bit(row, column);
    }
  }
  return samples;
}

TEST(BandTable, HasTheSamplesOfItsBandAtEveryCorner) {
  Dice dice(21);
  constexpr int reach = 2500;
  const auto any = [&](int below) {
    return static_cast<int>(dice.below(static_cast<unsigned>(2 * below + 1))) - below;
  };
  for (int turn = 0; turn < 200; ++turn) {
    WholeBand band{any(2500), any(2500), 0.0, 0.0};
    if (turn % 5 == 0) band.a = 0;
    if (turn % 5 == 1) band.b = 0;
    // Also of a single number, at which samples come and go at once.
    const double half = turn % 7 == 0 ? 0.0 : dice.between(0.0, 2e6);
    band.low = std::floor(dice.between(-1e6, 1e6)) - half;
    band.high = std::floor(band.low + half) + half;
    const BandTable table(band, {-reach, -reach, reach, reach});
    for (int k = 0; k < 300; ++k) {
      const int x = k == 0 ? -reach : k == 1 ? reach : any(reach);
      const int y = k == 0 ? -reach : k == 1 ? reach : any(reach);
      ASSERT_EQ(table.samples(table.place(x, y)), samples_of(band, x, y))
          << band.a << " x + " << band.b << " y in " << band.low << " to " << band.high << " at " << x << ", " << y;
    }
  }
}

/// Every number of a band along an axis, where one unit decides.
TEST(BandTable, IsExactAtEveryUnit) {
  for (const WholeBand band : {WholeBand{1, 0, -512.0, 512.0}, {0, -3, -1536.0, 1536.0}, {5, 0, 0.0, 10.0}}) {
    const BandTable table(band, {-2048, -2048, 2048, 2048});
    for (int at = -2048; at <= 2048; ++at) {
      ASSERT_EQ(table.samples(table.place(at, at)), samples_of(band, at, at)) << at;
    }
  }
}

constexpr PixelBox part{0, 0, 64, 48};

/// The pixels that a line of two points gets wrong.
int wrong_pixels(const Kernel& kernel, RoundPen& pen, Point first, Point second) {
  TileMemory memory;
  MaskTiles tiles(part, memory);
  kernel.cover_round(pen, std::array{first, second}, part, tiles);
  const int reach = static_cast<int>(pen.half_width) + 1;
  const auto is_far = [&](int pixel, int one, int other) {
    return pixel < pixel_of(std::min(one, other) - reach) || pixel > pixel_of(std::max(one, other) + reach);
  };
  int wrong = 0;
  for (int j = 0; j < part.bottom; ++j) {
    for (int i = 0; i < part.right; ++i) {
      const MaskTiles::Tile* const tile = tiles.tile(i / MaskTiles::width, j / MaskTiles::height);
      const Samples found = tile == nullptr ? 0 : *tiles.at(i, j, 0);
      if (is_far(i, first.x, second.x) || is_far(j, first.y, second.y)) {
        wrong += found != 0 ? 1 : 0;
        continue;
      }
      const Samples needed =
          samples_in(segment_body(first, second, pen.half_width), i, j) | samples_in(disc(first, pen.half_width), i, j);
      const Samples allowed = needed | samples_in(disc(second, pen.half_width), i, j);
      wrong += (needed & ~found) != 0 || (found & ~allowed) != 0 ? 1 : 0;
    }
  }
  return wrong;
}

/// From anywhere on the part, across tiles and its borders, until steps have their tables and long after.
TEST(RoundLine, OfAStepThatComesOftenIsExact) {
  Dice dice(22);
  for (const double half_width : half_widths) {
    RoundPen pen(half_width);
    for (const Point step : {Point{1200, 0},
                             {0, -1201},
                             {-849, 848},
                             {300, 520},
                             {1, 0},
                             {-1, 1},
                             {8, -1},
                             {-2000, 500},
                             {0, 2560},
                             {4000, 0}}) {
      for (int turn = 0; turn < 2 * RoundStep::uses_for_table; ++turn) {
        const auto within = [&](int pixels) { return static_cast<int>(dice.between(-2.0, pixels + 2.0) * 1024.0); };
        // Half of them on the samples' own positions, and a unit beside.
        Point first{within(part.right), within(part.bottom)};
        if (turn % 2 == 0) {
          first.x = (first.x & ~15) + 8 + static_cast<int>(dice.below(3)) - 1;
          first.y = (first.y & ~15) + 8 + static_cast<int>(dice.below(3)) - 1;
        }
        const Point second{first.x + step.x, first.y + step.y};
        ASSERT_EQ(wrong_pixels(best_kernel(), pen, first, second), 0)
            << half_width << ": " << step.x << ", " << step.y << " from " << first.x << ", " << first.y;
      }
      const Point backwards{-step.x, -step.y};
      const bool has_tables = &best_kernel() != &portable_kernel() && BodyTable::suits(step, half_width);
      EXPECT_EQ(pen.slot(backwards).table != nullptr, has_tables) << half_width << ": " << step.x << ", " << step.y;
    }
  }
}

std::vector<Samples> drawn(const std::vector<Vec2>& points, const StrokeStyle& style, bool closed,
                           std::size_t at_once) {
  Ink ink(part);
  PathStroker stroker(ink, Box2{{0.0, 0.0}, {64.0, 48.0}});
  stroker.set_style(style);
  stroker.begin(closed);
  const std::span<const Vec2> all(points);
  for (std::size_t k = 0; k < points.size(); k += at_once) {
    const std::span<const Vec2> some = all.subspan(k, std::min(at_once, points.size() - k));
    if (at_once == 1) {
      stroker.to(some.front());
    } else {
      stroker.to(some, 1.0);
    }
  }
  stroker.end();
  std::vector<Samples> samples;
  for (int j = 0; j < part.bottom; ++j) {
    for (int i = 0; i < part.right; ++i) samples.push_back(*ink.tiles().at(i, j, 0));
  }
  return samples;
}

/// Points that fall together, leave the page, and leave what can be rounded.
TEST(RoundLine, OfManyPointsAtOnceIsThatOfOneAfterTheOther) {
  Dice dice(23);
  for (int turn = 0; turn < 60; ++turn) {
    std::vector<Vec2> points;
    Vec2 at{dice.between(0.0, 64.0), dice.between(0.0, 48.0)};
    const auto count = 1 + dice.below(600);
    for (unsigned k = 0; k < count; ++k) {
      points.push_back(at);
      if (dice.below(8) != 0) at = at + Vec2{dice.between(-1.5, 1.5), dice.between(-1.5, 1.5)};
      if (turn % 3 == 0 && dice.below(90) == 0) at = {dice.between(-1e9, 1e9), dice.between(-1e280, 1e280)};
      if (turn % 3 == 0 && dice.below(30) == 0) at = {dice.between(0.0, 64.0), dice.between(0.0, 48.0)};
    }
    const bool closed = turn % 2 == 0;
    for (const StrokeStyle& style : {StrokeStyle{.width = 1.0}, {.width = 0.3}, {.width = 2.5, .join = Join::miter}}) {
      const std::vector<Samples> one_by_one = drawn(points, style, closed, 1);
      EXPECT_EQ(drawn(points, style, closed, 1000), one_by_one) << turn;
      EXPECT_EQ(drawn(points, style, closed, 7), one_by_one) << turn;
    }
  }
}

TEST(RoundLine, MakesNoTilesOfRowsThatOthersDraw) {
  Dice dice(24);
  const PixelBox page{0, 0, 256, 256};
  for (const Kernel* kernel : {&best_kernel(), &portable_kernel()}) {
    for (const double half_width : {300.0, 1200.0}) {
      Point at{128 * units_per_pixel, 128 * units_per_pixel};
      std::vector<Point> line{at};
      for (int k = 0; k < 20'000; ++k) {
        // Few steps, so that they get tables.
        const Point step{1500 * (static_cast<int>(dice.below(3)) - 1), 1400 * (static_cast<int>(dice.below(3)) - 1)};
        if (page.left * units_per_pixel < at.x + step.x && at.x + step.x < page.right * units_per_pixel) at.x += step.x;
        if (page.top * units_per_pixel < at.y + step.y && at.y + step.y < page.bottom * units_per_pixel) at.y += step.y;
        line.push_back(at);
      }
      TileMemory memory;
      MaskTiles tiles(page, memory, {.index = 1, .mask = 1});
      RoundPen pen(half_width);
      kernel->cover_round(pen, line, page, tiles);
      int made = 0;
      for (int row = 0; row < tiles.rows(); ++row) {
        for (int column = 0; column < tiles.columns(); ++column) {
          if (tiles.tile(column, row) == nullptr) continue;
          ++made;
          EXPECT_TRUE(tiles.share().has(row * MaskTiles::height)) << row << ' ' << column;
        }
      }
      EXPECT_GT(made, 20);
    }
  }
}

}  // namespace
}  // namespace burin::test
