#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
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

/// Takes all of the bytes, or is false from then on.
using WriteBytes = std::function<bool(std::string_view bytes)>;

/// Writes row j of a page, PngHead::bytes_per_row() bytes.
using ReadRow = std::function<void(std::uint32_t j, std::uint8_t* bytes)>;

/// All of a file of 8 bits a channel before its pixels.
std::string file_head(const PngHead& head);

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
