#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/two_point/amount.hpp>

namespace burin::curves::two_point {

double largest_magnitude(Interval interval) {
  return std::max(std::abs(interval.low), std::abs(interval.high));
}

bool Amount::is_random() const {
  constexpr std::size_t rand_variable = 3;
  return expression ? expression->uses(rand_variable) : low != high;
}

Interval Amount::range() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return expression ? Interval{-infinity, infinity} : Interval{low, high};
}

double Amount::at(std::uint64_t seed, const AmountKey& key) const {
  if (is_constant()) return low;
  const double rand = uniform(seed, key.level, key.edge + 1, key.marker, key.purpose);
  if (!expression) return low + rand * (high - low);
  const std::array<double, amount_variables.size()> variables{
      static_cast<double>(key.level), static_cast<double>(key.edge) + 1.0, static_cast<double>(key.marker), rand};
  return (*expression)(variables);
}

}  // namespace burin::curves::two_point

namespace burin::params {

namespace two_point = curves::two_point;

namespace {

bool read_random(const Table& table, const Where& where, two_point::Amount& amount, ReadContext& context) {
  const Value* range = table.find("random");
  if (range == nullptr || table.entries.size() != 1 || range->array() == nullptr || range->array()->size() != 2) {
    context.report(where, "a random amount is written { random = [low, high] }");
    return false;
  }
  amount = {};
  if (!read_number((*range->array())[0], amount.low, context)) return false;
  if (!read_number((*range->array())[1], amount.high, context)) return false;
  if (amount.low <= amount.high) return true;
  context.report(range->where, "the low end of a random range must not lie above its high end");
  return false;
}

}  // namespace

bool ValueType<two_point::Amount>::read(const Value& value, two_point::Amount& amount, ReadContext& context) {
  if (const std::string* text = value.text()) {
    Result<expr::Expression> compiled = expr::Expression::compile(*text, two_point::amount_variables, value.where);
    if (!compiled) {
      context.problems.insert(context.problems.end(), compiled.problems().begin(), compiled.problems().end());
      return false;
    }
    if (!compiled->is_constant()) {
      amount = {0.0, 0.0, *std::move(compiled)};
      return true;
    }
  } else if (const Table* table = value.table()) {
    return read_random(*table, value.where, amount, context);
  }
  if (!read_number(value, amount.low, context)) return false;
  amount = {amount.low, amount.low, std::nullopt};
  return true;
}

std::string ValueType<two_point::Amount>::text(const two_point::Amount& amount) {
  return amount.is_constant() ? shortest_text(amount.low) : std::string();
}

}  // namespace burin::params
