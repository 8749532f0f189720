#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// An opaque sRGB colour.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Shares of a printer's four inks, from 0 to 1.
struct Cmyk {
  double cyan = 0.0;
  double magenta = 0.0;
  double yellow = 0.0;
  double black = 0.0;
  friend bool operator==(const Cmyk&, const Cmyk&) = default;
};

/// "#rgb", "#rrggbb", a CSS colour name or one of burin's papers ("oat", "kraft" ...), in small or capital letters;
/// nothing for other words.
std::optional<Colour> parse_colour(std::string_view text);

/// Every colour name, in alphabetical order.
std::vector<std::string_view> colour_names();

/// "#rrggbb".
std::string colour_text(Colour colour);

}  // namespace burin
