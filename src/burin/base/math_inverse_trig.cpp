#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <burin/base/double_double.hpp>
#include <burin/base/math.hpp>

namespace burin::math {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The arc tangent of i/16: the nearest double and the double nearest to the rest.
constexpr std::array<DoubleDouble, 17> arc_tangents{{
    {0.0, 0.0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
}};

/// The arc tangent of y/x in [0, pi/2], relative error below 2^-62. The nearest angle of the table is turned away
/// first: what is left is the arc tangent of at most 1/32, a short series.
/// Pre: x, y >= 0, one of them positive, both 0 or within 2^±450.
DoubleDouble angle_of_ratio(DoubleDouble y, DoubleDouble x) {
  const bool steep = y.hi > x.hi;
  if (steep) std::swap(x, y);
  const double sixteenths = nearest_integer(16.0 * (y.hi / x.hi));
  const double slope = sixteenths / 16.0;
  const DoubleDouble t = (y - x * slope) / (x + y * slope);
  const double z = t.hi * t.hi;
  double series = -1.0 / 11.0 + z / 13.0;
  series = 1.0 / 9.0 + z * series;
  series = -1.0 / 7.0 + z * series;
  series = 1.0 / 5.0 + z * series;
  series = -1.0 / 3.0 + z * series;
  const DoubleDouble known = arc_tangents[static_cast<std::size_t>(sixteenths)];
  const DoubleDouble sum = two_sum(known.hi, t.hi);
  const DoubleDouble angle = quick_two_sum(sum.hi, sum.lo + (known.lo + (t.lo + t.hi * z * series)));
  return steep ? half_pi_pair - angle : angle;
}

/// The angle of the point (x, y), x and y >= 0 and finite, not both 0.
DoubleDouble angle_in_first_quadrant(double y, double x) {
  constexpr double extreme_ratio = 0x1p60;  // beyond it the angle is the ratio itself, or pi/2 less a negligible one
  if (y * extreme_ratio < x) return {y / x, 0.0};
  if (x * extreme_ratio < y) return half_pi_pair;
  const double largest = std::max(x, y);
  const double scale = largest > 0x1p400 ? 0x1p-640 : largest < 0x1p-300 ? 0x1p700 : 1.0;
  return angle_of_ratio({y * scale, 0.0}, {x * scale, 0.0});
}

/// The angle of the point (x, |y|) in [0, pi]; NaN for NaN.
DoubleDouble angle_above_axis(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return {nan, nan};
  if (std::isinf(x) || std::isinf(y)) {
    x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
    y = std::isinf(y) ? 1.0 : 0.0;
  }
  if (y == 0.0) return std::signbit(x) ? pi_pair : DoubleDouble{};
  const DoubleDouble angle = angle_in_first_quadrant(std::abs(y), std::abs(x));
  return std::signbit(x) ? pi_pair - angle : angle;
}

/// The leg sqrt(1 - x^2) of a right triangle with hypotenuse 1. Pre: |x| <= 1.
DoubleDouble other_leg(double x) {
  return square_root(-two_product(x, x) + 1.0);
}

/// The angle in [0, pi/2] whose sine is x. Pre: 0 <= x <= 1.
DoubleDouble arc_sine(double x) {
  if (x < 0x1p-27) return {x, 0.0};
  return angle_of_ratio({x, 0.0}, other_leg(x));
}

/// The angle in [0, pi] whose cosine is x. Pre: |x| <= 1.
DoubleDouble arc_cosine(double x) {
  if (std::abs(x) < 0x1p-60) return half_pi_pair;
  const DoubleDouble angle = angle_of_ratio(other_leg(x), {std::abs(x), 0.0});
  return x < 0.0 ? pi_pair - angle : angle;
}

double to_degrees(DoubleDouble radians) {
  // Below this the exact product of the pair would lose bits to underflow.
  if (radians.hi < 0x1p-900) return radians.hi * degrees_per_radian_pair.hi;
  return (radians * degrees_per_radian_pair).hi;
}

}  // namespace

double asin(double x) {
  return std::abs(x) <= 1.0 ? std::copysign(arc_sine(std::abs(x)).hi, x) : nan;
}

double acos(double x) {
  return std::abs(x) <= 1.0 ? arc_cosine(x).hi : nan;
}

double atan(double x) {
  return std::copysign(angle_above_axis(x, 1.0).hi, x);
}

double atan2(double y, double x) {
  return std::copysign(angle_above_axis(y, x).hi, y);
}

double asin_degrees(double x) {
  return std::abs(x) <= 1.0 ? std::copysign(to_degrees(arc_sine(std::abs(x))), x) : nan;
}

double acos_degrees(double x) {
  return std::abs(x) <= 1.0 ? to_degrees(arc_cosine(x)) : nan;
}

double atan_degrees(double x) {
  return std::copysign(to_degrees(angle_above_axis(x, 1.0)), x);
}

double atan2_degrees(double y, double x) {
  return std::copysign(to_degrees(angle_above_axis(y, x)), y);
}

}  // namespace burin::math
