#include <cstddef>
#include <cstdint>

#include <burin/output/origin_text.hpp>

namespace burin::output {

namespace {

/// Bytes of the well-formed character at the start of `text` (Unicode 15, table 3-7) that XML allows; 0: none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const std::uint8_t lead = byte(0);
  const std::uint8_t second = byte(1);
  if (lead < 0x80) return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  if (lead < 0xC2) return 0;
  if (lead < 0xE0) return continues(1) ? 2 : 0;
  if (lead < 0xF0) {
    const bool overlong = lead == 0xE0 && second < 0xA0;
    const bool surrogate = lead == 0xED && second > 0x9F;
    const bool noncharacter = lead == 0xEF && second == 0xBF && byte(2) >= 0xBE;
    return continues(1) && continues(2) && !overlong && !surrogate && !noncharacter ? 3 : 0;
  }
  const bool out_of_range = lead > 0xF4 || (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
  return continues(1) && continues(2) && continues(3) && !out_of_range ? 4 : 0;
}

}  // namespace

std::string carried_text(std::string_view text) {
  constexpr std::string_view replacement = "\xEF\xBF\xBD";
  std::string carried;
  carried.reserve(text.size());
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    carried += size > 0 ? text.substr(0, size) : replacement;
    text.remove_prefix(size > 0 ? size : 1);
  }
  return carried;
}

}  // namespace burin::output
