#pragma once

#include <cstdint>
#include <vector>

#include <burin/curves/fractal_interpolation/interval.hpp>

namespace burin::curves::fractal_interpolation {

/// A vertical scaling factor s(theta) over [0, 1], the place of the SOURCE point in the whole interval:
///   chebyshev    c0 T0 + c1 T1 + ... of 2 theta - 1; one coefficient is a constant
///   sine         c0 + c1 sin(c2 theta + c3)
///   exponential  c0 exp(c1 theta)
/// Pre of all functions: as many coefficients as the kind takes, all finite. Source: reference interpolation 1.
struct Scaling {
  enum class Kind : std::uint8_t { chebyshev, sine, exponential };
  Kind kind = Kind::chebyshev;
  std::vector<double> c{0.0};
  friend bool operator==(const Scaling&, const Scaling&) = default;
};

Scaling constant_scaling(double s);

double scaling_at(const Scaling& scaling, double theta);

/// A bound of |s| on [0, 1]: sum of |c| (sharp for one and two coefficients), |c0| + |c1|, the larger end.
double sup_bound(const Scaling& scaling);

/// A Lipschitz bound of s in theta on [0, 1].
double lipschitz_bound(const Scaling& scaling);

/// An interval that holds s over a part of [0, 1].
Interval scaling_range(const Scaling& scaling, Interval over);

}  // namespace burin::curves::fractal_interpolation
