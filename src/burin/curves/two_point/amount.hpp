#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <burin/expr/expression.hpp>
#include <burin/params/read_value.hpp>

namespace burin::curves::two_point {

/// The variables of an amount's expression, in this order: level m and edge i, both from 1, marker j from 1, and rand,
/// uniform in [0, 1) and keyed by (seed, level, edge, marker).
inline constexpr std::array<std::string_view, 4> amount_variables{"level", "edge", "marker", "rand"};

/// The values an amount can take.
struct Interval {
  double low;
  double high;
};

double largest_magnitude(Interval interval);

/// What of an edge is asked, and which one: level from 1, edge from 0, marker from 1. `purpose` is the last key of a
/// draw.
struct AmountKey {
  int level = 1;
  std::uint64_t edge = 0;
  std::size_t marker = 1;
  std::uint64_t purpose = 0;
};

/// Half of a mark: a number, a range to draw from, or an expression.
struct Amount {
  double low = 0.0;
  double high = 0.0;  ///< low == high: a constant
  std::optional<expr::Expression> expression{};

  bool is_constant() const { return !expression && low == high; }
  /// Whether it depends on the seed.
  bool is_random() const;
  /// Everything for expressions, whose range nobody knows.
  Interval range() const;
  double at(std::uint64_t seed, const AmountKey& key) const;
};

}  // namespace burin::curves::two_point

/// A number, an expression over amount_variables, or { random = [low, high] }.
template <>
struct burin::params::ValueType<burin::curves::two_point::Amount> {
  static std::string name() { return "amount"; }
  static bool read(const Value& value, burin::curves::two_point::Amount& amount, ReadContext& context);
  static std::string text(const burin::curves::two_point::Amount& amount);
};
