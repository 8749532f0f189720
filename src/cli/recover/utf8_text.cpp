#include <cli/recover/utf8_text.hpp>

namespace burin::cli {

void append_utf8(std::string& text, std::uint32_t code) {
  const auto more = [&](unsigned shift) { text += static_cast<char>(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | code >> 6U);
    more(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0U | code >> 12U);
    more(6);
    more(0);
  } else {
    text += static_cast<char>(0xF0U | code >> 18U);
    more(12);
    more(6);
    more(0);
  }
}

}  // namespace burin::cli
