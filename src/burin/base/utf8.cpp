#include <array>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/base/utf8.hpp>

namespace burin {

namespace {

bool is_surrogate(char32_t code) {
  return code >= 0xD800 && code <= 0xDFFF;
}

constexpr char32_t last_character = 0x10FFFF;

}  // namespace

Utf8Character first_utf8_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(text[i])); };
  if (text.empty()) return {};
  const char32_t first = byte(0);
  if (first < 0x80) return {first, 1};

  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
  char32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least_of_length{0, 0, 0x80, 0x800, 0x10000};
  if (code < least_of_length[length] || code > last_character || is_surrogate(code)) return {};
  return {code, length};
}

std::string utf8_text(char32_t code) {
  BURIN_EXPECT(code <= last_character && !is_surrogate(code));
  if (code < 0x80) return {static_cast<char>(code)};
  const auto following = [code](unsigned bits) { return static_cast<char>(0x80U | (code >> bits & 0x3FU)); };
  if (code < 0x800) return {static_cast<char>(0xC0U | code >> 6U), following(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | code >> 12U), following(6), following(0)};
  return {static_cast<char>(0xF0U | code >> 18U), following(12), following(6), following(0)};
}

}  // namespace burin
