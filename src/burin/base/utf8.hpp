#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace burin {

/// A character at the beginning of a text in UTF-8.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< in bytes; 0: the text begins with no character
};

/// The character that `text` begins with: shortest form only, no surrogates, at most U+10FFFF. Source: RFC 3629.
Utf8Character first_utf8_character(std::string_view text);

/// A character as UTF-8. Pre: no surrogate, at most U+10FFFF.
std::string utf8_text(char32_t code);

}  // namespace burin
