#pragma once

#include <limits>
#include <string_view>

#include <gtest/gtest.h>

#include <burin/expr/expression.hpp>

namespace burin::expr {

/// The value of a constant expression; NaN and a failed test when it does not compile.
inline double value_of(std::string_view text) {
  const auto compiled = Expression::compile(text, {}, {"test", 1, 1});
  if (compiled) return (*compiled)({});
  ADD_FAILURE() << text << ": " << problems_text(compiled.problems());
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace burin::expr
