#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct libdeflate_compressor;

namespace burin::output {

/// Compresses blocks of bytes into zlib streams (RFC 1950), as PDF and PNG hold them, or into pieces of one. One object
/// serves many blocks; its memory is that of the largest block.
class Deflater {
 public:
  /// Pre: 1 <= level <= 12, from fast to small.
  explicit Deflater(int level);
  ~Deflater();

  /// A whole stream for `bytes`. The result is valid until the next call.
  std::string_view operator()(std::string_view bytes);

  /// A piece of a stream for `bytes`, in whole bytes: blocks of deflate (RFC 1951) of which none is the last. A stream
  /// is zlib_start, its pieces, which may have been made at the same time, and zlib_end(). The result as above.
  std::string_view piece(std::string_view bytes);

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };

  void make_room(std::size_t size);

  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::unique_ptr<char[]> stream_;
  std::size_t stream_room_ = 0;
};

/// Before the first piece of a stream: deflate with a window of 32 kB.
inline constexpr std::string_view zlib_start = "\x78\x01";

/// What a stored block of nothing, as pieces end, has behind its three bits of zero and those that fill a byte.
inline constexpr std::string_view no_bytes{"\0\0\xFF\xFF", 4};

/// Behind the last piece: a last block of nothing, and the Adler-32 of all bytes.
std::string zlib_end(std::uint32_t adler32);

/// Adler-32 as zlib streams have it, of all bytes so far; `before` is that of what came before.
std::uint32_t adler32_of(std::string_view bytes, std::uint32_t before = 1);

/// Adler-32 of some bytes and what comes behind them, `count` bytes.
std::uint32_t joint_adler32(std::uint32_t first, std::uint32_t behind, std::size_t count);

/// CRC-32 as PNG has it.
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace burin::output
