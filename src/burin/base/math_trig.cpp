#include <cmath>
#include <limits>

#include <burin/base/angle_reduction.hpp>
#include <burin/base/double_double.hpp>
#include <burin/base/math.hpp>

namespace burin::math {

namespace {

constexpr DoubleDouble minus_sixth{-0x1.5555555555555p-3, -0x1.5555555555555p-57};

/// Taylor's series: |angle| <= pi/4 and a little leaves less than 2^-60 after r^17. The cubic term, the only one whose
/// rounding would show, is carried with its rest.
DoubleDouble sine_of(DoubleDouble angle) {
  const double r = angle.hi;
  const DoubleDouble square = two_product(r, r);
  const double z = square.hi;
  double series = -1.0 / 1307674368000.0 + z / 355687428096000.0;
  series = 1.0 / 6227020800.0 + z * series;
  series = -1.0 / 39916800.0 + z * series;
  series = 1.0 / 362880.0 + z * series;
  series = -1.0 / 5040.0 + z * series;
  series = 1.0 / 120.0 + z * series;
  const DoubleDouble parabola = quick_two_sum(minus_sixth.hi, z * series);
  const double bend = z * parabola.hi + (z * (parabola.lo + minus_sixth.lo) + square.lo * parabola.hi);
  return quick_two_sum(r, r * bend + angle.lo * (1.0 - 0.5 * z));
}

/// Taylor's series to r^18; 1 - r^2/2 is formed exactly.
DoubleDouble cosine_of(DoubleDouble angle) {
  const double r = angle.hi;
  const DoubleDouble square = two_product(r, r);
  const double z = square.hi;
  double series = 1.0 / 20922789888000.0 - z / 6402373705728000.0;
  series = -1.0 / 87178291200.0 + z * series;
  series = 1.0 / 479001600.0 + z * series;
  series = -1.0 / 3628800.0 + z * series;
  series = 1.0 / 40320.0 + z * series;
  series = -1.0 / 720.0 + z * series;
  series = 1.0 / 24.0 + z * series;
  const DoubleDouble parabola = quick_two_sum(1.0, -0.5 * z);
  return quick_two_sum(parabola.hi, parabola.lo + (z * z * series - (0.5 * square.lo + r * angle.lo)));
}

DoubleDouble sine_of(const ReducedAngle& angle) {
  const DoubleDouble value = angle.quadrant % 2 == 0 ? sine_of(angle.rest) : cosine_of(angle.rest);
  return angle.quadrant < 2 ? value : -value;
}

DoubleDouble cosine_of(const ReducedAngle& angle) {
  return sine_of(ReducedAngle{(angle.quadrant + 1) & 3, angle.rest});
}

double tangent_of(const ReducedAngle& angle) {
  const DoubleDouble cosine = cosine_of(angle);
  if (cosine.hi == 0.0) return std::numeric_limits<double>::infinity();
  return (sine_of(angle) / cosine).hi;
}

/// Below this a sine or a tangent is its argument to half an ulp.
constexpr double negligible_cube = 0x1p-27;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double sin(double radians) {
  if (std::abs(radians) < negligible_cube) return radians;
  return std::isfinite(radians) ? sine_of(reduce_radians(radians)).hi : nan;
}

double cos(double radians) {
  return std::isfinite(radians) ? cosine_of(reduce_radians(radians)).hi : nan;
}

CosineSine cos_sin(double radians) {
  if (!std::isfinite(radians)) return {nan, nan};
  const ReducedAngle angle = reduce_radians(radians);
  const double cosine = cosine_of(angle.rest).hi;
  const double sine = sine_of(angle.rest).hi;
  // Which is which, and its sign, is not for a branch to guess.
  const bool swapped = angle.quadrant % 2 != 0;
  const double x = swapped ? sine : cosine;
  const double y = swapped ? cosine : sine;
  const double small = std::abs(radians) < negligible_cube ? radians : y;
  return {angle.quadrant == 1 || angle.quadrant == 2 ? -x : x, angle.quadrant < 2 ? small : -y};
}

double tan(double radians) {
  if (std::abs(radians) < negligible_cube) return radians;
  return std::isfinite(radians) ? tangent_of(reduce_radians(radians)) : nan;
}

// The sum with zero turns -0 into 0: multiples of 180 degrees give the same zero whatever their sign.

double sin_degrees(double degrees) {
  return std::isfinite(degrees) ? sine_of(reduce_degrees(degrees)).hi + 0.0 : nan;
}

double cos_degrees(double degrees) {
  return std::isfinite(degrees) ? cosine_of(reduce_degrees(degrees)).hi + 0.0 : nan;
}

double tan_degrees(double degrees) {
  return std::isfinite(degrees) ? tangent_of(reduce_degrees(degrees)) + 0.0 : nan;
}

}  // namespace burin::math
