#pragma once

#include <array>
#include <cstdint>

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
  Picture(const PixelBox& part, Colour paper) : tiles_(part), paper_(rgb_of(paper)) {}

  /// Lays a layer over the picture, each pixel by its share of samples times `opacity`, and empties it. The mix is in
  /// whole numbers, rounded once.
  void lay_over(MaskTiles& layer, const Kernel& kernel, Colour ink, double opacity);

  /// The pixels of row j, in all of the part's columns.
  void read_row(int j, Rgb* row) const;

  const PixelBox& part() const { return tiles_.part(); }

 private:
  Tiles<Rgb> tiles_;
  Rgb paper_;
};

}  // namespace burin::output::raster
