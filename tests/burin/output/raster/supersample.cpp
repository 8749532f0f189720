#include "supersample.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace burin::test {
namespace {

constexpr int samples_a_side = 32;
constexpr int rows_at_once = 16;

/// Where the line at height y (a row of samples) is within `radius` of the segment: the union of three intervals, which
/// is one since the shape is convex.
struct Interval {
  double low = 1e300;
  double high = -1e300;
  void add(double from, double to) {
    if (from > to) return;
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

Interval across(const Line& line, double radius, double y) {
  Interval all;
  for (const Vec2 end : {line.from, line.to}) {
    const double left = radius * radius - (y - end.y) * (y - end.y);
    if (left >= 0.0) all.add(end.x - std::sqrt(left), end.x + std::sqrt(left));
  }
  const Vec2 d = line.to - line.from;
  const double size = length(d);
  if (size == 0.0) return all;
  const Vec2 side{-d.y / size * radius, d.x / size * radius};
  const Vec2 corners[] = {line.from + side, line.to + side, line.to - side, line.from - side};
  for (int k = 0; k < 4; ++k) {
    const Vec2 a = corners[k];
    const Vec2 b = corners[(k + 1) % 4];
    if (a.y == b.y || std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
    const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    all.add(x, x);
  }
  return all;
}

}  // namespace

std::vector<std::uint16_t> supersampled(const std::vector<Line>& lines, double width_px, int width, int height) {
  const double radius = 0.5 * width_px;
  std::vector<std::uint16_t> coverage(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  std::vector<std::uint32_t> bits(static_cast<std::size_t>(width) * samples_a_side * rows_at_once);
  for (int top = 0; top < height; top += rows_at_once) {
    std::fill(bits.begin(), bits.end(), 0U);
    for (const Line& line : lines) {
      const double low = std::min(line.from.y, line.to.y) - radius;
      const double high = std::max(line.from.y, line.to.y) + radius;
      if (high < top || low > top + rows_at_once) continue;
      const int first = std::max(0, static_cast<int>(std::floor((low - top) * samples_a_side)));
      const int last =
          std::min(rows_at_once * samples_a_side - 1, static_cast<int>(std::ceil((high - top) * samples_a_side)));
      for (int row = first; row <= last; ++row) {
        const Interval x = across(line, radius, top + (row + 0.5) / samples_a_side);
        const double most = width * samples_a_side;
        const int from = static_cast<int>(std::ceil(std::clamp(x.low * samples_a_side - 0.5, 0.0, most)));
        const int to = static_cast<int>(std::floor(std::clamp(x.high * samples_a_side - 0.5, -1.0, most - 1.0)));
        std::uint32_t* const words = bits.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
        for (int sample = from; sample <= to;) {
          const int end = std::min(to + 1, (sample / 32 + 1) * 32);
          const std::uint32_t ones = end - sample == 32 ? ~0U : ((1U << (end - sample)) - 1U) << (sample % 32);
          words[sample / 32] |= ones;
          sample = end;
        }
      }
    }
    for (int row = 0; row < rows_at_once * samples_a_side; ++row) {
      const int j = top + row / samples_a_side;
      if (j >= height) break;
      for (int i = 0; i < width; ++i) {
        coverage[static_cast<std::size_t>(j * width + i)] = static_cast<std::uint16_t>(
            coverage[static_cast<std::size_t>(j * width + i)] +
            std::popcount(
                bits[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)]));
      }
    }
  }
  return coverage;
}

double mean_difference(const std::vector<std::uint8_t>& grey, const std::vector<std::uint16_t>& coverage) {
  if (grey.size() != coverage.size()) std::abort();
  double sum = 0.0;
  std::size_t inked = 0;
  for (std::size_t k = 0; k < grey.size(); ++k) {
    if (grey[k] == 255 && coverage[k] == 0) continue;
    ++inked;
    sum += std::abs(255.0 - grey[k] - coverage[k] * (255.0 / (samples_a_side * samples_a_side)));
  }
  return inked == 0 ? 0.0 : sum / static_cast<double>(inked);
}

}  // namespace burin::test
