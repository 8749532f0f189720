#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin::cli {

/// A zlib stream (RFC 1950) unpacked. Nothing when it is damaged, incomplete, or larger than `limit` bytes. The only
/// file of the tool that names zlib.
std::optional<std::string> inflated(std::string_view packed, std::size_t limit);

/// The CRC-32 of PNG and zlib.
unsigned long crc32_of(std::string_view bytes);

}  // namespace burin::cli
