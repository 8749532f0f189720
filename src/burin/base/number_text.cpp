#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>

namespace burin {

std::string shortest_text(double value) {
  BURIN_EXPECT(std::isfinite(value));
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value);
  BURIN_EXPECT(error == std::errc{});
  return {buffer.data(), end};
}

std::string fixed_text(double value, int decimals) {
  BURIN_EXPECT(std::isfinite(value));
  std::array<char, 400> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  BURIN_EXPECT(error == std::errc{});
  std::string text(buffer.data(), end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string count_text(double count) {
  constexpr double most_in_digits = 1e15;
  if (!std::isfinite(count)) return "more than 1e308";
  if (count >= most_in_digits) return fmt::format("{:.1e}", count);
  std::string digits = fixed_text(count, 0);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace burin
