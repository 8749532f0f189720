#pragma once

#include <array>
#include <string_view>

/// The data of the Hershey fonts, glyph by glyph as in James Hurt's format: the letters of printable ASCII from U+0020,
/// each a text of pairs. A pair (a, b) is the point (a - 'R', b - 'R') with y down; the first pair holds the left and
/// the right border instead, " R" lifts the pen. Letters stand on y = 9, capitals reach y = -12. LICENSE-hershey says
/// who made them. The tables are written by tools/hershey_table.sh.
namespace burin::curves::lettering::hershey {

using GlyphTexts = std::array<std::string_view, 95>;

inline constexpr double baseline_y = 9.0;
inline constexpr double cap_height = 21.0;

extern const GlyphTexts rowmans;    ///< roman simplex
extern const GlyphTexts rowmand;    ///< roman duplex
extern const GlyphTexts timesr;     ///< roman complex
extern const GlyphTexts timesrb;    ///< roman triplex
extern const GlyphTexts timesi;     ///< italic complex
extern const GlyphTexts timesib;    ///< italic triplex
extern const GlyphTexts scripts;    ///< script simplex
extern const GlyphTexts scriptc;    ///< script complex
extern const GlyphTexts gothiceng;  ///< gothic English

}  // namespace burin::curves::lettering::hershey
