#pragma once

#include <cstdint>

#include <burin/data/image.hpp>

/// How far two pictures of one size are apart. Pixels are compared as they are stored, in sRGB: in four channels, the
/// colours multiplied by their alpha, and the alpha. All distances are in steps of 255.
namespace burin::measure {

/// The side of the blocks of PictureDifference::block, in pixels.
inline constexpr int block_side = 4;

struct PixelPlace {
  int x = 0;  ///< from the left
  int y = 0;  ///< from the top
  friend bool operator==(PixelPlace, PixelPlace) = default;
};

/// A pixel's difference is that of its worst channel.
struct PictureDifference {
  std::uint64_t pixels = 0;   ///< how many differ at all
  int max = 0;                ///< the largest difference of a pixel
  PixelPlace max_at{};        ///< the first such pixel, row by row
  double mean = 0.0;          ///< over all pixels
  double mean_on_ink = 0.0;   ///< over the pixels that are ink in either picture; 0 without any
  double block = 0.0;         ///< the largest difference of the mean colours of two blocks, wherever they lie
  PixelPlace block_at{};      ///< its top left pixel
  double ink_of_first = 0.0;  ///< the share of pixels that are not paper: of another colour than the most frequent one
  double ink_of_second = 0.0;

  bool is_none() const { return pixels == 0; }
};

/// Blocks are smaller where a picture is. Sums are exact, so the numbers are the same on every machine. O(pixels);
/// memory follows the width and the number of colours. Pre: one size.
PictureDifference picture_difference(const data::Image& first, const data::Image& second);

/// Of two pixels of four bytes, as Image has them.
int pixel_difference(const std::uint8_t* first, const std::uint8_t* second);

}  // namespace burin::measure
