#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/plane_function.hpp>
#include <burin/base/result.hpp>

namespace burin::expr {

/// A checked expression: every name is known, every bracket closed, operands and operators alternate, and each function
/// has its arguments.
struct Scan {
  std::string formula;     ///< the expression without blanks, at most one sign before an operand
  std::vector<bool> uses;  ///< for each variable, whether it occurs
};

/// Checks `text` and reports the first thing that is wrong, with its column inside the text added to `where`. One pass,
/// no recursion.
Result<Scan> scan(std::string_view text, std::span<const std::string_view> variables, const Where& where,
                  std::span<const PlaneFunction> functions = {});

}  // namespace burin::expr
