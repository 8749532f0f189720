#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/base/executor.hpp>
#include <burin/output/png_stripes.hpp>

namespace burin::output {

/// A whole page as a PNG file of 8 bits a channel: a mostly blank one through RowDeflater, row by row; others through
/// libdeflate, small ones at once by stb_image_write, larger ones by PngStripes, each stripe a task of the executor.
/// Rows are read once or twice, those of stripes perhaps at the same time. The bytes are the same for every executor.
/// Nothing: there is no memory for it. Pre: below 2^31 bytes.
std::optional<std::string> png_page(const PngHead& head, const ReadRow& read_row,
                                    const Executor& executor = SerialExecutor());

/// The same of a page in memory: all rows from the top, one behind the other.
std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes);

}  // namespace burin::output
