#pragma once

#include <span>
#include <string>
#include <string_view>

namespace burin {

/// The known word closest to `word` (Damerau-Levenshtein distance at most 2, and less than half the word's length, so
/// that short words do not match everything); empty when none is close. Ties: the first in `known`.
std::string_view closest_word(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'x'?" for the closest known word, or "; known: a, b, c" when none is close.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace burin
