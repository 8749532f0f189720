#pragma once

#include <burin/curves/fractal_interpolation/fit.hpp>

namespace burin::curves::fractal_interpolation {

/// Which numbers of a fit may move.
struct Freedom {
  bool scalings = true;
  bool shapes = true;
};

/// Makes a fit better by Levenberg and Marquardt on the true error instead of the collage's, which the derivatives of
/// phi by its parameters allow; never worse than `start`. Chebyshev scalings only; those
/// with fewer coefficients than others get more.
/// O(rounds (places depth^2 + (intervals coefficients)^3)). Source: reference interpolation 7.
CoordinateFit refined(const DenseData& dense, CoordinateFit start, Freedom freedom, int rounds = 60);

}  // namespace burin::curves::fractal_interpolation
