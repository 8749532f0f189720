#include <libdeflate.h>
#include <new>

#include <burin/base/check.hpp>
#include <burin/output/deflate.hpp>

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
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor_.get(), bytes.size());
  if (bound > stream_room_) {
    stream_.reset(new char[bound]);
    stream_room_ = bound;
  }
  const std::size_t size =
      libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(), stream_.get(), stream_room_);
  BURIN_EXPECT(size > 0);
  return {stream_.get(), size};
}

std::uint32_t adler32_of(std::string_view bytes, std::uint32_t before) {
  return libdeflate_adler32(before, bytes.data(), bytes.size());
}

std::uint32_t crc32_of(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace burin::output
