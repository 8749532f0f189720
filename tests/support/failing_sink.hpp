#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <burin/base/bytes.hpp>

namespace burin::test {

/// A disk with room for so many bytes: the write that does not fit takes what fits and fails, as do all after it.
class FailingSink final : public ByteSink {
 public:
  explicit FailingSink(std::size_t room_bytes) : room_bytes_(room_bytes) {}

  bool write(std::string_view bytes) override {
    if (failed_) {
      ++writes_after_failure_;
      return false;
    }
    failed_ = bytes.size() > room_bytes_;
    text_ += bytes.substr(0, room_bytes_);
    room_bytes_ -= failed_ ? room_bytes_ : bytes.size();
    return !failed_;
  }
  std::string failure() const override { return failed_ ? "No space left on device" : ""; }

  bool failed() const { return failed_; }
  /// A writer that heeds a failure leaves this at 0.
  std::size_t writes_after_failure() const { return writes_after_failure_; }
  const std::string& text() const { return text_; }

 private:
  std::size_t room_bytes_;
  bool failed_ = false;
  std::size_t writes_after_failure_ = 0;
  std::string text_;
};

}  // namespace burin::test
