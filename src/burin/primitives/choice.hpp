#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/expr/expression.hpp>
#include <burin/params/fields.hpp>
#include <burin/primitives/position.hpp>

/// What is drawn where: one grammar for figures, pens, scales, rotations and whether to draw at all.
namespace burin::primitives {

/// Band b of `count` holds at[b-1] <= by < at[b], NaN falls into the first; without bounds things take turns: number
/// floor(by - first) mod count.
std::size_t pick(const expr::Expression& by, const std::vector<double>& at, double first, std::size_t count,
                 const PositionValues& values);

/// An expression that is a variable by itself. Pre: there is one of that name.
expr::Expression variable(std::string_view name);
/// An expression that is a number by itself. Pre: finite.
expr::Expression constant(double value);

/// One thing, a list whose things take turns, or bands of a function of the place.
template <class T>
struct Choice {
  std::vector<T> of;
  std::vector<double> at{};  ///< ascending, one less than `of`; empty: in turn
  expr::Expression by{};     ///< over position_variables
  double first = 0.0;        ///< of `by`, where turns begin

  std::size_t pick(const PositionValues& values) const {
    return of.size() < 2 ? 0 : primitives::pick(by, at, first, of.size(), values);
  }
  bool takes_turns() const { return of.size() > 1 && at.empty(); }
  PositionUse used() const { return of.size() < 2 ? PositionUse{} : used_by(by); }
};

/// Makes a list take turns by level, the first at this one; leaves other choices alone.
template <class T>
void turn_by_level(Choice<T>& choice, int first_level) {
  if (!choice.takes_turns()) return;
  choice.by = variable("level");
  choice.first = first_level;
}

/// A number over the place. Its own type, so that presets may write "2.5", "sqrt(2)" or "lerp(14, 4, pr/90)".
struct PlaceNumber {
  expr::Expression value;
};

/// The same in millimetres, which may be written with a unit where it is constant: "4mm".
struct PlaceLength {
  expr::Expression value;
};

}  // namespace burin::primitives

namespace burin::params {

template <>
struct ValueType<primitives::PlaceNumber> {
  static std::string name() { return "number or expression"; }
  static bool read(const Value& value, primitives::PlaceNumber& number, ReadContext& context);
  static std::string text(const primitives::PlaceNumber& number) { return number.value.text(); }
};

template <>
struct ValueType<primitives::PlaceLength> {
  static std::string name() { return "length or expression"; }
  static bool read(const Value& value, primitives::PlaceLength& length, ReadContext& context);
  static std::string text(const primitives::PlaceLength& length) { return length.value.text(); }
};

/// The `at` and `by` of a table of bands, which has keys that somebody else reads. False after reporting.
bool read_bounds(const Value& value, const std::vector<std::string_view>& also_known, std::vector<double>& at,
                 expr::Expression& by, ReadContext& context);
/// Whether bands of so many bounds choose from `count` things, which stand in `of`. False after reporting.
bool check_band_count(const Value& of, std::size_t bounds, std::size_t count, ReadContext& context);

/// A thing, a list of things in turn (by index, until told otherwise), or { by = "f(x,y)", at = [...], of = [...] }.
template <class T>
struct ValueType<primitives::Choice<T>> {
  static std::string name() { return ValueType<T>::name() + ", list or bands"; }

  static bool read(const Value& value, primitives::Choice<T>& choice, ReadContext& context) {
    primitives::Choice<T> read;
    const Value* of = value.table() == nullptr ? &value : value.table()->find("of");
    if (of == nullptr) {
      context.report(value.where, "bands need 'of': { by = \"f(x,y)\", at = [...], of = [...] }");
      return false;
    }
    if (of->array() == nullptr && of == &value) {
      read.of.emplace_back();
      if (!ValueType<T>::read(*of, read.of.front(), context)) return false;
    } else {
      if (!ValueType<std::vector<T>>::read(*of, read.of, context)) return false;
      if (read.of.empty()) {
        context.report(of->where, "the list is empty: there is nothing to choose from");
        return false;
      }
      read.by = primitives::variable("index");
    }
    if (of != &value && !(read_bounds(value, {"of"}, read.at, read.by, context) &&
                          check_band_count(*of, read.at.size(), read.of.size(), context))) {
      return false;
    }
    choice = std::move(read);
    return true;
  }

  static std::string text(const primitives::Choice<T>& choice) {
    return choice.of.size() == 1 ? ValueType<T>::text(choice.of.front()) : "";
  }
};

}  // namespace burin::params
