#include <cstdint>

#include <fmt/format.h>

#include <burin/base/xml_text.hpp>

namespace burin {

namespace {

/// The length in bytes of the character of XML 1.0 (section 2.2) that `text` begins with; 0 when it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;

  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t least_of_length[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  const bool no_character = code == 0xFFFE || code == 0xFFFF;
  return code < least_of_length[length] || code > 0x10FFFF || surrogate || no_character ? 0 : length;
}

void append_character(std::string& xml, std::string_view character) {
  switch (character.front()) {
    case '&':
      xml += "&amp;";
      break;
    case '<':
      xml += "&lt;";
      break;
    case '>':
      xml += "&gt;";
      break;
    case '"':
      xml += "&quot;";
      break;
    case '\r':  // a reader turns a bare one into a line feed
      xml += "&#13;";
      break;
    default:
      xml += character;
  }
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      xml += "\uFFFD";
    } else if (text.front() == '\t' || text.front() == '\n') {  // a reader turns them into spaces in an attribute
      xml += fmt::format("&#{};", static_cast<int>(text.front()));
    } else {
      append_character(xml, text.substr(0, length));
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return xml;
}

std::string xml_exact_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      xml += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(text.front())));
    } else if (text.front() == '\\') {
      xml += "\\\\";
    } else {
      append_character(xml, text.substr(0, length));
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return xml;
}

}  // namespace burin
