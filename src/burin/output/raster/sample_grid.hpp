#pragma once

#include <cstdint>

#include <burin/geom/vec2.hpp>

/// The tiny rasterizer: ink is a set of samples, 64 in each pixel, kept as one bit each.
///
/// A shape covers a sample or it does not; shapes are OR-ed, so that neither their order nor how often a place is drawn
/// over changes a bit. Every decision is exact for the numbers it is made from (see convex.hpp and polygon_fill.hpp),
/// in coordinates of the page: compilers, vector units, tiles and threads cannot disagree about it.
namespace burin::output::raster {

/// Positions are whole 1/1024 pixels, from the page's top left corner, y down.
inline constexpr int units_per_pixel = 1024;

/// The column or row of pixels that a position is in.
constexpr int pixel_of(int units) {
  return units >> 10;
}
static_assert(units_per_pixel == 1 << 10);

struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend constexpr bool operator==(Point, Point) = default;
};

constexpr Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}

/// The nearest position to `p`, in pixels; halves go to the even one. Pre: both coordinates are within 2^20 pixels.
inline Point nearest_point(Vec2 p) {
  // Adding 1.5 * 2^52 leaves no bits for a fraction.
  constexpr double whole = 6755399441055744.0;
  const auto nearest = [](double value) {
    return static_cast<std::int32_t>((value * units_per_pixel + whole) - whole);
  };
  return {nearest(p.x), nearest(p.y)};
}

/// Where the samples are: row r and column c, 0 to 7 each, of pixel (i, j) at x = i + (c + (r + 1/2)/8)/8 and
/// y = j + (r + 1 - (c + 1/2)/8)/8. No two of a pixel share an x or a y: a level or upright edge passes them one by
/// one, where a grid along the axes would jump by eight. In units, all odd multiples of 8.
constexpr int sample_x(int row, int column) {
  return 128 * column + 16 * row + 8;
}
constexpr int sample_y(int row, int column) {
  return 128 * row - 16 * column + 120;
}

/// From a column to the next, and from a row.
inline constexpr int column_x = sample_x(0, 1) - sample_x(0, 0);
inline constexpr int column_y = sample_y(0, 1) - sample_y(0, 0);
inline constexpr int row_x = sample_x(1, 0) - sample_x(0, 0);
inline constexpr int row_y = sample_y(1, 0) - sample_y(0, 0);

/// The samples of one pixel: bit 8 row + column.
using Samples = std::uint64_t;
inline constexpr Samples all_samples = ~Samples{0};

constexpr Samples sample_bit(int row, int column) {
  return Samples{1} << static_cast<unsigned>(8 * row + column);
}

/// The pixels [left, right) x [top, bottom).
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  constexpr int width() const { return right - left; }
  constexpr int height() const { return bottom - top; }
};

}  // namespace burin::output::raster
