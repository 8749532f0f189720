#include <burin/base/check.hpp>
#include <burin/output_cairo/byte_stream.hpp>

namespace burin::output_cairo {

namespace {
constexpr std::size_t buffer_size = 65536;
}

bool ByteStream::write(std::string_view bytes) {
  if (failed_ || closed_) return false;
  buffer_ += bytes;
  return buffer_.size() < buffer_size || flush();
}

bool ByteStream::flush() {
  if (failed_ || closed_) return false;
  if (!buffer_.empty() && !bytes_.write(buffer_)) failed_ = true;
  buffer_.clear();
  return !failed_;
}

std::string ByteStream::failure() const {
  BURIN_EXPECT(failed_);
  const std::string why = bytes_.failure();
  return why.empty() ? "the output takes no more bytes" : why;
}

cairo_status_t write_to_stream(void* stream, const unsigned char* bytes, unsigned int count) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  return static_cast<ByteStream*>(stream)->write(text) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

}  // namespace burin::output_cairo
