#include <cmath>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/primitives/choice.hpp>

namespace burin::primitives {

std::size_t pick(const expr::Expression& by, const std::vector<double>& at, double first, std::size_t count,
                 const PositionValues& values) {
  const double value = by(values);
  if (at.empty()) {
    const auto turns = static_cast<double>(count);
    const double step = std::floor(value - first);
    return std::isfinite(step) ? static_cast<std::size_t>(step - turns * std::floor(step / turns)) % count : 0;
  }
  std::size_t band = 0;
  while (band < at.size() && value >= at[band]) ++band;
  return band;
}

expr::Expression variable(std::string_view name) {
  Result<expr::Expression> compiled = expr::Expression::compile(name, position_variables, {});
  BURIN_EXPECT(compiled.ok());
  return *std::move(compiled);
}

expr::Expression constant(double value) {
  return variable(shortest_text(value));
}

}  // namespace burin::primitives

namespace burin::params {

namespace {

/// The table of a banded choice; what stands in `of` is read by its own type.
struct Bounds {
  std::string by;
  std::vector<double> at;

  static constexpr auto fields() {
    return std::tuple{field("by", &Bounds::by, "function of the place"),
                      field("at", &Bounds::at, "bounds between the bands, ascending")};
  }
};

bool compile(const std::string& text, const Where& where, expr::Expression& expression, ReadContext& context) {
  Result<expr::Expression> compiled =
      expr::Expression::compile(text, primitives::position_variables, where, context.functions);
  if (compiled) {
    expression = *std::move(compiled);
    return true;
  }
  context.problems.insert(context.problems.end(), compiled.problems().begin(), compiled.problems().end());
  return false;
}

bool read_expression(const Value& value, expr::Expression& expression, ReadContext& context) {
  if (const std::string* text = value.text()) return compile(*text, value.where, expression, context);
  double number = 0.0;
  if (!read_number(value, number, context)) return false;
  expression = primitives::constant(number);
  return true;
}

}  // namespace

bool ValueType<primitives::PlaceNumber>::read(const Value& value, primitives::PlaceNumber& number,
                                              ReadContext& context) {
  return read_expression(value, number.value, context);
}

bool ValueType<primitives::PlaceLength>::read(const Value& value, primitives::PlaceLength& length,
                                              ReadContext& context) {
  Problems unheard;
  ReadContext quiet{.problems = unheard, .evaluate = context.evaluate, .defined = {}, .read_file = {}};
  Length constant;
  if (ValueType<Length>::read(value, constant, quiet)) {
    length.value = primitives::constant(constant.mm);
    return true;
  }
  return read_expression(value, length.value, context);
}

bool read_bounds(const Value& value, const std::vector<std::string_view>& also_known, std::vector<double>& at,
                 expr::Expression& by, ReadContext& context) {
  const Table& table = *value.table();
  Bounds bounds;
  if (!read_fields(table, bounds, "bands", context, also_known)) return false;
  for (const char* key : {"by", "at"}) {
    if (table.find(key) != nullptr) continue;
    context.report(value.where, fmt::format("bands need '{}': {{ by = \"f(x,y)\", at = [...], of = [...] }}", key));
    return false;
  }
  for (std::size_t i = 1; i < bounds.at.size(); ++i) {
    if (bounds.at[i] > bounds.at[i - 1]) continue;
    context.report((*table.find("at")->array())[i].where,
                   fmt::format("bounds must ascend: {} does not follow {}", shortest_text(bounds.at[i]),
                               shortest_text(bounds.at[i - 1])));
    return false;
  }
  at = std::move(bounds.at);
  return compile(bounds.by, table.find("by")->where, by, context);
}

bool check_band_count(const Value& of, std::size_t bounds, std::size_t count, ReadContext& context) {
  if (count == bounds + 1) return true;
  context.report(of.where, fmt::format("{} bounds in 'at' need {} in 'of', found {}", bounds, bounds + 1, count));
  return false;
}

}  // namespace burin::params
