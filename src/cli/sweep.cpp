#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/suggest.hpp>
#include <burin/base/units.hpp>
#include <cli/sweep.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view dots = "..";
/// Whole numbers up to here are exact.
constexpr double most_whole = 0x1p53;

bool is_whole_number(double number) {
  return number == std::floor(number) && std::abs(number) <= most_whole;
}

/// A number with the unit that may follow it: "0.3mm".
struct Measure {
  double number = 0.0;
  std::string_view unit;
};

std::optional<Measure> read_measure(std::string_view text) {
  const std::size_t unit = unit_suffix_begin(text);
  const std::optional<double> number = parse_number(text.substr(0, unit));
  if (!number) return std::nullopt;
  return Measure{*number, text.substr(unit)};
}

/// The decimal that was meant where arithmetic missed it by its rounding: 0.3 for 0.30000000000000004. `size`: of the
/// numbers that were computed with.
std::string meant_text(double number, double size) {
  constexpr int most_decimals = 12;
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  if (size >= 1e15) return shortest_text(number);
  for (int decimals = 0; decimals <= most_decimals; ++decimals) {
    const std::string text = fixed_text(number, decimals);
    const std::optional<double> read = parse_number(text);
    if (read && std::abs(*read - number) <= rounding * size) return text;
  }
  return shortest_text(number);
}

/// Numbers of values between these whole numbers that make every value a whole number, near the one asked for.
std::string counts_that_fit(double span, double asked) {
  constexpr double most_looked_at = 100000.0;
  double below = 2.0;
  double above = span + 1.0;
  for (double steps = 1.0; steps <= std::min(span, most_looked_at); ++steps) {
    if (std::fmod(span, steps) != 0.0) continue;
    if (steps + 1.0 <= asked) below = steps + 1.0;
    if (steps + 1.0 > asked) {
      above = steps + 1.0;
      break;
    }
  }
  return fmt::format(":{} or :{}", shortest_text(below), shortest_text(above));
}

}  // namespace

std::string Sweep::Item::value(std::uint64_t index) const {
  if (steps == 0) return text;
  if (index == 0) return shortest_text(from) + text;
  if (index == steps) return shortest_text(to) + text;
  const double share = static_cast<double>(index) / static_cast<double>(steps);
  return meant_text(from * (1.0 - share) + to * share, std::max(std::abs(from), std::abs(to))) + text;
}

bool Sweep::Item::is_whole() const {
  return steps == 0 || (is_whole_number(from) && is_whole_number(to) &&
                        std::fmod(std::abs(to - from), static_cast<double>(steps)) == 0.0);
}

Result<Sweep::Item> Sweep::read_item(std::string_view text) {
  const std::size_t at = text.find(dots);
  if (text.empty()) return Problem{{}, "a value is missing"};
  if (at == std::string_view::npos) return Item{std::string(text)};
  const std::size_t colon = std::min(text.rfind(':'), text.size());
  const std::optional<Measure> from = read_measure(text.substr(0, at));
  const std::optional<Measure> to = read_measure(text.substr(at + dots.size(), colon - at - dots.size()));
  if (!from || !to || colon < at) {
    return Problem{{}, fmt::format("'{}' is no range; write numbers such as 0.1..0.9:9", text)};
  }
  if (!from->unit.empty() && from->unit != to->unit) {
    return Problem{{}, fmt::format("the ends of '{}' have different units", text)};
  }
  Item item{std::string(to->unit), from->number, to->number, 0};
  if (item.from == item.to) return Problem{{}, fmt::format("both ends of '{}' are the same", text)};
  const double span = std::abs(item.to - item.from);
  if (colon == text.size()) {
    if (!is_whole_number(item.from) || !is_whole_number(item.to) || span > most_whole) {
      return Problem{{}, fmt::format("say how many values '{0}' has: {0}:5", text)};
    }
    item.steps = static_cast<std::uint64_t>(span);
    return item;
  }
  const std::string_view many = text.substr(colon + 1);
  std::uint64_t count = 0;
  const auto [stopped, error] = std::from_chars(many.data(), many.data() + many.size(), count);
  if (error != std::errc() || stopped != many.data() + many.size() || count < 2) {
    return Problem{{}, fmt::format("'{}' is no number of values; a range has 2 or more, its ends included", many)};
  }
  item.steps = count - 1;
  return item;
}

Result<Sweep> Sweep::read(std::string_view text) {
  Sweep sweep;
  sweep.written_ = fmt::format("--sweep {}", text);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    return Problem{{},
                   fmt::format("--sweep needs a knob and its values: --sweep name=1..5 or name=a,b,c, not '{}'", text)};
  }
  sweep.knob_ = text.substr(0, equals);
  if (sweep.knob_ == "seed") return Problem{{}, fmt::format("{}: seeds are listed with --seed", sweep.written_)};
  std::string_view rest = text.substr(equals + 1);
  while (true) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    Result<Item> item = read_item(rest.substr(0, comma));
    if (!item) return Problem{{}, fmt::format("{}: {}", sweep.written_, item.problems().front().message)};
    sweep.items_.push_back(*std::move(item));
    if (comma == rest.size()) return sweep;
    rest.remove_prefix(comma + 1);
  }
}

double Sweep::count() const {
  double count = 0.0;
  for (const Item& item : items_) count += static_cast<double>(item.steps) + 1.0;
  return count;
}

std::vector<std::string> Sweep::values() const {
  std::vector<std::string> all;
  for (const Item& item : items_) {
    for (std::uint64_t i = 0; i <= item.steps; ++i) all.push_back(item.value(i));
  }
  return all;
}

Result<Done> Sweep::fits(const preset::Summary& summary) const {
  std::vector<std::string_view> names;
  for (const preset::KnobInfo& info : summary.knobs) names.push_back(info.name);
  const auto found = std::find(names.begin(), names.end(), knob_);
  if (found == names.end()) {
    return Problem{{written_},
                   names.empty() ? fmt::format("no knob '{}': this preset has no knobs", knob_)
                                 : fmt::format("no knob '{}'{}", knob_, suggestion(knob_, names))};
  }
  if (summary.knobs[static_cast<std::size_t>(found - names.begin())].kind != "whole number") return Done{};
  for (const Item& item : items_) {
    if (item.is_whole()) continue;
    const double asked = static_cast<double>(item.steps) + 1.0;
    std::string message = fmt::format("'{}' takes whole numbers, but {} values from {} to {} have fractions between",
                                      knob_, count_text(asked), shortest_text(item.from), shortest_text(item.to));
    if (is_whole_number(item.from) && is_whole_number(item.to)) {
      message += fmt::format("; {} would fit", counts_that_fit(std::abs(item.to - item.from), asked));
    }
    return Problem{{written_}, message};
  }
  return Done{};
}

}  // namespace burin::cli
