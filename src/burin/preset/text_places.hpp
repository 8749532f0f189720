#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace burin::preset {

/// Places in a text: toml++ counts columns in characters, burin's messages in bytes. Lines and columns from 1; a place
/// outside the text counts as the nearest one inside.
class TextPlaces {
 public:
  /// Pre: `text` is UTF-8 and outlives this.
  explicit TextPlaces(std::string_view text);

  /// The byte at which character `column` of line `line` begins, from 0. O(1).
  std::size_t offset(std::size_t line, std::size_t column) const;

  /// The column of a byte of that line.
  std::size_t byte_column(std::size_t line, std::size_t byte_offset) const;

  std::string_view text() const { return text_; }

 private:
  struct Line {
    std::size_t first_byte = 0;
    std::size_t first_character = 0;
  };

  const Line& line_at(std::size_t line) const;

  std::string_view text_;
  std::vector<std::uint32_t> character_begins_;
  std::vector<Line> lines_{{}};
};

}  // namespace burin::preset
