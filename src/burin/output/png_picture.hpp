#pragma once

#include <cstdint>
#include <vector>

#include <burin/output/png_chunks.hpp>
#include <burin/path/back_end.hpp>
#include <burin/path/colour.hpp>

namespace burin::output {

/// How the pixels of a PNG are stored.
enum class PngPixels : std::uint8_t {
  grey,     ///< one byte
  rgb,      ///< three bytes
  palette,  ///< one byte, an index into PngHead::palette
};

/// All of a PNG but its pixels.
struct PngHead {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  PngPixels pixels = PngPixels::grey;
  std::vector<Colour> palette{};  ///< at most 256
  std::vector<PngChunk> chunks{};

  std::size_t bytes_per_row() const { return std::size_t{width} * (pixels == PngPixels::rgb ? 3 : 1); }
};

/// A page in whole pixels; doubles, since it may be too large for anything else.
struct PngSize {
  double width = 1.0;
  double height = 1.0;
};

/// Rounded to the nearest, at least one a side.
PngSize png_size(const Page& page, double dots_per_mm);

/// How far a line may be drawn from where it is, as a BackEnd states it. Half a pixel would hide the shapes, but a
/// crinkled line loses ink with them, a thin one most: 0.08 of a pixel, less for pens of less than a pixel.
double png_tolerance_mm(const Sheet& sheet, const OutputOptions& options);

/// Whether the paper and every pen are.
bool all_grey(const Sheet& sheet);

}  // namespace burin::output
