#include <fmt/format.h>

#include <burin/base/utf8.hpp>
#include <burin/base/xml_text.hpp>

namespace burin {

namespace {

/// The length in bytes of the character of XML 1.0 (section 2.2) that `text` begins with; 0 when it begins with none.
std::size_t character_length(std::string_view text) {
  const auto [code, length] = first_utf8_character(text);
  const bool control = code < 0x20 && code != '\t' && code != '\n' && code != '\r';
  return control || code == 0xFFFE || code == 0xFFFF ? 0 : length;
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
