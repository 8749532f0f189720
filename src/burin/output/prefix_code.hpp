#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burin::output {

/// Puts bits into bytes from the lowest up, as deflate does.
class BitWriter {
 public:
  explicit BitWriter(std::string& bytes) : bytes_(bytes) {}

  /// Pre: value < 2^count, count <= 16.
  void add(std::uint32_t value, unsigned count) {
    held_ |= static_cast<std::uint64_t>(value) << held_bits_;
    held_bits_ += count;
    if (held_bits_ >= 32) hand_over(4);
  }

  /// Fills the last byte with zeros.
  void finish() { hand_over((held_bits_ + 7) / 8); }

 private:
  void hand_over(unsigned count) {
    std::array<char, 8> low;
    for (unsigned k = 0; k < low.size(); ++k) low[k] = static_cast<char>(held_ >> 8 * k & 0xFFU);
    bytes_.append(low.data(), count);
    held_ >>= 8 * count;
    held_bits_ -= held_bits_ < 8 * count ? held_bits_ : 8 * count;
  }

  std::string& bytes_;
  std::uint64_t held_ = 0;
  unsigned held_bits_ = 0;
};

/// Huffman's code for symbols 0, 1 ... by how often they occur, in the canonical form of RFC 1951.
class PrefixCode {
 public:
  /// No code is longer than `most_bits`: where Huffman's would be, counts are made more alike.
  /// Pre: most_bits <= 15, and there are at most 2^most_bits symbols.
  PrefixCode(std::vector<std::uint32_t> counts, unsigned most_bits);

  /// Bits of each symbol, 0 for those that do not occur. There are always two codes at least: some readers want them.
  const std::vector<std::uint8_t>& lengths() const { return lengths_; }

  void write(BitWriter& bits, std::size_t symbol) const { bits.add(codes_[symbol], lengths_[symbol]); }

 private:
  std::vector<std::uint8_t> lengths_;
  std::vector<std::uint16_t> codes_;
};

/// The head of a dynamic block: both codes, run lengths and all.
void write_codes(BitWriter& bits, const PrefixCode& symbols, const PrefixCode& distances);

}  // namespace burin::output
