#pragma once

#include <cstddef>
#include <string_view>

namespace burin::output {

/// Where the last block of a deflate stream (RFC 1951) is, in bits from the stream's start.
struct LastBlock {
  std::size_t begin = 0;  ///< of its first bit, which says that it is the last
  std::size_t end = 0;    ///< behind its last bit
};

/// Walks over all codes of a stream without unpacking it, in time by the length of the stream, not of what it stands
/// for. Pre: `stream` is one whole stream, as a compressor made it.
LastBlock last_block(std::string_view stream);

}  // namespace burin::output
