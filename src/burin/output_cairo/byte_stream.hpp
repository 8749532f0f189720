#pragma once

#include <string>
#include <string_view>

#include <cairo.h>

#include <burin/base/bytes.hpp>

namespace burin::output_cairo {

/// A ByteSink behind a buffer of 64 KiB. The first failed write is kept and nothing is written after it.
class ByteStream {
 public:
  explicit ByteStream(ByteSink& bytes) : bytes_(bytes) {}

  /// False when this or an earlier write failed, or after close().
  bool write(std::string_view bytes);
  /// Hands the buffer over; false as for write().
  bool flush();
  /// Refuses everything from now on: a drawing that was given up must not write while it is taken down.
  void close() { closed_ = true; }

  bool failed() const { return failed_; }
  /// Why, in the words of the ByteSink. Pre: failed().
  std::string failure() const;

 private:
  ByteSink& bytes_;
  std::string buffer_;
  bool failed_ = false;
  bool closed_ = false;
};

/// A cairo_write_func_t whose closure is a ByteStream.
cairo_status_t write_to_stream(void* stream, const unsigned char* bytes, unsigned int count);

}  // namespace burin::output_cairo
