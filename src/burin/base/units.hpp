#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace burin {

inline constexpr double mm_per_inch = 25.4;
inline constexpr double mm_per_point = mm_per_inch / 72.0;
inline constexpr double mm_per_css_pixel = mm_per_inch / 96.0;

/// Millimetres in one `suffix`: mm, cm, m, in, pt, pc, px (1/96 inch), or "" (bare numbers are millimetres). Nothing
/// for any other suffix.
std::optional<double> mm_per_unit(std::string_view suffix);

/// Where the unit suffix of a length begins: its trailing letters. "15mm" -> 2, "($w*2)mm" -> 6, "15" -> 2.
std::size_t unit_suffix_begin(std::string_view length);

}  // namespace burin
