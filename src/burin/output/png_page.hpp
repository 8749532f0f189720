#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <burin/output/png_picture.hpp>

namespace burin::output {

/// Writes row j of a page, PngHead::bytes_per_row() bytes.
using ReadRow = std::function<void(std::uint32_t j, std::uint8_t* bytes)>;

/// A whole page as a PNG file of 8 bits a channel: a mostly blank one through RowDeflater, row by row, others through
/// stb_image_write and libdeflate, with the page in memory. Rows are read from the top, once or twice. Nothing: there
/// is no memory for it. Pre: below 2^31 bytes.
std::optional<std::string> png_page(const PngHead& head, const ReadRow& read_row);

/// The same of a page in memory: all rows from the top, one behind the other.
std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes);

}  // namespace burin::output
