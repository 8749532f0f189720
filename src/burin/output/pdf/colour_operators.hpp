#pragma once

#include <string>

#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// "0 g" for pure greys, else "1 .388236 .278432 rg".
std::string fill_operator(Colour colour);

/// Sets a pen's colour for lines and fills: grey, RGB, CMYK or, of a spot colour, the space /S<pen>.
std::string pen_colour_operators(const Pen& pen, std::size_t index);

/// The space of a spot colour, with what a screen shows of it. Pre: the pen has one.
std::string spot_space(const Pen& pen);

}  // namespace burin::output::pdf
