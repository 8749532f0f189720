#pragma once

#include <memory>
#include <string_view>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>

namespace burin::output {

/// Gathers small pieces of text and hands them to a ByteSink in blocks. The first refusal is kept: the sink is not
/// called again, what is added afterwards is dropped, and finish() reports it.
class ByteWriter {
 public:
  /// `sink` must outlive the writer.
  explicit ByteWriter(ByteSink& sink);

  void add(std::string_view text);
  bool ok() const { return ok_; }
  /// Hands over what is left. The problem names the sink's own words.
  Result<Done> finish();

 private:
  static constexpr std::size_t block_size = std::size_t{1} << 16U;

  void hand_over(std::string_view text);

  ByteSink& sink_;
  std::unique_ptr<char[]> block_;
  std::size_t used_ = 0;
  bool ok_ = true;
};

}  // namespace burin::output
