#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/output/png_picture.hpp>

namespace burin::output {

/// A whole page as a PNG file of 8 bits a channel, through stb_image_write and libdeflate: several times faster than
/// row by row. `bytes` has all rows from the top, each of PngHead::bytes_per_row(). Nothing: there is no memory for it.
/// Pre: below 2^31 bytes.
std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes);

}  // namespace burin::output
