#include <algorithm>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/utf8.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

constexpr char32_t replacement = 0xFFFD;

bool is_blank(char32_t code) {
  return code == '\t' || code == '\n' || code == '\r';
}

bool is_plain(char c) {
  return (c >= ' ' && c <= '~') || is_blank(static_cast<unsigned char>(c));
}

std::string literal_string(std::string_view text) {
  std::string literal = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') literal += '\\';
    literal += c == '\r' ? std::string("\\r") : std::string(1, c);  // a reader turns a bare one into a line feed
  }
  return literal + ')';
}

std::string utf16_text(char32_t code) {
  if (code < 0x10000) return fmt::format("{:04X}", static_cast<unsigned>(code));
  const auto bits = static_cast<unsigned>(code) - 0x10000U;
  return fmt::format("{:04X}{:04X}", 0xD800U + (bits >> 10U), 0xDC00U + (bits & 0x3FFU));
}

}  // namespace

std::string text_string(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_plain)) return literal_string(text);
  std::string hexadecimal = "<FEFF";
  while (!text.empty()) {
    const auto [code, length] = first_utf8_character(text);
    const bool carried = length > 0 && (code >= 0x20 || is_blank(code)) && code != 0x7F;
    hexadecimal += utf16_text(carried ? code : replacement);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return hexadecimal + '>';
}

std::string name_text(std::string_view name) {
  constexpr std::string_view delimiters = "()<>[]{}/%#";
  std::string text = "/";
  for (const char c : name) {
    const bool regular = c > ' ' && c <= '~' && delimiters.find(c) == std::string_view::npos;
    text += regular ? std::string(1, c) : fmt::format("#{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return text;
}

std::string number_text(double value, int decimals) {
  std::string text = fixed_text(value, decimals);
  const std::size_t zero = text.starts_with("-0.") ? 1 : 0;
  if (text.substr(zero).starts_with("0.")) text.erase(zero, 1);
  return text;
}

}  // namespace burin::output::pdf
