#pragma once

#include <cmath>

/// Numbers of about 106 bits as unevaluated sums hi + lo, |lo| <= ulp(hi)/2. Private to the elementary functions, which
/// carry their critical steps in it so that only the last rounding shows. No fused multiply-add: the same bits
/// everywhere. Sources: Dekker 1971, Knuth TAOCP 4.2.2. Magnitudes stay within 2^±480, so nothing overflows.
namespace burin::math {

struct DoubleDouble {
  double hi = 0.0;
  double lo = 0.0;
};

/// a + b exactly. Pre: |a| >= |b| or a == 0.
constexpr DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_kept = sum - a;
  return {sum, (a - (sum - b_kept)) + (b - b_kept)};
}

/// a as a sum of two numbers of 26 bits, whose products with other such halves are exact.
constexpr DoubleDouble split(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double hi = scaled - (scaled - a);
  return {hi, a - hi};
}

/// a * b exactly.
constexpr DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

constexpr DoubleDouble operator-(DoubleDouble a) {
  return {-a.hi, -a.lo};
}
constexpr DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble sum = two_sum(a.hi, b);
  return quick_two_sum(sum.hi, sum.lo + a.lo);
}
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.hi, b.hi);
  const DoubleDouble low = two_sum(a.lo, b.lo);
  const DoubleDouble sum = quick_two_sum(high.hi, high.lo + low.hi);
  return quick_two_sum(sum.hi, sum.lo + low.lo);
}
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + -b;
}
constexpr DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble product = two_product(a.hi, b);
  return quick_two_sum(product.hi, product.lo + a.lo * b);
}
constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.hi, b.hi);
  return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.hi / b.hi;
  const DoubleDouble rest = a - b * quotient;
  return quick_two_sum(quotient, rest.hi / b.hi);
}

/// Pre: a >= 0.
inline DoubleDouble square_root(DoubleDouble a) {
  const double root = std::sqrt(a.hi);
  if (root == 0.0) return {};
  const DoubleDouble rest = a - two_product(root, root);
  return quick_two_sum(root, rest.hi / (2.0 * root));
}

/// The integer nearest to x, ties to even. Pre: |x| < 2^51.
constexpr double nearest_integer(double x) {
  return (x + 0x1.8p52) - 0x1.8p52;
}

inline constexpr DoubleDouble pi_pair{0x1.921fb54442d18p1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble half_pi_pair{0x1.921fb54442d18p0, 0x1.1a62633145c07p-54};
inline constexpr DoubleDouble radians_per_degree_pair{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
inline constexpr DoubleDouble degrees_per_radian_pair{0x1.ca5dc1a63c1f8p5, -0x1.1e7ab456405f9p-49};

}  // namespace burin::math
