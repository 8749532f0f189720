#pragma once

#include <string>
#include <string_view>

namespace burin::output::pdf {

/// Text for people: "(as it is)" when that is ASCII, else in hexadecimal UTF-16. Bytes that are no UTF-8, and control
/// characters other than tab, line feed and carriage return, become U+FFFD. Reads back character for character.
///
/// Source: ISO 32000-1:2008, sections 7.3.4 and 7.9.2.2.
std::string text_string(std::string_view text);

/// "/Pantone#20485#20C", whatever is in it (section 7.3.5).
std::string name_text(std::string_view name);

/// A number with at most `decimals` decimals, without a leading zero. Pre: finite, less than 1e12.
std::string number_text(double value, int decimals = 6);

}  // namespace burin::output::pdf
