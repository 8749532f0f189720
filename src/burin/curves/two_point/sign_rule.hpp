#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <burin/params/read_value.hpp>

namespace burin::curves::two_point {

/// The sign s(m, i) of every beta of edge i (from 1, over the whole sequence) when level m (from 1) is made.
/// Source: reference curves A.1.
struct SignRule {
  enum class Kind : std::uint8_t {
    constant,    ///< +1
    edge,        ///< (-1)^(i-1)
    level,       ///< (-1)^(m-1)
    level_edge,  ///< (-1)^(m+i)
    random,      ///< by the top bit of random_bits(seed, m, i)
    list,        ///< list[(i-1) mod its length]
  };
  Kind kind = Kind::constant;
  std::vector<int> list{};  ///< of +1 and -1

  /// Pre: level >= 1. `edge` counts from 0 and may have wrapped modulo 2^64.
  double operator()(std::uint64_t seed, int level, std::uint64_t edge) const;

  /// After how many edges (for a given level) the signs repeat; not for random.
  std::size_t edge_period() const;
  /// After how many levels (for a given edge) the signs repeat.
  std::size_t level_period() const;
};

}  // namespace burin::curves::two_point

/// A word or a list of +1 and -1.
template <>
struct burin::params::ValueType<burin::curves::two_point::SignRule> {
  static std::string name() { return "constant | edge | level | level-edge | random | list of 1 and -1"; }
  static bool read(const Value& value, burin::curves::two_point::SignRule& rule, ReadContext& context);
  static std::string text(const burin::curves::two_point::SignRule& rule);
};
