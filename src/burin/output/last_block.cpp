#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <burin/base/check.hpp>
#include <burin/output/last_block.hpp>

namespace burin::output {

namespace {

constexpr unsigned end_of_block = 256;

/// The bits of a stream from the lowest up; zeros behind its end.
class BitReader {
 public:
  explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

  std::size_t at() const { return at_; }
  bool is_inside() const { return at_ <= 8 * bytes_.size(); }

  /// The next 57 bits or more.
  std::uint64_t peek() const {
    const std::size_t first = at_ / 8;
    std::array<std::uint8_t, 8> some{};
    if (first + some.size() <= bytes_.size()) {
      std::memcpy(some.data(), bytes_.data() + first, some.size());
    } else if (first < bytes_.size()) {
      std::memcpy(some.data(), bytes_.data() + first, bytes_.size() - first);
    }
    std::uint64_t bits = 0;
    for (unsigned k = 0; k < some.size(); ++k) bits |= std::uint64_t{some[k]} << (8 * k);
    return bits >> (at_ % 8);
  }
  void skip(std::size_t count) { at_ += count; }
  void skip_to_byte() { at_ = (at_ + 7) / 8 * 8; }
  /// Pre: count <= 16.
  unsigned take(unsigned count) {
    const auto bits = static_cast<unsigned>(peek() & ((1U << count) - 1U));
    skip(count);
    return bits;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

constexpr std::uint8_t no_code = 0xFF;

/// A table of what is to be known of a symbol, in a byte, by the bits that begin with its code. A symbol's code has
/// lengths[symbol] bits, 0 for none; entry(symbol, bits) is what is known. Pre: the table has 2^n
/// entries, and no length is above n.
template <class Entry>
void fill_table(std::span<std::uint8_t> table, std::span<const std::uint8_t> lengths, const Entry& entry) {
  table[0] = no_code;
  unsigned code = 0;
  std::size_t size = 1;
  for (unsigned bits = 1; size < table.size(); ++bits, code <<= 1U, size *= 2) {
    std::copy_n(table.begin(), size, table.begin() + static_cast<std::ptrdiff_t>(size));
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] != bits) continue;
      // Codes come from their highest bit on.
      std::size_t place = 0;
      for (unsigned k = 0; k < bits; ++k) place |= std::size_t{code >> k & 1U} << (bits - 1 - k);
      ++code;
      table[place] = entry(symbol, bits);
    }
  }
}

unsigned extra_bits_of_length(std::size_t symbol) {
  return symbol < 265 || symbol == 285 ? 0 : static_cast<unsigned>(symbol - 261) / 4;
}

unsigned extra_bits_of_distance(std::size_t symbol) {
  return symbol < 4 ? 0 : static_cast<unsigned>(symbol - 2) / 2;
}

/// How many bits the codes for literals and lengths have, and those for distances.
struct CodeLengths {
  std::vector<std::uint8_t> symbols;
  std::vector<std::uint8_t> distances;
};

CodeLengths fixed_lengths() {
  CodeLengths all{std::vector<std::uint8_t>(288, 8), std::vector<std::uint8_t>(32, 5)};
  std::fill(all.symbols.begin() + 144, all.symbols.begin() + 256, std::uint8_t{9});
  std::fill(all.symbols.begin() + 256, all.symbols.begin() + 280, std::uint8_t{7});
  return all;
}

CodeLengths read_lengths(BitReader& bits) {
  constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
  const std::size_t symbol_count = bits.take(5) + 257;
  const std::size_t distance_count = bits.take(5) + 1;
  const std::size_t code_count = bits.take(4) + 4;
  std::array<std::uint8_t, 19> code_lengths{};
  for (std::size_t k = 0; k < code_count; ++k) code_lengths[order[k]] = static_cast<std::uint8_t>(bits.take(3));
  std::array<std::uint8_t, 128> codes;
  fill_table(codes, code_lengths,
             [](std::size_t symbol, unsigned length) { return static_cast<std::uint8_t>(symbol << 3U | length); });
  std::vector<std::uint8_t> lengths;
  while (lengths.size() < symbol_count + distance_count) {
    const std::uint8_t entry = codes[bits.peek() % codes.size()];
    BURIN_EXPECT(entry != no_code);
    bits.skip(entry & 7U);
    const unsigned symbol = entry >> 3U;
    if (symbol < 16) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
    } else if (symbol == 16) {
      BURIN_EXPECT(!lengths.empty());
      lengths.insert(lengths.end(), 3 + bits.take(2), std::uint8_t{lengths.back()});
    } else {
      lengths.insert(lengths.end(), symbol == 17 ? 3 + bits.take(3) : 11 + bits.take(7), std::uint8_t{0});
    }
  }
  const auto distances = lengths.begin() + static_cast<std::ptrdiff_t>(symbol_count);
  return {{lengths.begin(), distances}, {distances, lengths.end()}};
}

void skip_stored(BitReader& bits) {
  bits.skip_to_byte();
  const std::size_t count = bits.take(16);
  bits.skip(16 + 8 * count);
}

/// What is known of a symbol: the bits of its code and of what belongs to it; and what it is.
constexpr std::uint8_t bit_count = 0x1F;
constexpr std::uint8_t is_length = 0x20;
constexpr std::uint8_t is_end = 0x40;

void skip_coded(BitReader& bits, const CodeLengths& lengths) {
  const unsigned most_bits = std::max(*std::max_element(lengths.symbols.begin(), lengths.symbols.end()),
                                      *std::max_element(lengths.distances.begin(), lengths.distances.end()));
  const std::size_t size = std::size_t{1} << most_bits;
  // Two tables in one, so that what comes next, a distance or not, is no branch: it could not be foretold.
  std::vector<std::uint8_t> tables(2 * size);
  fill_table(std::span(tables).first(size), lengths.symbols, [](std::size_t symbol, unsigned length) {
    if (symbol == end_of_block) return static_cast<std::uint8_t>(is_end | length);
    if (symbol < end_of_block) return static_cast<std::uint8_t>(length);
    return static_cast<std::uint8_t>(is_length | (length + extra_bits_of_length(symbol)));
  });
  fill_table(std::span(tables).last(size), lengths.distances, [](std::size_t symbol, unsigned length) {
    return static_cast<std::uint8_t>(length + extra_bits_of_distance(symbol));
  });
  std::size_t table = 0;
  while (bits.is_inside()) {
    const std::uint64_t next = bits.peek();
    const std::uint8_t one = tables[table + (next & (size - 1))];
    std::size_t count = one & bit_count;
    table = size * ((one & is_length) / is_length);
    // A length and a distance with all their bits are sure to be in what was read.
    const std::uint8_t other = tables[table + (next >> count & (size - 1))];
    if (((one | other) & is_end) != 0) return bits.skip((one & is_end) != 0 ? count : count + (other & bit_count));
    count += other & bit_count;
    table = size * ((other & is_length) / is_length);
    bits.skip(count);
  }
}

}  // namespace

LastBlock last_block(std::string_view stream) {
  BitReader bits(stream);
  for (;;) {
    const std::size_t begin = bits.at();
    const bool is_last = bits.take(1) == 1;
    const unsigned kind = bits.take(2);
    if (kind == 0) {
      skip_stored(bits);
    } else {
      skip_coded(bits, kind == 1 ? fixed_lengths() : read_lengths(bits));
    }
    BURIN_EXPECT(bits.is_inside());
    if (is_last) return {begin, bits.at()};
  }
}

}  // namespace burin::output
