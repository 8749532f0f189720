#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include <burin/geom/vec2.hpp>

/// What the Hershey fonts lack: how other characters are put together from their letters and from strokes of ours.
namespace burin::curves::lettering {

/// Where a part of a character goes. Ink: the box of the part before it, before the font's slope.
enum class Place : std::uint8_t {
  next,    ///< as the next letter
  joined,  ///< its ink touches the ink before it, on the right
  left,    ///< its x = 0 at the left of the ink
  centre,  ///< its middle (of a path: its x = 0) at the middle of the ink
};

/// A letter of the font, or strokes as SVG path data in units of the font with y up from the baseline.
struct Part {
  char32_t letter = 0;
  std::string_view path{};
  Place place = Place::next;
  Vec2 by{};
  double scale = 1.0;
  bool turned = false;  ///< upside down, hanging from the height of small letters
  bool small = false;   ///< a path drawn for small letters of 14 units, to be scaled to those of the font

  bool empty() const { return letter == 0 && path.empty(); }
};

struct Recipe {
  char32_t character;
  std::array<Part, 3> parts;
};

/// The parts of a character in all fonts but the ornate ones, or in those; empty: it has no recipe.
std::span<const Part> recipe_of(char32_t character, bool ornate);

/// A mark over or under a letter.
struct Mark {
  std::string_view path{};  ///< about x = 0, upwards from y = 0 or, below the letter, downwards
  int dots = 0;             ///< the dot of the font's i instead, so many times
  bool below = false;
  double gap = 2.5;  ///< from the letter's ink
};

/// A letter with a mark: é. The letter is any that has no mark itself; i and j lose their dots under a mark above.
struct MarkedLetter {
  char32_t letter = 0;
  Mark mark;
};

/// letter 0: the character is no marked letter.
MarkedLetter marked_letter(char32_t character);

}  // namespace burin::curves::lettering
