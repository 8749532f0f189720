#pragma once

#include <algorithm>
#include <cmath>

namespace burin::curves::fractal_interpolation {

/// A range of numbers, ends included. Sums and products hold every sum and product of their members, to rounding.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  double width() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
  /// The largest distance of a member from x.
  double reach_from(double x) const { return std::max(high - x, x - low); }

  friend Interval operator+(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }
  friend Interval operator-(Interval a, Interval b) { return {a.low - b.high, a.high - b.low}; }
  friend Interval operator*(Interval a, Interval b) {
    const double p = a.low * b.low;
    const double q = a.low * b.high;
    const double r = a.high * b.low;
    const double s = a.high * b.high;
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
  }
};

/// The smallest interval around both.
inline Interval hull(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// What both share. Pre: they share something; rounding may make it a little less, then it is a point between them.
inline Interval common(Interval a, Interval b) {
  const double low = std::max(a.low, b.low);
  const double high = std::min(a.high, b.high);
  return low <= high ? Interval{low, high} : Interval{high, low};
}

}  // namespace burin::curves::fractal_interpolation
