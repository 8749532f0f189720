#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <burin/expr/expression.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/params/read_value.hpp>

namespace burin::curves::line_art {

/// A whole number from low to high, both included; written as one number or [low, high].
struct CountRange {
  int low = 0;
  int high = 0;
};

/// A number from low to high; written as one number or [low, high].
struct NumberRange {
  double low = 0.0;
  double high = 0.0;
};

/// Where on a polyline an expression is asked.
struct Spot {
  Vec2 at{};               ///< model units
  double along = 0.0;      ///< 0 at its start, 1 at its end
  double line = 0.0;       ///< which polyline, from 0
  double chance = 0.0;     ///< one draw for each polyline
  double span = 0.0;       ///< from its first to its last point
  double angle_deg = 0.0;  ///< of that chord, in (-180, 180]
  double depth = 0.0;      ///< how far the middle of the line lies beyond the camera's target; in the plane 0
};

/// An expression over the plane: x y r phi (degrees), t along the polyline, index of the polyline, rand; for a whole
/// polyline, at its start, also span and angle of its chord and depth in space.
template <bool whole_line>
struct SpotFunction {
  std::optional<expr::Expression> formula;  ///< nothing: not given

  explicit operator bool() const { return formula.has_value(); }
  /// Pre: given. Not to be called on one object from two threads at once.
  double operator()(const Spot& spot) const;
  bool uses_chance() const;
};

using FieldFunction = SpotFunction<false>;
using LineFunction = SpotFunction<true>;

inline constexpr std::array<std::string_view, 10> spot_variables{"x",     "y",    "r",    "phi",   "t",
                                                                 "index", "rand", "span", "angle", "depth"};

template <bool whole_line>
constexpr std::span<const std::string_view> variables_of() {
  return std::span<const std::string_view>(spot_variables).first(whole_line ? 10 : 7);
}

/// Compiles a text or takes a number. False after reporting.
bool read_formula(const params::Value& value, std::span<const std::string_view> variables,
                  std::optional<expr::Expression>& formula, params::ReadContext& context);

}  // namespace burin::curves::line_art

namespace burin::params {

template <>
struct ValueType<curves::line_art::CountRange> {
  static std::string name() { return "whole number or [low, high]"; }
  static bool read(const Value& value, curves::line_art::CountRange& range, ReadContext& context);
  static std::string text(const curves::line_art::CountRange& range);
};

template <>
struct ValueType<curves::line_art::NumberRange> {
  static std::string name() { return "number or [low, high]"; }
  static bool read(const Value& value, curves::line_art::NumberRange& range, ReadContext& context);
  static std::string text(const curves::line_art::NumberRange& range);
};

template <bool whole_line>
struct ValueType<curves::line_art::SpotFunction<whole_line>> {
  using Function = curves::line_art::SpotFunction<whole_line>;
  static std::string name() { return "expression"; }
  static bool read(const Value& value, Function& function, ReadContext& context) {
    return curves::line_art::read_formula(value, curves::line_art::variables_of<whole_line>(), function.formula,
                                          context);
  }
  static std::string text(const Function& function) {
    return function.formula ? '"' + function.formula->text() + '"' : std::string();
  }
};

}  // namespace burin::params
