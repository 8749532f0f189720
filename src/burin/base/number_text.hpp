#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The shortest decimal text that reads back as exactly `value`: no locale, "-0" is "0". Pre: finite.
std::string shortest_text(double value);

/// The same without an exponent, rounded to `decimals` places, trailing zeros and "-0" removed. Pre: finite.
std::string fixed_text(double value, int decimals);

/// How many, for people: "1,234,567"; "2.6e+120" for counts that no integer holds; "more than 1e308". Pre: not
/// negative.
std::string count_text(double count);

/// A decimal number that is the whole of `text` ("1", "-.5", "2e-3"); nothing for anything else, NaN and infinity too.
std::optional<double> parse_number(std::string_view text);

}  // namespace burin
