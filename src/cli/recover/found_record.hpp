#pragma once

#include <cstddef>
#include <string>

#include <burin/base/result.hpp>
#include <cli/recover/bytes_at.hpp>

namespace burin::cli {

/// Records are made of presets, which have at most 256 KiB; even with every byte escaped six times they are shorter.
inline constexpr std::size_t longest_record_bytes = std::size_t{4} << 20U;

/// The record that origin.hpp describes, as it was written into a file, from the bytes of a file of that format.
/// Problems name `shown` and say what was looked for. Neither reads more than it needs nor holds more than a few
/// megabytes, whatever the file's size.
Result<std::string> record_in_svg(const BytesAt& svg, const std::string& shown);
Result<std::string> record_in_pdf(const BytesAt& pdf, const std::string& shown);
Result<std::string> record_in_png(const BytesAt& png, const std::string& shown);

/// The same for a file of any of these formats, which is told by its first bytes.
Result<std::string> find_record(const BytesAt& file, const std::string& shown);

}  // namespace burin::cli
