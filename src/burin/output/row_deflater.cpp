#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <span>

#include <burin/output/deflate.hpp>
#include <burin/output/png_chunks.hpp>
#include <burin/output/prefix_code.hpp>
#include <burin/output/row_deflater.hpp>

namespace burin::output {

namespace {

constexpr std::uint16_t is_match = 0x8000;
constexpr std::uint16_t is_above = 0x100;
constexpr std::size_t shortest = 4;  ///< a match of 3 costs as much as what it stands for
/// So many bytes more are worth the bits of the greater distance.
constexpr std::size_t worth_a_far_match = 6;
constexpr std::size_t longest = 258;
constexpr std::size_t farthest = 32768;

/// More tokens than one in so many bytes are better searched for all repetitions.
constexpr std::size_t bytes_per_token = 12;
/// What may come at the start of a picture.
constexpr std::size_t free_tokens = 20000;

/// The code of RFC 1951 for a length or a distance: the greatest whose base is not above the value.
struct ValueCode {
  unsigned symbol;
  unsigned extra_bits;
  unsigned extra;
};

ValueCode length_code(unsigned length) {
  if (length == longest) return {285, 0, 0};
  const unsigned value = length - 3;
  if (value < 8) return {257 + value, 0, 0};
  const auto bits = static_cast<unsigned>(std::bit_width(value)) - 3;
  return {257 + 4 * bits + (value >> bits), bits, value & ((1U << bits) - 1U)};
}

ValueCode distance_code(unsigned distance) {
  const unsigned value = distance - 1;
  if (value < 4) return {value, 0, 0};
  const auto bits = static_cast<unsigned>(std::bit_width(value)) - 2;
  return {2 * bits + (value >> bits), bits, value & ((1U << bits) - 1U)};
}

/// The bits in which eight bytes from a and b on differ.
std::uint64_t difference(const std::uint8_t* a, const std::uint8_t* b) {
  std::uint64_t x;
  std::uint64_t y;
  std::memcpy(&x, a, 8);
  std::memcpy(&y, b, 8);
  return x ^ y;
}

/// How many bytes from a and b on are the same, up to `most`.
std::size_t common_bytes(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
  std::size_t count = 0;
  if (most >= 8 && difference(a, b) == 0) {
    for (; count + 32 <= most; count += 32) {
      const std::uint8_t* const x = a + count;
      const std::uint8_t* const y = b + count;
      if ((difference(x, y) | difference(x + 8, y + 8) | difference(x + 16, y + 16) | difference(x + 24, y + 24)) !=
          0) {
        break;
      }
    }
  }
  for (; count + 8 <= most; count += 8) {
    const std::uint64_t differing = difference(a + count, b + count);
    if (differing == 0) continue;
    const int same_bits =
        std::endian::native == std::endian::little ? std::countr_zero(differing) : std::countl_zero(differing);
    return count + static_cast<std::size_t>(same_bits) / 8;
  }
  while (count < most && a[count] == b[count]) ++count;
  return count;
}

}  // namespace

RowDeflater::RowDeflater(std::size_t row_bytes) : row_bytes_(row_bytes), checksum_(adler32_of({})) {}

std::size_t RowDeflater::above(const std::uint8_t* row, std::size_t at, std::size_t other) const {
  if (last_row_.empty() || row_bytes_ > farthest) return 0;
  const std::size_t behind = at + other;
  if (row_bytes_ - behind <= worth_a_far_match) return 0;
  // Most runs end where the line moved, which shows at once.
  if (common_bytes(row + behind, last_row_.data() + behind, worth_a_far_match + 1) <= worth_a_far_match) return 0;
  const std::size_t up = common_bytes(row + at, last_row_.data() + at, row_bytes_ - at);
  return up > other + worth_a_far_match ? up : 0;
}

bool RowDeflater::add(const std::uint8_t* row) {
  // The last run of one byte, of which several places may ask.
  std::size_t run_begin = 0;
  std::size_t run_end = 0;
  const auto left = [&](std::size_t at) -> std::size_t {
    if (run_begin <= at && at < run_end) return run_end - at;
    if (at == 0 || at >= row_bytes_ || row[at] != row[at - 1]) return 0;
    run_begin = at;
    run_end = at + common_bytes(row + at, row + at - 1, row_bytes_ - at);
    return run_end - at;
  };
  for (std::size_t at = 0; at < row_bytes_;) {
    const std::size_t back = left(at);
    // A row of one byte is better begun by it than taken from above.
    const std::size_t soon = at + 2 < row_bytes_ ? 2 + left(at + 2) : 0;
    const std::size_t up = above(row, at, std::max(back, soon));
    const std::size_t length = up > 0 ? up : back;
    if (length < shortest) {
      tokens_.push_back(row[at++]);
    } else {
      add_match(length, up > 0);
      at += length;
    }
  }
  checksum_ = adler32_of({reinterpret_cast<const char*>(row), row_bytes_}, checksum_);
  last_row_.assign(row, row + row_bytes_);
  bytes_ += row_bytes_;
  return tokens_.size() <= free_tokens + bytes_ / bytes_per_token;
}

void RowDeflater::add_match(std::size_t length, bool from_above) {
  while (length > 0) {
    // What is left over must be a match too.
    const std::size_t some = length <= longest ? length : std::min(longest, length - shortest);
    const std::uint16_t flags = from_above ? is_match | is_above : is_match;
    tokens_.push_back(static_cast<std::uint16_t>(flags | (some - 3)));
    length -= some;
  }
}

void RowDeflater::write_block(BitWriter& bits, bool is_last) const {
  constexpr unsigned end_of_block = 256;
  std::array<ValueCode, 256> lengths;
  for (unsigned k = 0; k < lengths.size(); ++k) lengths[k] = length_code(k + 3);
  const std::array<ValueCode, 2> distances = {distance_code(1),
                                              distance_code(static_cast<unsigned>(std::min(row_bytes_, farthest)))};
  std::vector<std::uint32_t> symbol_counts(286);
  std::vector<std::uint32_t> distance_counts(30);
  for (const std::uint16_t token : tokens_) {
    if (token < is_match) {
      ++symbol_counts[token];
    } else {
      ++symbol_counts[lengths[token & 0xFFU].symbol];
      ++distance_counts[distances[(token & is_above) != 0 ? 1 : 0].symbol];
    }
  }
  ++symbol_counts[end_of_block];
  const PrefixCode symbols(symbol_counts, 15);
  const PrefixCode distance_symbols(distance_counts, 15);

  bits.add(is_last ? 1 : 0, 1);
  bits.add(2, 2);  // with codes of its own
  write_codes(bits, symbols, distance_symbols);
  for (const std::uint16_t token : tokens_) {
    if (token < is_match) {
      symbols.write(bits, token);
      continue;
    }
    const ValueCode& length = lengths[token & 0xFFU];
    symbols.write(bits, length.symbol);
    bits.add(length.extra, length.extra_bits);
    const ValueCode& distance = distances[(token & is_above) != 0 ? 1 : 0];
    distance_symbols.write(bits, distance.symbol);
    bits.add(distance.extra, distance.extra_bits);
  }
  symbols.write(bits, end_of_block);
}

std::string RowDeflater::finish() {
  std::string stream(zlib_start);
  BitWriter bits(stream);
  write_block(bits, true);
  bits.finish();
  return stream += big_endian(checksum_);
}

std::string RowDeflater::piece() {
  std::string stream;
  BitWriter bits(stream);
  write_block(bits, false);
  bits.add(0, 3);  // a stored block of nothing fills the byte
  bits.finish();
  return stream += no_bytes;
}

}  // namespace burin::output
