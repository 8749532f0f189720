#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <burin/output_cairo/byte_stream.hpp>

namespace burin::output_cairo {

struct PngText {
  std::string keyword;
  std::string text;  ///< UTF-8
};

/// A picture in memory and what is said about it.
struct PngPicture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool grey = false;            ///< all pixels have red = green = blue: write one channel
  const unsigned char* rows{};  ///< 32 bits a pixel as in CAIRO_FORMAT_RGB24
  std::size_t bytes_per_row = 0;
  std::uint32_t dots_per_metre = 0;
  std::vector<PngText> texts{};
};

/// Writes the picture as an sRGB PNG. Texts of Latin-1 go into tEXt chunks, others into iTXt. False: the stream failed
/// (which it remembers) or there was no memory.
bool write_png(const PngPicture& picture, ByteStream& to);

}  // namespace burin::output_cairo
