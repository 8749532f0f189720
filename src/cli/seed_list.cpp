#include <algorithm>
#include <charconv>
#include <optional>
#include <random>

#include <fmt/format.h>

#include <cli/seed_list.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view dots = "..";
constexpr std::string_view random_word = "random";

struct Whole {
  std::uint64_t bits = 0;  ///< of a negative number: its two's complement
  bool negative = false;
};

std::optional<std::uint64_t> read_digits(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || stopped != end) return std::nullopt;
  return number;
}

/// A whole number of at most 64 bits.
std::optional<Whole> read_whole(std::string_view text) {
  constexpr std::uint64_t lowest = std::uint64_t{1} << 63U;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::optional<std::uint64_t> size = read_digits(text);
  if (!size || (negative && *size > lowest)) return std::nullopt;
  return Whole{negative ? 0 - *size : *size, negative && *size > 0};
}

bool is_less(const Whole& a, const Whole& b) {
  return a.negative != b.negative ? a.negative : a.bits < b.bits;
}

Problem wrong_seed(std::string_view item) {
  return {
      {},
      fmt::format("--seed must be a whole number of at most 64 bits, a range such as 0..49, 'random', or several of "
                  "these with commas between, not '{}'",
                  item)};
}

}  // namespace

Result<SeedList::Range> SeedList::read_range(std::string_view item) {
  if (item == random_word) return Range{0, 0, Range::Way::random};
  if (item.substr(0, random_word.size() + 1) == "random*") {
    const std::optional<std::uint64_t> times = read_digits(item.substr(random_word.size() + 1));
    if (!times || *times == 0) return wrong_seed(item);
    return Range{0, *times - 1, Range::Way::random};
  }
  const std::size_t at = item.find(dots);
  const std::optional<Whole> first = read_whole(item.substr(0, at));
  const std::optional<Whole> last = at == std::string_view::npos ? first : read_whole(item.substr(at + dots.size()));
  if (!first || !last) return wrong_seed(item);
  if (is_less(*last, *first)) return Range{first->bits, first->bits - last->bits, Range::Way::down};
  return Range{first->bits, last->bits - first->bits, Range::Way::up};
}

Result<SeedList> SeedList::read(std::string_view text) {
  SeedList list;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const Result<Range> range = read_range(text.substr(0, comma));
    if (!range) return range.problems();
    list.ranges_.push_back(*range);
    if (comma == text.size()) return list;
    text.remove_prefix(comma + 1);
  }
}

double SeedList::count() const {
  double count = 0.0;
  for (const Range& range : ranges_) count += static_cast<double>(range.steps) + 1.0;
  return count;
}

std::vector<std::uint64_t> SeedList::all() const {
  std::vector<std::uint64_t> seeds;
  std::random_device device;
  for (const Range& range : ranges_) {
    for (std::uint64_t i = 0; i <= range.steps; ++i) {
      seeds.push_back(range.way == Range::Way::random ? device()
                      : range.way == Range::Way::down ? range.first - i
                                                      : range.first + i);
    }
  }
  return seeds;
}

}  // namespace burin::cli
