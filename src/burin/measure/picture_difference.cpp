#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <vector>

#include <burin/base/check.hpp>
#include <burin/measure/picture_difference.hpp>

namespace burin::measure {

namespace {

using Channels = std::array<int, 4>;

/// The colours multiplied by their alpha, and the alpha.
Channels channels(const std::uint8_t* pixel) {
  const int alpha = pixel[3];
  const auto covered = [alpha](int colour) { return (colour * alpha + 127) / 255; };
  return {covered(pixel[0]), covered(pixel[1]), covered(pixel[2]), alpha};
}

std::uint32_t key(const Channels& c) {
  std::uint32_t bits = 0;
  for (const int channel : c) bits = bits << 8U | static_cast<std::uint32_t>(channel);
  return bits;
}

/// The colour that most pixels have; of several the smallest key.
std::uint32_t paper_of(const data::Image& image) {
  std::unordered_map<std::uint32_t, std::uint64_t> counts;
  const std::size_t bytes = image.rgba.size();
  for (std::size_t i = 0; i < bytes;) {
    const std::uint32_t colour = key(channels(&image.rgba[i]));
    std::uint64_t run = 0;
    for (; i < bytes && key(channels(&image.rgba[i])) == colour; i += 4) ++run;
    counts[colour] += run;
  }
  const auto rarer = [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first > b.first;
  };
  return std::max_element(counts.begin(), counts.end(), rarer)->first;
}

/// Signed differences of the channels summed over the last rows of each column, from which the blocks that end in a row
/// follow.
class Blocks {
 public:
  Blocks(int width, int height)
      : columns_(std::min(width, block_side)),
        rows_(std::min(height, block_side)),
        sums_(static_cast<std::size_t>(width)) {}

  void add(int x, const Channels& difference) { change(x, difference, 1); }
  void take_away(int x, const Channels& difference) { change(x, difference, -1); }
  int rows() const { return rows_; }

  /// Looks at the blocks whose last row is `y`.
  void finish_row(int y, PictureDifference& difference) const {
    if (y + 1 < rows_) return;
    Channels block{};
    const int width = static_cast<int>(sums_.size());
    for (int x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < block.size(); ++c) {
        block[c] += sums_[static_cast<std::size_t>(x)][c];
        if (x >= columns_) block[c] -= sums_[static_cast<std::size_t>(x - columns_)][c];
      }
      if (x + 1 < columns_) continue;
      int worst = 0;
      for (const int sum : block) worst = std::max(worst, std::abs(sum));
      const double mean = static_cast<double>(worst) / (columns_ * rows_);
      if (mean > difference.block) {
        difference.block = mean;
        difference.block_at = {x + 1 - columns_, y + 1 - rows_};
      }
    }
  }

 private:
  void change(int x, const Channels& difference, int sign) {
    Channels& sum = sums_[static_cast<std::size_t>(x)];
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += sign * difference[c];
  }

  int columns_;
  int rows_;
  std::vector<Channels> sums_;
};

Channels minus(const Channels& a, const Channels& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

int worst_of(const Channels& difference) {
  int worst = 0;
  for (const int channel : difference) worst = std::max(worst, std::abs(channel));
  return worst;
}

}  // namespace

int pixel_difference(const std::uint8_t* first, const std::uint8_t* second) {
  return worst_of(minus(channels(first), channels(second)));
}

PictureDifference picture_difference(const data::Image& first, const data::Image& second) {
  BURIN_EXPECT(first.width == second.width && first.height == second.height);
  const std::uint32_t first_paper = paper_of(first);
  const std::uint32_t second_paper = paper_of(second);
  PictureDifference result;
  Blocks blocks(first.width, first.height);
  std::uint64_t sum = 0;
  std::uint64_t sum_on_ink = 0;
  std::uint64_t first_ink = 0;
  std::uint64_t second_ink = 0;
  std::uint64_t any_ink = 0;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      if (y >= blocks.rows()) {
        const int gone = y - blocks.rows();
        blocks.take_away(x, minus(channels(first.pixel(x, gone)), channels(second.pixel(x, gone))));
      }
      const Channels a = channels(first.pixel(x, y));
      const Channels b = channels(second.pixel(x, y));
      const Channels apart = minus(a, b);
      blocks.add(x, apart);
      const int worst = worst_of(apart);
      if (worst > result.max) {
        result.max = worst;
        result.max_at = {x, y};
      }
      const bool ink_in_first = key(a) != first_paper;
      const bool ink_in_second = key(b) != second_paper;
      result.pixels += worst > 0 ? 1 : 0;
      first_ink += ink_in_first ? 1 : 0;
      second_ink += ink_in_second ? 1 : 0;
      sum += static_cast<std::uint64_t>(worst);
      if (ink_in_first || ink_in_second) {
        ++any_ink;
        sum_on_ink += static_cast<std::uint64_t>(worst);
      }
    }
    blocks.finish_row(y, result);
  }
  const auto pixels = static_cast<double>(first.rgba.size() / 4);
  result.mean = static_cast<double>(sum) / pixels;
  result.mean_on_ink = any_ink > 0 ? static_cast<double>(sum_on_ink) / static_cast<double>(any_ink) : 0.0;
  result.ink_of_first = static_cast<double>(first_ink) / pixels;
  result.ink_of_second = static_cast<double>(second_ink) / pixels;
  return result;
}

}  // namespace burin::measure
