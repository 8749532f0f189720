#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/fractal_interpolation/params.hpp>

namespace burin::params {

namespace fractal = curves::fractal_interpolation;

namespace {

/// A scaling written as a table.
struct ScalingSpec {
  std::vector<double> chebyshev;
  std::vector<double> sine;
  std::vector<double> exponential;

  static constexpr auto fields() {
    return std::tuple{field("chebyshev", &ScalingSpec::chebyshev, "coefficients of T0, T1, ..."),
                      field("sine", &ScalingSpec::sine, "c0 + c1 sin(c2 x + c3)"),
                      field("exponential", &ScalingSpec::exponential, "c0 exp(c1 x)")};
  }
};
static_assert(ParamStruct<ScalingSpec>);

constexpr std::size_t most_coefficients = 32;

bool read_scaling_table(const Value& value, fractal::Scaling& scaling, ReadContext& context) {
  ScalingSpec spec;
  if (!read_fields(*value.table(), spec, "scaling", context)) return false;
  const int kinds = int{!spec.chebyshev.empty()} + int{!spec.sine.empty()} + int{!spec.exponential.empty()};
  if (kinds != 1) {
    context.report(value.where, "a scaling needs exactly one of 'chebyshev', 'sine' and 'exponential'");
    return false;
  }
  const auto wrong_count = [&](std::string_view what, std::size_t wanted, std::size_t found) {
    context.report(value.where, fmt::format("'{}' takes {} numbers, not {}", what, wanted, found));
    return false;
  };
  using Kind = fractal::Scaling::Kind;
  if (!spec.sine.empty()) {
    if (spec.sine.size() != 4) return wrong_count("sine", 4, spec.sine.size());
    scaling = {Kind::sine, std::move(spec.sine)};
  } else if (!spec.exponential.empty()) {
    if (spec.exponential.size() != 2) return wrong_count("exponential", 2, spec.exponential.size());
    scaling = {Kind::exponential, std::move(spec.exponential)};
  } else {
    scaling = {Kind::chebyshev, std::move(spec.chebyshev)};
  }
  return true;
}

/// A number, a table or, inside a list, the list of a Chebyshev sum.
bool read_scaling(const Value& value, fractal::Scaling& scaling, ReadContext& context) {
  if (value.table() != nullptr) {
    if (!read_scaling_table(value, scaling, context)) return false;
  } else if (value.array() != nullptr) {
    scaling.kind = fractal::Scaling::Kind::chebyshev;
    if (!ValueType<std::vector<double>>::read(value, scaling.c, context)) return false;
  } else {
    double s = 0.0;
    if (!read_number(value, s, context)) return false;
    scaling = fractal::constant_scaling(s);
  }
  if (!scaling.c.empty() && scaling.c.size() <= most_coefficients) return true;
  context.report(value.where,
                 fmt::format("a scaling has 1 to {} coefficients, not {}", most_coefficients, scaling.c.size()));
  return false;
}

bool report_empty(const Value& value, ReadContext& context) {
  context.report(value.where, "the list is empty");
  return false;
}

}  // namespace

bool ValueType<fractal::EachInterval>::read(const Value& value, Each& each, ReadContext& context) {
  if (value.array() == nullptr) {
    each.values.resize(1);
    return read_number(value, each.values[0], context);
  }
  if (!ValueType<std::vector<double>>::read(value, each.values, context)) return false;
  return !each.values.empty() || report_empty(value, context);
}

std::string ValueType<fractal::EachInterval>::text(const Each& each) {
  return each.values.size() == 1 ? shortest_text(each.values[0]) : ValueType<std::vector<double>>::text(each.values);
}

bool ValueType<fractal::EachScaling>::read(const Value& value, Each& each, ReadContext& context) {
  const Array* list = value.array();
  if (list == nullptr) {
    each.values.resize(1);
    return read_scaling(value, each.values[0], context);
  }
  if (list->empty()) return report_empty(value, context);
  each.values.assign(list->size(), {});
  bool all = true;
  for (std::size_t i = 0; i < list->size(); ++i) all = read_scaling((*list)[i], each.values[i], context) && all;
  return all;
}

std::string ValueType<fractal::EachScaling>::text(const Each& each) {
  return shortest_text(each.values.front().c.front());
}

bool ValueType<fractal::Derivatives>::read(const Value& value, Derivatives& derivatives, ReadContext& context) {
  if (value.array() == nullptr) return ValueType<fractal::DerivativeRule>::read(value, derivatives.rule, context);
  if (!ValueType<std::vector<double>>::read(value, derivatives.given, context)) return false;
  return !derivatives.given.empty() || report_empty(value, context);
}

std::string ValueType<fractal::Derivatives>::text(const Derivatives& derivatives) {
  return ValueType<fractal::DerivativeRule>::text(derivatives.rule);
}

bool ValueType<fractal::Coordinate>::read(const Value& value, Coordinate& coordinate, ReadContext& context) {
  if (value.table() == nullptr) return report_kind(value, "a table such as { scaling = 0.3 }", context);
  return read_fields(*value.table(), coordinate, "coordinate", context);
}

}  // namespace burin::params
