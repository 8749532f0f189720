#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::data {

/// A picture in memory: rows from the top, four bytes a pixel: red, green, blue and alpha, not premultiplied. Colours
/// are as the file stores them and are meant in sRGB.
struct Image {
  int width = 0;   ///< pixels, at least 1
  int height = 0;  ///< pixels, at least 1
  std::vector<std::uint8_t> rgba;

  /// The four bytes of a pixel. Pre: inside.
  const std::uint8_t* pixel(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
  friend bool operator==(const Image&, const Image&) = default;
};

/// The most pixels that are read: 256 MiB as an Image.
inline constexpr std::uint64_t max_image_pixels = std::uint64_t{1} << 26U;

/// Reads a PNG of any kind: grey, colours or palette, 1 to 16 bits (rounded to 8), interlaced or not, with alpha or a
/// transparent colour. Gamma, colour profiles and what follows the last chunk are left aside. Problems name `file`: no
/// PNG, damaged (a checksum is wrong), cut short, or more than max_image_pixels (Trouble::limit). Memory follows the
/// pixels, and a file too short for the size it claims is refused before any is taken.
Result<Image> read_png(std::string_view bytes, const std::string& file);

}  // namespace burin::data
