#pragma once

#include <span>
#include <string_view>
#include <variant>

namespace burin::expr {

using Unary = double (*)(double);
using Binary = double (*)(double, double);
using Ternary = double (*)(double, double, double);
/// One argument or more.
using Variadic = double (*)(const double* arguments, int count);

struct Function {
  std::string_view name;
  std::variant<Unary, Binary, Ternary, Variadic> call;
};

struct Constant {
  std::string_view name;
  double value;
};

/// Every function an expression may call. None reaches libm's transcendental functions.
std::span<const Function> functions();
std::span<const Constant> constants();

/// The function of that name, or null.
const Function* find_function(std::string_view name);

}  // namespace burin::expr
