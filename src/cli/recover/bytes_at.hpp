#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <burin/base/result.hpp>

namespace burin::cli {

/// Bytes that can be read anywhere, so that a file of any size need not be held in memory.
struct BytesAt {
  std::uint64_t size = 0;
  /// The bytes [offset, offset + count); fewer at the end and where reading fails.
  std::function<std::string(std::uint64_t offset, std::size_t count)> read;
};

/// Those of a text, which is copied.
BytesAt bytes_of(std::string text);

/// Those of a regular file, which stays open.
Result<BytesAt> bytes_of_file(const std::string& path);

/// The bytes from first to last, through a window of constant size.
class ByteStreamIn {
 public:
  explicit ByteStreamIn(const BytesAt& bytes) : bytes_(bytes) {}

  /// Whether all bytes were taken.
  bool at_end() { return at_ == window_.size() && !refill(); }
  /// The next byte, which stays; 0 at the end.
  char peek() { return at_end() ? '\0' : window_[at_]; }
  /// The next byte; 0 at the end.
  char take() { return at_end() ? '\0' : window_[at_++]; }

  /// Takes everything to the end of the next `mark`. False: there is none, and everything was taken. What stands before
  /// the mark goes to `kept` if given, as far as the first `limit` bytes.
  bool take_past(std::string_view mark, std::string* kept = nullptr, std::size_t limit = 0);

 private:
  bool refill();

  const BytesAt& bytes_;
  std::uint64_t next_ = 0;  ///< offset behind the window
  std::string window_;
  std::size_t at_ = 0;
};

}  // namespace burin::cli
