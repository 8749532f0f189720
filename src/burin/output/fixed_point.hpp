#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include <burin/base/problem.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::output {

/// A point in units of the last decimal that a format shows.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Coordinates of this size and beyond, in mm, cannot be written: with six decimals they leave the exact integers.
constexpr double coordinate_limit_mm = 1e9;

/// Whether all points can be rounded. False for NaN and infinity too.
bool can_be_rounded(std::span<const Vec2> points);
/// What to say of points that cannot.
Problem coordinate_problem();

/// Rounds millimetres to a number of decimals, ties to even.
class Grid {
 public:
  /// Pre: 0 <= decimals <= 6.
  explicit Grid(int decimals);

  int decimals() const { return decimals_; }
  /// Pre: |p.x|, |p.y| < coordinate_limit_mm. The result is within half a unit of `p`.
  GridPoint operator()(Vec2 p) const { return {rounded(p.x * units_per_mm_), rounded(p.y * units_per_mm_)}; }

 private:
  /// Adding 1.5 * 2^52 leaves no room for a fraction: the sum's low bits are the nearest integer. Right for
  /// |value| < 2^51 and several times as fast as std::llround.
  static std::int64_t rounded(double value) {
    constexpr double no_fraction = 0x1.8p52;
    return std::bit_cast<std::int64_t>(value + no_fraction) - std::bit_cast<std::int64_t>(no_fraction);
  }

  int decimals_;
  double units_per_mm_;
};

/// Writes `value` units of the last of `decimals` decimals as a number without a leading zero of its whole part or
/// trailing zeros: ".5", "-12.25". Returns the end; at most 22 characters.
char* spell_fixed(char* to, std::int64_t value, int decimals);

/// Half a unit of the last of `decimals` decimals: how far a rounded coordinate may be from the true one.
double half_unit_mm(int decimals);

}  // namespace burin::output
