#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include <burin/output/prefix_code.hpp>

namespace burin::output {

namespace {

/// The depths of Huffman's tree, 0 for counts of 0. Pre: at least two counts are above 0.
std::vector<std::uint8_t> tree_depths(const std::vector<std::uint32_t>& counts) {
  // Leaves first, then inner nodes in the order that they are made in: parents come after their children. Ties go to
  // the lower number, so that the tree does not depend on the queue.
  using Node = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
  std::vector<std::size_t> parents(counts.size(), 0);
  for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
    if (counts[symbol] > 0) open.emplace(counts[symbol], symbol);
  }
  while (open.size() > 1) {
    const Node one = open.top();
    open.pop();
    const Node other = open.top();
    open.pop();
    parents[one.second] = parents[other.second] = parents.size();
    open.emplace(one.first + other.first, parents.size());
    parents.push_back(0);
  }
  std::vector<std::uint8_t> depths(parents.size(), 0);
  for (std::size_t node = parents.size() - 1; node-- > 0;) {
    if (parents[node] != 0) depths[node] = static_cast<std::uint8_t>(depths[parents[node]] + 1);
  }
  depths.resize(counts.size());
  return depths;
}

std::uint16_t reversed(unsigned code, unsigned bits) {
  unsigned all = 0;
  for (unsigned k = 0; k < bits; ++k) all |= (code >> k & 1U) << (bits - 1 - k);
  return static_cast<std::uint16_t>(all);
}

/// A run of code lengths in the alphabet of RFC 1951, 3.2.7.
struct LengthToken {
  std::uint8_t symbol;
  std::uint8_t extra;
};

constexpr unsigned repeat_last = 16;
constexpr unsigned few_zeros = 17;
constexpr unsigned many_zeros = 18;

unsigned extra_bits(unsigned symbol) {
  return symbol == repeat_last ? 2 : symbol == few_zeros ? 3 : symbol == many_zeros ? 7 : 0;
}

std::vector<LengthToken> length_tokens(const std::vector<std::uint8_t>& lengths) {
  std::vector<LengthToken> tokens;
  const auto add = [&](unsigned symbol, std::size_t extra) {
    tokens.push_back({static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra)});
  };
  for (std::size_t at = 0; at < lengths.size();) {
    std::size_t run = 1;
    while (at + run < lengths.size() && lengths[at + run] == lengths[at]) ++run;
    const std::uint8_t length = lengths[at];
    if (length == 0 && run >= 3) {
      run = std::min<std::size_t>(run, 138);
      if (run <= 10) add(few_zeros, run - 3);
      if (run > 10) add(many_zeros, run - 11);
    } else if (run >= 4) {
      run = std::min<std::size_t>(run, 7);
      add(length, 0);
      add(repeat_last, run - 4);
    } else {
      run = 1;
      add(length, 0);
    }
    at += run;
  }
  return tokens;
}

std::size_t used(const std::vector<std::uint8_t>& lengths, std::size_t least) {
  std::size_t count = lengths.size();
  while (count > least && lengths[count - 1] == 0) --count;
  return count;
}

}  // namespace

PrefixCode::PrefixCode(std::vector<std::uint32_t> counts, unsigned most_bits) : codes_(counts.size()) {
  auto present = std::count_if(counts.begin(), counts.end(), [](std::uint32_t count) { return count > 0; });
  for (std::size_t symbol = 0; present < 2; ++symbol) {
    if (counts[symbol] > 0) continue;
    counts[symbol] = 1;
    ++present;
  }
  lengths_ = tree_depths(counts);
  while (*std::max_element(lengths_.begin(), lengths_.end()) > most_bits) {
    for (std::uint32_t& count : counts) count = (count + 1) / 2;
    lengths_ = tree_depths(counts);
  }
  unsigned code = 0;
  for (unsigned bits = 1; bits <= most_bits; ++bits, code <<= 1U) {
    for (std::size_t symbol = 0; symbol < lengths_.size(); ++symbol) {
      if (lengths_[symbol] == bits) codes_[symbol] = reversed(code++, bits);
    }
  }
}

void write_codes(BitWriter& bits, const PrefixCode& symbols, const PrefixCode& distances) {
  constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
  const std::size_t symbol_count = used(symbols.lengths(), 257);
  const std::size_t distance_count = used(distances.lengths(), 1);
  std::vector<std::uint8_t> lengths(symbols.lengths().begin(),
                                    symbols.lengths().begin() + static_cast<std::ptrdiff_t>(symbol_count));
  lengths.insert(lengths.end(), distances.lengths().begin(),
                 distances.lengths().begin() + static_cast<std::ptrdiff_t>(distance_count));
  const std::vector<LengthToken> tokens = length_tokens(lengths);
  std::vector<std::uint32_t> counts(order.size());
  for (const LengthToken& token : tokens) ++counts[token.symbol];
  const PrefixCode code(counts, 7);
  std::size_t code_count = order.size();
  while (code_count > 4 && code.lengths()[order[code_count - 1]] == 0) --code_count;
  bits.add(static_cast<std::uint32_t>(symbol_count - 257), 5);
  bits.add(static_cast<std::uint32_t>(distance_count - 1), 5);
  bits.add(static_cast<std::uint32_t>(code_count - 4), 4);
  for (std::size_t k = 0; k < code_count; ++k) bits.add(code.lengths()[order[k]], 3);
  for (const LengthToken& token : tokens) {
    code.write(bits, token.symbol);
    bits.add(token.extra, extra_bits(token.symbol));
  }
}

}  // namespace burin::output
