#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <burin/base/result.hpp>

namespace burin {

/// Where a back end puts its bytes: a file, a pipe, a string. Given to the library; it never opens files itself.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Takes all of `bytes` or reports false; after a false the sink stays failed and takes nothing more.
  virtual bool write(std::string_view bytes) = 0;

  /// Why writing failed, in the system's words; empty while it has not.
  virtual std::string failure() const = 0;
};

/// A ByteSink that keeps everything in memory.
class StringSink final : public ByteSink {
 public:
  bool write(std::string_view bytes) override {
    text_ += bytes;
    return true;
  }
  std::string failure() const override { return {}; }
  const std::string& text() const { return text_; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// Reads the whole of the file that a preset calls `name`; the giver decides what names mean. An environment's failure
/// comes back as a problem.
using ReadFile = std::function<Result<std::string>(std::string_view name)>;

}  // namespace burin
