#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/data/image.hpp>
#include <burin/primitives/primitive.hpp>

namespace burin::primitives {

/// A picture of set and unset pixels, rows from the top.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<bool> set;

  bool at(int column, int row) const {
    return column >= 0 && row >= 0 && column < width && row < height &&
           set[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

/// The most pixels of a bitmap.
inline constexpr int max_bitmap_pixels = 1 << 20;

/// A bitmap from lines of text: '#', 'X', 'x', '*', '@' and '1' are set; '.', ' ', '-', '_' and '0' are not; shorter
/// lines go on unset. Empty lines at the beginning and the end do not count. A problem names the line and the
/// character.
Result<Bitmap> bitmap_from_text(std::string_view text, const Where& where);

/// A bitmap from a picture: pixels that are opaque by half and darker than middle grey are set.
Result<Bitmap> bitmap_from_image(const data::Image& image, const std::string& file);

/// The exact outline of the union of the set pixels as one path of closed contours, filled by the nonzero rule: outer
/// contours run counter-clockwise (y up), holes clockwise, corners only where they turn. Pixels that touch at a corner
/// only stay apart. Pixel (c, r) is the square from (c, -r - 1) to (c + 1, -r). O(pixels).
std::vector<std::vector<Vec2>> outline_of(const Bitmap& bitmap);

/// Column and row of a pixel, from 0 at the top left.
struct PixelPlace {
  int column = 0;
  int row = 0;
};

/// A figure from a bitmap. The anchor is the middle of `anchor`, which may lie beside the bitmap, or of the box of the
/// set pixels; the outline is an area or, painted as a stroke, a line. Nothing when no pixel is set.
std::optional<Primitive> primitive_of(const Bitmap& bitmap, std::optional<PixelPlace> anchor, Paint paint,
                                      std::string name);

}  // namespace burin::primitives
