#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// The small words that attributes of SVG are made of.
namespace burin::data::svg {

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// What stands before the first `separator`, trimmed, taken off `rest`.
std::string_view take_until(std::string_view& rest, char separator);

/// The number at the beginning of `rest`, taken off it with the blanks and the comma behind it; nothing when there is
/// none or it is beyond 1e12.
std::optional<double> take_number(std::string_view& rest);

/// Numbers with blanks and commas between; nothing when anything else stands there.
std::optional<std::vector<double>> numbers(std::string_view text);

/// A length in pixels, 96 an inch; of a percentage, that share of `whole`. An em is 16 pixels. Nothing when it is none.
std::optional<double> length_px(std::string_view text, double whole);

/// A number or a percentage; `otherwise` when it is neither.
double share(std::string_view text, double otherwise);

}  // namespace burin::data::svg
