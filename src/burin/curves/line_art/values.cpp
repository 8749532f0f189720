#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/base/number_text.hpp>
#include <burin/curves/line_art/values.hpp>

namespace burin::curves::line_art {

namespace {

constexpr double degrees_per_radian = 180.0 / math::pi;

enum Variable : std::size_t { x, y, r, phi, t, index, chance, span, angle };

}  // namespace

template <bool whole_line>
double SpotFunction<whole_line>::operator()(const Spot& spot) const {
  BURIN_EXPECT(formula.has_value());
  const std::array<double, spot_variables.size()> values{
      spot.at.x,
      spot.at.y,
      formula->uses(r) ? length(spot.at) : 0.0,
      formula->uses(phi) ? math::atan2(spot.at.y, spot.at.x) * degrees_per_radian : 0.0,
      spot.along,
      spot.line,
      spot.chance,
      spot.span,
      spot.angle_deg,
      spot.depth};
  return (*formula)(std::span<const double>(values).first(variables_of<whole_line>().size()));
}

template <bool whole_line>
bool SpotFunction<whole_line>::uses_chance() const {
  return formula && formula->uses(chance);
}

template struct SpotFunction<false>;
template struct SpotFunction<true>;

bool read_formula(const params::Value& value, std::span<const std::string_view> variables,
                  std::optional<expr::Expression>& formula, params::ReadContext& context) {
  std::string text;
  if (const std::string* written = value.text()) {
    text = *written;
  } else if (double number = 0.0; params::read_number(value, number, context)) {
    text = shortest_text(number);
  } else {
    return false;
  }
  Result<expr::Expression> compiled = expr::Expression::compile(text, variables, value.where, context.functions);
  if (!compiled) {
    context.problems.insert(context.problems.end(), compiled.problems().begin(), compiled.problems().end());
    return false;
  }
  formula = *std::move(compiled);
  return true;
}

}  // namespace burin::curves::line_art

namespace burin::params {

using curves::line_art::CountRange;
using curves::line_art::NumberRange;

namespace {

/// One number, which is both ends, or [low, high].
template <class Range>
bool read_range(const Value& value, Range& range, ReadContext& context) {
  using Number = decltype(range.low);
  const Array* ends = value.array();
  if (ends == nullptr) {
    if (!ValueType<Number>::read(value, range.low, context)) return false;
    range.high = range.low;
    return true;
  }
  if (ends->size() != 2) {
    context.report(value.where, "a range is [low, high], found a list of " + std::to_string(ends->size()));
    return false;
  }
  if (!ValueType<Number>::read(ends->front(), range.low, context) ||
      !ValueType<Number>::read(ends->back(), range.high, context)) {
    return false;
  }
  if (range.low <= range.high) return true;
  context.report(value.where, "a range is [low, high]: the first number is the greater one");
  return false;
}

template <class Range>
std::string range_as_text(const Range& range) {
  using Number = decltype(range.low);
  return '[' + ValueType<Number>::text(range.low) + ", " + ValueType<Number>::text(range.high) + ']';
}

}  // namespace

bool ValueType<CountRange>::read(const Value& value, CountRange& range, ReadContext& context) {
  return read_range(value, range, context);
}
std::string ValueType<CountRange>::text(const CountRange& range) {
  return range_as_text(range);
}

bool ValueType<NumberRange>::read(const Value& value, NumberRange& range, ReadContext& context) {
  return read_range(value, range, context);
}
std::string ValueType<NumberRange>::text(const NumberRange& range) {
  return range_as_text(range);
}

}  // namespace burin::params
