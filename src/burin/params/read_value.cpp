#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/units.hpp>
#include <burin/params/read_value.hpp>

namespace burin::params {

bool report_kind(const Value& value, std::string_view expected, ReadContext& context) {
  context.report(value.where, fmt::format("expected {}, found {}", expected, value.kind_name()));
  return false;
}

namespace {

bool evaluate_text(const std::string& text, const Where& where, double& number, ReadContext& context) {
  const Result<double> result = context.evaluate(text, where);
  if (!result) {
    context.problems.insert(context.problems.end(), result.problems().begin(), result.problems().end());
    return false;
  }
  number = *result;
  return true;
}

}  // namespace

bool read_number(const Value& value, double& number, ReadContext& context) {
  double found = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    found = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&value.data)) {
    found = *real;
  } else if (const std::string* text = value.text()) {
    if (!evaluate_text(*text, value.where, found, context)) return false;
  } else {
    return report_kind(value, "a number", context);
  }
  if (!std::isfinite(found)) {
    context.report(value.where, "expected a finite number");
    return false;
  }
  number = found;
  return true;
}

std::string ValueType<double>::text(const double& number) {
  return shortest_text(number);
}

bool ValueType<std::int64_t>::read(const Value& value, std::int64_t& number, ReadContext& context) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    number = *whole;
    return true;
  }
  if (value.text() == nullptr) return report_kind(value, "a whole number", context);
  double found = 0.0;
  if (!read_number(value, found, context)) return false;
  if (found != std::floor(found) || std::abs(found) > 0x1p53) {
    context.report(value.where, fmt::format("expected a whole number, found {}", shortest_text(found)));
    return false;
  }
  number = static_cast<std::int64_t>(found);
  return true;
}

bool ValueType<int>::read(const Value& value, int& number, ReadContext& context) {
  std::int64_t wide = 0;
  if (!ValueType<std::int64_t>::read(value, wide, context)) return false;
  if (wide < std::numeric_limits<int>::min() || wide > std::numeric_limits<int>::max()) {
    context.report(value.where, fmt::format("{} is too large", wide));
    return false;
  }
  number = static_cast<int>(wide);
  return true;
}

bool ValueType<bool>::read(const Value& value, bool& flag, ReadContext& context) {
  const bool* found = std::get_if<bool>(&value.data);
  if (found == nullptr) return report_kind(value, "true or false", context);
  flag = *found;
  return true;
}

bool ValueType<std::string>::read(const Value& value, std::string& text, ReadContext& context) {
  const std::string* found = value.text();
  if (found == nullptr) return report_kind(value, "a text", context);
  text = *found;
  return true;
}

bool ValueType<Length>::read(const Value& value, Length& length, ReadContext& context) {
  const std::string* text = value.text();
  if (text == nullptr) return read_number(value, length.mm, context);
  const std::size_t suffix_begin = unit_suffix_begin(*text);
  const std::string_view suffix = std::string_view(*text).substr(suffix_begin);
  const std::optional<double> unit_mm = mm_per_unit(suffix);
  if (!unit_mm || suffix_begin == 0) {
    context.report(value.where, fmt::format("expected a length such as 15mm, 1.5cm, 0.5in or 2pt, found '{}'", *text));
    return false;
  }
  std::string number = text->substr(0, suffix_begin);
  while (!number.empty() && number.back() == ' ') number.pop_back();
  double found = 0.0;
  if (!evaluate_text(number, value.where, found, context)) return false;
  length.mm = found * *unit_mm;
  if (!std::isfinite(length.mm)) {
    context.report(value.where, "expected a finite length");
    return false;
  }
  return true;
}

std::string ValueType<Length>::text(const Length& length) {
  return '"' + shortest_text(length.mm) + "mm\"";
}

}  // namespace burin::params
