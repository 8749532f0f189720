#include <algorithm>
#include <array>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/measure/picture_difference.hpp>
#include <burin/output/png_page.hpp>
#include <cli/picture_panels.hpp>

namespace burin::cli {

namespace {

using Rgb = std::array<int, 3>;

constexpr int fringe_px = 2;
constexpr int gap_px = 8;
constexpr int ground = 0xB8;
constexpr double screen_dots_per_mm = 96.0 / 25.4;

Rgb on_white(const std::uint8_t* pixel) {
  const int alpha = pixel[3];
  const auto laid = [alpha](int colour) { return (colour * alpha + 255 * (255 - alpha) + 127) / 255; };
  return {laid(pixel[0]), laid(pixel[1]), laid(pixel[2])};
}

/// From 0 to 255,000, by Rec. 709 from the stored values.
int brightness(const Rgb& c) {
  return 213 * c[0] + 715 * c[1] + 72 * c[2];
}

/// Which pixels lie within the fringe of one that differs.
std::vector<bool> fringe_of(const data::Image& first, const data::Image& second) {
  std::vector<bool> near(first.rgba.size() / 4);
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      if (measure::pixel_difference(first.pixel(x, y), second.pixel(x, y)) == 0) continue;
      for (int v = std::max(0, y - fringe_px); v <= std::min(first.height - 1, y + fringe_px); ++v) {
        for (int u = std::max(0, x - fringe_px); u <= std::min(first.width - 1, x + fringe_px); ++u) {
          near[static_cast<std::size_t>(v) * static_cast<std::size_t>(first.width) + static_cast<std::size_t>(u)] =
              true;
        }
      }
    }
  }
  return near;
}

/// A pixel of both pictures, to be seen and not to be in the way.
Rgb pale(const Rgb& first, const Rgb& second, bool in_fringe) {
  const int grey = 190 + (brightness(first) + brightness(second)) / 2 * 65 / 255'000;
  return in_fringe ? Rgb{grey, grey * 92 / 100, grey * 50 / 100} : Rgb{grey, grey, grey};
}

/// Even the smallest difference is seen well.
Rgb mark(const Rgb& first, const Rgb& second, int difference) {
  constexpr Rgb red{214, 0, 28};
  constexpr Rgb blue{0, 76, 214};
  const Rgb full = brightness(second) <= brightness(first) ? red : blue;
  const int strength = 110 + 145 * difference / 255;
  Rgb colour{};
  for (std::size_t c = 0; c < colour.size(); ++c) colour[c] = 255 - (255 - full[c]) * strength / 255;
  return colour;
}

void put(data::Image& picture, std::size_t pixel, const Rgb& colour) {
  for (std::size_t c = 0; c < colour.size(); ++c) picture.rgba[4 * pixel + c] = static_cast<std::uint8_t>(colour[c]);
  picture.rgba[4 * pixel + 3] = 255;
}

}  // namespace

data::Image difference_picture(const data::Image& first, const data::Image& second) {
  BURIN_EXPECT(first.width == second.width && first.height == second.height);
  const std::vector<bool> near = fringe_of(first, second);
  data::Image picture{first.width, first.height, std::vector<std::uint8_t>(first.rgba.size())};
  for (std::size_t i = 0; i < near.size(); ++i) {
    const std::uint8_t* const a = &first.rgba[4 * i];
    const std::uint8_t* const b = &second.rgba[4 * i];
    const int difference = measure::pixel_difference(a, b);
    put(picture, i,
        difference > 0 ? mark(on_white(a), on_white(b), difference) : pale(on_white(a), on_white(b), near[i]));
  }
  return picture;
}

data::Image side_by_side(const std::vector<std::optional<data::Image>>& pictures) {
  int field_width = 0;
  int height = 0;
  for (const std::optional<data::Image>& picture : pictures) {
    if (!picture) continue;
    field_width = std::max(field_width, picture->width);
    height = std::max(height, picture->height);
  }
  BURIN_EXPECT(height > 0);
  const int count = static_cast<int>(pictures.size());
  data::Image all{count * field_width + (count - 1) * gap_px, height, {}};
  const std::size_t pixels = static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height);
  all.rgba.resize(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) put(all, i, {ground, ground, ground});
  int left = 0;
  for (const std::optional<data::Image>& picture : pictures) {
    for (int y = 0; picture && y < picture->height; ++y) {
      const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(all.width);
      for (int x = 0; x < picture->width; ++x) {
        put(all, row + static_cast<std::size_t>(left + x), on_white(picture->pixel(x, y)));
      }
    }
    left += field_width + gap_px;
  }
  return all;
}

std::optional<std::string> png_of(const data::Image& picture) {
  output::PngHead head;
  head.width = static_cast<std::uint32_t>(picture.width);
  head.height = static_cast<std::uint32_t>(picture.height);
  head.pixels = output::PngPixels::rgb;
  head.chunks = output::png_chunks({}, screen_dots_per_mm);
  std::vector<std::uint8_t> rows;
  rows.reserve(picture.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    for (const int channel : on_white(&picture.rgba[i])) rows.push_back(static_cast<std::uint8_t>(channel));
  }
  return output::png_page(head, rows);
}

}  // namespace burin::cli
