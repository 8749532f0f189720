#include <algorithm>
#include <cmath>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/measure/page_ink.hpp>

namespace burin::measure {

namespace {

constexpr double dense_share = 0.6;
constexpr std::uint64_t least_ink = 5;  // of 255, of one pixel

std::uint64_t darkness(const data::Image& page, int x, int y) {
  return 255U - page.pixel(x, y)[1];
}

/// Pixels, from the first to before the last.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  double pixels() const { return static_cast<double>(right - left) * static_cast<double>(bottom - top); }
};

std::uint64_t darkness(const data::Image& page, const PixelBox& box) {
  std::uint64_t sum = 0;
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) sum += darkness(page, x, y);
  }
  return sum;
}

double share(std::uint64_t dark, const PixelBox& box) {
  return box.pixels() > 0.0 ? static_cast<double>(dark) / (255.0 * box.pixels()) : 0.0;
}

/// How many rows or columns, counted by `line(i)`, hold no ink.
template <class Line>
int bare(int count, const Line& line) {
  int i = 0;
  while (i < count && line(i) < least_ink) ++i;
  return i;
}

}  // namespace

PageInk page_ink(const data::Image& page, double pixels_per_mm, const Box2& live_mm) {
  BURIN_EXPECT(pixels_per_mm > 0.0);
  const auto pixel = [&](double mm, int most) {
    return static_cast<int>(std::clamp(std::round(mm * pixels_per_mm), 0.0, static_cast<double>(most)));
  };
  const PixelBox live{pixel(live_mm.low.x, page.width), pixel(live_mm.low.y, page.height),
                      pixel(live_mm.high.x, page.width), pixel(live_mm.high.y, page.height)};
  PageInk result;
  result.ink = share(darkness(page, live), live);
  const int side = std::max(1, static_cast<int>(std::round(window_mm * pixels_per_mm)));
  int windows = 0;
  int dense = 0;
  int empty = 0;
  for (int top = live.top; top + side <= live.bottom; top += side) {
    for (int left = live.left; left + side <= live.right; left += side) {
      const PixelBox window{left, top, left + side, top + side};
      const std::uint64_t dark = darkness(page, window);
      const double ink = share(dark, window);
      ++windows;
      if (ink > dense_share) ++dense;
      if (dark < least_ink) ++empty;
      result.darkest = std::max(result.darkest, ink);
    }
  }
  if (windows > 0) {
    result.dense = static_cast<double>(dense) / windows;
    result.empty = static_cast<double>(empty) / windows;
  }
  const auto column = [&](int x) { return darkness(page, {x, 0, x + 1, page.height}); };
  const auto row = [&](int y) { return darkness(page, {0, y, page.width, y + 1}); };
  result.left_mm = bare(page.width, column) / pixels_per_mm;
  result.right_mm = bare(page.width, [&](int i) { return column(page.width - 1 - i); }) / pixels_per_mm;
  result.top_mm = bare(page.height, row) / pixels_per_mm;
  result.bottom_mm = bare(page.height, [&](int i) { return row(page.height - 1 - i); }) / pixels_per_mm;
  return result;
}

}  // namespace burin::measure
