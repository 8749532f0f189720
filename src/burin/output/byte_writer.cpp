#include <cstring>

#include <burin/output/byte_writer.hpp>

namespace burin::output {

ByteWriter::ByteWriter(ByteSink& sink) : sink_(sink), block_(std::make_unique<char[]>(block_size)) {}

void ByteWriter::hand_over(std::string_view text) {
  if (ok_ && !text.empty()) ok_ = sink_.write(text);
}

void ByteWriter::add(std::string_view text) {
  if (text.size() > block_size - used_) {
    hand_over({block_.get(), used_});
    used_ = 0;
  }
  if (text.size() >= block_size) {
    hand_over(text);
    return;
  }
  std::memcpy(block_.get() + used_, text.data(), text.size());
  used_ += text.size();
}

Result<Done> ByteWriter::finish() {
  hand_over({block_.get(), used_});
  used_ = 0;
  if (ok_) return Done{};
  return Problem{{}, "the output could not be written: " + sink_.failure(), Trouble::output};
}

}  // namespace burin::output
