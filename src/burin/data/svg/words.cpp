#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>

#include <burin/data/svg/words.hpp>

namespace burin::data::svg {

namespace {

constexpr std::string_view blanks = " \t\n\r\f";
constexpr double max_number = 1e12;
constexpr double px_per_inch = 96.0;
constexpr double px_per_em = 16.0;

/// The number that `text` begins with, and how many characters it has; 0: none.
std::pair<double, std::size_t> leading_number(std::string_view text) {
  const std::size_t plus = !text.empty() && text.front() == '+' ? 1 : 0;
  const char first = plus < text.size() ? text[plus] : '\0';
  const bool begins = (first >= '0' && first <= '9') || first == '.' || (first == '-' && plus == 0);
  double value = 0.0;
  if (!begins) return {0.0, 0};
  const auto [end, error] = std::from_chars(text.data() + plus, text.data() + text.size(), value);
  if (error != std::errc{} || !(std::abs(value) <= max_number)) return {0.0, 0};
  return {value, static_cast<std::size_t>(end - text.data())};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_until(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view taken = trimmed(rest.substr(0, end));
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return taken;
}

std::optional<double> take_number(std::string_view& rest) {
  rest = rest.substr(std::min(rest.find_first_not_of(blanks), rest.size()));
  const auto [value, size] = leading_number(rest);
  if (size == 0) return std::nullopt;
  rest.remove_prefix(size);
  rest = rest.substr(std::min(rest.find_first_not_of(blanks), rest.size()));
  if (!rest.empty() && rest.front() == ',') rest.remove_prefix(1);
  return value;
}

std::optional<std::vector<double>> numbers(std::string_view text) {
  std::vector<double> all;
  for (std::string_view rest = trimmed(text); !rest.empty(); rest = trimmed(rest)) {
    const std::optional<double> number = take_number(rest);
    if (!number) return std::nullopt;
    all.push_back(*number);
  }
  return all;
}

std::optional<double> length_px(std::string_view text, double whole) {
  text = trimmed(text);
  const auto [value, size] = leading_number(text);
  if (size == 0) return std::nullopt;
  const std::string_view unit = text.substr(size);
  if (unit.empty()) return value;
  if (unit == "%") return value / 100.0 * whole;
  static constexpr std::array<std::pair<std::string_view, double>, 9> units{{{"px", 1.0},
                                                                             {"mm", px_per_inch / 25.4},
                                                                             {"cm", px_per_inch / 2.54},
                                                                             {"in", px_per_inch},
                                                                             {"pt", px_per_inch / 72.0},
                                                                             {"pc", px_per_inch / 6.0},
                                                                             {"em", px_per_em},
                                                                             {"rem", px_per_em},
                                                                             {"ex", px_per_em / 2.0}}};
  for (const auto& [name, px] : units) {
    if (unit == name) return value * px;
  }
  return std::nullopt;
}

double share(std::string_view text, double otherwise) {
  text = trimmed(text);
  const auto [value, size] = leading_number(text);
  if (size == 0) return otherwise;
  return text.substr(size) == "%" ? value / 100.0 : value;
}

}  // namespace burin::data::svg
