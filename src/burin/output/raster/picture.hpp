#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <burin/output/raster/kernel.hpp>
#include <burin/path/colour.hpp>

namespace burin::output::raster {

/// 0x00RRGGBB.
using Rgb = std::uint32_t;

constexpr Rgb rgb_of(Colour colour) {
  return Rgb{colour.red} << 16U | Rgb{colour.green} << 8U | Rgb{colour.blue};
}
constexpr Colour colour_of(Rgb rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U), static_cast<std::uint8_t>(rgb)};
}

/// An ink over a colour with 0 to 64 samples of a pixel, rounded once. Opacity is from 0 to 1.
std::array<Rgb, 65> shades(Rgb under, Colour ink, double opacity);

/// What a part of the page looks like: paper, and the layers laid on it one after the other. Colours are mixed as they
/// are stored, in sRGB, as Cairo, browsers and PDF viewers do: a line looks as wide here as there.
class Picture {
 public:
  /// `memory`, which must outlive the picture, is best that of the layers.
  Picture(const PixelBox& part, Colour paper, TileMemory& memory) : tiles_(part, memory), paper_(rgb_of(paper)) {}

  /// Lays a layer over the picture, each pixel by its share of samples times `opacity`, and empties it. The mix is in
  /// whole numbers, rounded once.
  void lay_over(MaskTiles& layer, const Kernel& kernel, Colour ink, double opacity);

  /// Row j from the left, in pieces: blank(count) for so many pixels of paper, pixels(span) for others.
  template <class Blank, class Pixels>
  void visit_row(int j, const Blank& blank, const Pixels& pixels) const;

  /// The colours in the row of tiles that j is in, until visit(span) returns false.
  template <class Visit>
  bool visit_colours(int j, const Visit& visit) const;

  const PixelBox& part() const { return tiles_.part(); }

 private:
  Tiles<Rgb> tiles_;
  Rgb paper_;
};

template <class Blank, class Pixels>
void Picture::visit_row(int j, const Blank& blank, const Pixels& pixels) const {
  constexpr std::size_t tile_width = Tiles<Rgb>::width;
  const int top = j - part().top;
  const std::size_t in_tile = static_cast<std::size_t>(top % Tiles<Rgb>::height) * tile_width;
  const auto width = static_cast<std::size_t>(part().width());
  std::size_t blank_from = 0;
  std::size_t left = 0;
  for (const Tiles<Rgb>::Tile* const tile : tiles_.tiles_of(top / Tiles<Rgb>::height)) {
    if (tile != nullptr) {
      if (blank_from < left) blank(left - blank_from);
      blank_from = std::min(left + tile_width, width);
      pixels(std::span<const Rgb>(*tile).subspan(in_tile, blank_from - left));
    }
    left += tile_width;
  }
  if (blank_from < width) blank(width - blank_from);
}

template <class Visit>
bool Picture::visit_colours(int j, const Visit& visit) const {
  for (int column = 0; column < tiles_.columns(); ++column) {
    const Tiles<Rgb>::Tile* const tile = tiles_.tile(column, (j - part().top) / Tiles<Rgb>::height);
    if (tile != nullptr && !visit(std::span<const Rgb>(*tile))) return false;
  }
  return true;
}

}  // namespace burin::output::raster
