#pragma once

#include <string_view>

#include <burin/base/problem.hpp>

namespace burin::preset {

/// A syntax error of a preset in words that say what to do: line breaks in braces, missing quotes, keys given twice and
/// the other usual traps of TOML. `where` is the place the parser stopped at, which the problem may move to where the
/// mistake begins; `reason` the parser's own words.
Problem explain_syntax_error(std::string_view text, const Where& where, std::string_view reason);

}  // namespace burin::preset
