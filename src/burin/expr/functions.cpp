#include <algorithm>
#include <array>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/expr/functions.hpp>
#include <burin/expr/noise.hpp>

namespace burin::expr {

namespace {

double square_root(double x) {
  return std::sqrt(x);
}
double absolute(double x) {
  return std::abs(x);
}
double sign(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}
double floor(double x) {
  return std::floor(x);
}
double ceiling(double x) {
  return std::ceil(x);
}
double round(double x) {
  return std::round(x);
}
double fraction(double x) {
  return x - std::floor(x);
}

/// The remainder of a division that rounds down: it has the sign of b.
double modulo(double a, double b) {
  const double rest = std::fmod(a, b);  // exact
  return rest != 0.0 && (rest < 0.0) != (b < 0.0) ? rest + b : rest;
}

double clamp(double x, double low, double high) {
  return x < low ? low : x > high ? high : x;
}

double lerp(double a, double b, double t) {
  return a + t * (b - a);
}

double smoothstep(double low, double high, double x) {
  if (low == high) return x < low ? 0.0 : 1.0;
  const double t = clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double minimum(const double* arguments, int count) {
  double least = arguments[0];
  for (int i = 1; i < count; ++i) {
    if (arguments[i] < least || std::isnan(arguments[i])) least = arguments[i];
  }
  return least;
}

double maximum(const double* arguments, int count) {
  double greatest = arguments[0];
  for (int i = 1; i < count; ++i) {
    if (arguments[i] > greatest || std::isnan(arguments[i])) greatest = arguments[i];
  }
  return greatest;
}

constexpr std::array table{
    Function{"sin", math::sin},
    Function{"cos", math::cos},
    Function{"tan", math::tan},
    Function{"asin", math::asin},
    Function{"acos", math::acos},
    Function{"atan", math::atan},
    Function{"atan2", math::atan2},
    Function{"sind", math::sin_degrees},
    Function{"cosd", math::cos_degrees},
    Function{"tand", math::tan_degrees},
    Function{"asind", math::asin_degrees},
    Function{"acosd", math::acos_degrees},
    Function{"atand", math::atan_degrees},
    Function{"atan2d", math::atan2_degrees},
    Function{"exp", math::exp},
    Function{"log", math::log},
    Function{"log10", math::log10},
    Function{"log2", math::log2},
    Function{"sqrt", square_root},
    Function{"cbrt", math::cbrt},
    Function{"pow", math::pow},
    Function{"hypot", math::hypot},
    Function{"abs", absolute},
    Function{"sign", sign},
    Function{"floor", floor},
    Function{"ceil", ceiling},
    Function{"round", round},
    Function{"frac", fraction},
    Function{"min", minimum},
    Function{"max", maximum},
    Function{"clamp", clamp},
    Function{"lerp", lerp},
    Function{"smoothstep", smoothstep},
    Function{"mod", modulo},
    Function{"noise", noise},
};

constexpr std::array constant_table{
    Constant{"pi", math::pi},
    Constant{"tau", math::tau},
    Constant{"e", 2.71828182845904523536},
};

}  // namespace

std::span<const Function> functions() {
  return table;
}

std::span<const Constant> constants() {
  return constant_table;
}

const Function* find_function(std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [name](const Function& f) { return f.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace burin::expr
