#pragma once

#include <span>
#include <vector>

/// Derivatives at the nodes when only values are known. Pre: x increases, as many values as nodes, at least two.
namespace burin::curves::fractal_interpolation {

/// Whether the last node is the first one again.
enum class Ends : bool { open, periodic };

/// The arithmetic mean method, exact on quadratics. Periodic: the values at both ends are equal, and the derivatives
/// become so. O(n). Source: reference interpolation 1.
std::vector<double> mean_derivatives(std::span<const double> x, std::span<const double> values, Ends ends);

/// The derivatives of the cubic spline: not-a-knot at open ends (a parabola through three nodes, a line through two).
/// With them, alpha = beta = 3 and s = 0 the interpolant is that spline. O(n).
std::vector<double> spline_derivatives(std::span<const double> x, std::span<const double> values, Ends ends);

}  // namespace burin::curves::fractal_interpolation
