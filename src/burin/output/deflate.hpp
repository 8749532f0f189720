#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

struct libdeflate_compressor;

namespace burin::output {

/// Compresses blocks of bytes into zlib streams (RFC 1950), as PDF and PNG hold them. One object serves many blocks;
/// its memory is that of the largest block.
class Deflater {
 public:
  /// Pre: 1 <= level <= 12, from fast to small.
  explicit Deflater(int level);
  ~Deflater();

  /// A whole stream for `bytes`. The result is valid until the next call.
  std::string_view operator()(std::string_view bytes);

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };

  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::unique_ptr<char[]> stream_;
  std::size_t stream_room_ = 0;
};

/// Adler-32 as zlib streams have it, of all bytes so far; `before` is that of what came before.
std::uint32_t adler32_of(std::string_view bytes, std::uint32_t before = 1);

/// CRC-32 as PNG has it.
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace burin::output
