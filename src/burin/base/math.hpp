#pragma once

/// Elementary functions made of IEEE basic operations only, so that every machine, compiler and optimisation level
/// gives the same bits. The library calls these instead of libm's (whose last bit differs between systems); std::sqrt,
/// fma-free arithmetic, floor and the like are exact everywhere and may be used as they are.
namespace burin::math {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double tau = 2.0 * pi;
inline constexpr double radians_per_degree = pi / 180.0;

/// Within 1 ulp of the true value for |radians| <= 2^30 (larger arguments are reduced exactly all the same); NaN for
/// infinities and NaN.
double sin(double radians);
double cos(double radians);
double tan(double radians);

/// Of an angle in degrees, exact at multiples of 30 and 90 where the value is 0, 1/2 or 1: sin_degrees(30) == 0.5.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

double asin(double x);
double acos(double x);
double atan(double x);
/// In (-pi, pi], with IEEE's rules for zeros and infinities.
double atan2(double y, double x);

double exp(double x);
double log(double x);
/// IEEE pow; exact whenever the result of an integer power of at most 2^53 is representable, within 1 ulp else.
double pow(double base, double exponent);
/// sqrt(x^2 + y^2) without overflow or harmful underflow.
double hypot(double x, double y);

}  // namespace burin::math
