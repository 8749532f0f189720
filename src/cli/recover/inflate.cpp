#include <algorithm>
#include <zlib.h>

#include <cli/recover/inflate.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t step_bytes = std::size_t{64} << 10U;

/// zlib's older interface wants a pointer that is not const, which it does not write through.
Bytef* as_input(std::string_view bytes) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

}  // namespace

std::optional<std::string> inflated(std::string_view packed, std::size_t limit) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return std::nullopt;
  std::string bytes;
  int status = Z_OK;
  while (status == Z_OK && bytes.size() <= limit) {
    if (stream.avail_in == 0) {
      const std::size_t some = std::min(packed.size(), step_bytes);
      stream.next_in = as_input(packed);
      stream.avail_in = static_cast<uInt>(some);
      packed.remove_prefix(some);
    }
    const std::size_t before = bytes.size();
    bytes.resize(before + step_bytes);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
    stream.avail_out = static_cast<uInt>(step_bytes);
    status = inflate(&stream, Z_NO_FLUSH);  // Z_BUF_ERROR when the input ends too early
    bytes.resize(bytes.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END || bytes.size() > limit) return std::nullopt;
  return bytes;
}

unsigned long crc32_of(std::string_view bytes) {
  uLong crc = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::size_t some = std::min(bytes.size(), step_bytes);
    crc = crc32(crc, as_input(bytes), static_cast<uInt>(some));
    bytes.remove_prefix(some);
  }
  return crc;
}

}  // namespace burin::cli
