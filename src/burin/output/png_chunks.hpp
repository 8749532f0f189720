#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <burin/path/sheet.hpp>

namespace burin::output {

/// A chunk of a PNG file: its type in four letters and its data.
struct PngChunk {
  std::string type;
  std::string data;
};

/// What every PNG of ours says about itself, to stand between IHDR and PLTE: sRGB, pHYs, and the texts Title, Author,
/// Description, Software and burin-origin (the origin's record). Texts of Latin-1 go into tEXt, others into iTXt.
std::vector<PngChunk> png_chunks(const Origin& origin, double dots_per_mm);

/// A chunk as it stands in a file: with its length and its checksum.
std::string chunk_bytes(const PngChunk& chunk);

/// The four bytes of a number, as PNG has them.
std::string big_endian(std::uint32_t number);

}  // namespace burin::output
