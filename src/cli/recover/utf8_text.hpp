#pragma once

#include <cstdint>
#include <string>

namespace burin::cli {

/// Appends a character to a text in UTF-8. Pre: code <= 0x10FFFF.
void append_utf8(std::string& text, std::uint32_t code);

}  // namespace burin::cli
