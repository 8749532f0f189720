#include <algorithm>

#include <burin/preset/text_places.hpp>

namespace burin::preset {

TextPlaces::TextPlaces(std::string_view text) : text_(text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if ((static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) continue;
    character_begins_.push_back(static_cast<std::uint32_t>(at));
    if (text[at] == '\n') lines_.push_back({at + 1, character_begins_.size()});
  }
  character_begins_.push_back(static_cast<std::uint32_t>(text.size()));
}

const TextPlaces::Line& TextPlaces::line_at(std::size_t line) const {
  return lines_[std::clamp<std::size_t>(line, 1, lines_.size()) - 1];
}

std::size_t TextPlaces::offset(std::size_t line, std::size_t column) const {
  const std::size_t character = line_at(line).first_character + std::max<std::size_t>(column, 1) - 1;
  return character_begins_[std::min(character, character_begins_.size() - 1)];
}

std::size_t TextPlaces::byte_column(std::size_t line, std::size_t byte_offset) const {
  return byte_offset - std::min(line_at(line).first_byte, byte_offset) + 1;
}

}  // namespace burin::preset
