#include <algorithm>
#include <libdeflate.h>
#include <new>

#include <burin/base/check.hpp>
#include <burin/output/deflate.hpp>
#include <burin/output/last_block.hpp>

namespace burin::output {

void Deflater::Free::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

Deflater::Deflater(int level) : compressor_(libdeflate_alloc_compressor(level)) {
  BURIN_EXPECT(level >= 1 && level <= 12);
  if (compressor_ == nullptr) throw std::bad_alloc();
}

Deflater::~Deflater() = default;

std::string_view Deflater::operator()(std::string_view bytes) {
  make_room(libdeflate_zlib_compress_bound(compressor_.get(), bytes.size()));
  const std::size_t size =
      libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(), stream_.get(), stream_room_);
  BURIN_EXPECT(size > 0);
  return {stream_.get(), size};
}

std::string_view Deflater::piece(std::string_view bytes) {
  make_room(libdeflate_deflate_compress_bound(compressor_.get(), bytes.size()) + 1 + no_bytes.size());
  const std::size_t size =
      libdeflate_deflate_compress(compressor_.get(), bytes.data(), bytes.size(), stream_.get(), stream_room_);
  BURIN_EXPECT(size > 0);
  const LastBlock last = last_block({stream_.get(), size});
  stream_[last.begin / 8] = static_cast<char>(stream_[last.begin / 8] & ~(1 << last.begin % 8));
  const std::size_t end = (last.end + 3 + 7) / 8;
  if (end > size) stream_[size] = 0;
  std::copy(no_bytes.begin(), no_bytes.end(), stream_.get() + end);
  return {stream_.get(), end + no_bytes.size()};
}

void Deflater::make_room(std::size_t size) {
  if (size <= stream_room_) return;
  stream_.reset(new char[size]);
  stream_room_ = size;
}

std::string zlib_end(std::uint32_t adler32) {
  std::string bytes("\x03\0", 2);
  for (unsigned shift = 32; shift > 0;) {
    shift -= 8;
    bytes += static_cast<char>(adler32 >> shift & 0xFFU);
  }
  return bytes;
}

std::uint32_t adler32_of(std::string_view bytes, std::uint32_t before) {
  return libdeflate_adler32(before, bytes.data(), bytes.size());
}

std::uint32_t joint_adler32(std::uint32_t first, std::uint32_t behind, std::size_t count) {
  // The low half is 1 and the sum of all bytes, the high half the sum of all low halves, both modulo this.
  constexpr std::uint64_t modulus = 65521;
  const std::uint64_t low = first & 0xFFFFU;
  const std::uint64_t sum = (low + (behind & 0xFFFFU) + modulus - 1) % modulus;
  const std::uint64_t sums = ((first >> 16U) + (behind >> 16U) + count % modulus * (low + modulus - 1)) % modulus;
  return static_cast<std::uint32_t>(sums << 16U | sum);
}

std::uint32_t crc32_of(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace burin::output
