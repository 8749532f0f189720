#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <burin/curves/fractal_interpolation/derivatives.hpp>
#include <burin/curves/fractal_interpolation/interpolant.hpp>
#include <burin/params/read_value.hpp>

/// Interpolants of few knots that come near many points. By the collage theorem |g - phi| <= |g - T g| / (1 - S), T the
/// right side of the functional equation, so that each interval's scaling is a small linear least-squares problem.
/// Source: reference interpolation 7, 8.
namespace burin::curves::fractal_interpolation {

/// Ways from knots to a curve, each with more freedom than the one before.
enum class Method : std::uint8_t {
  cubic_spline,         ///< through the knots, nothing fitted
  polynomial_function,  ///< alpha = beta = 3; linear scaling functions
  rational_constant,    ///< alpha, beta and constant scaling
  rational_function,    ///< alpha, beta and linear scaling functions
};
inline constexpr std::size_t method_count = 4;

constexpr auto words(Method) {
  return std::array<params::Word<Method>, method_count>{{{"cubic-spline", Method::cubic_spline},
                                                         {"polynomial-function", Method::polynomial_function},
                                                         {"rational-constant", Method::rational_constant},
                                                         {"rational-function", Method::rational_function}}};
}

/// How derivatives at knots are had from values.
enum class DerivativeRule : std::uint8_t { mean, spline };
constexpr auto words(DerivativeRule) {
  return std::array<params::Word<DerivativeRule>, 2>{
      {{"mean", DerivativeRule::mean}, {"spline", DerivativeRule::spline}}};
}
std::vector<double> derivatives_by(DerivativeRule rule, std::span<const double> x, std::span<const double> values,
                                   Ends ends);

/// The most that sum |c| of a fitted scaling may be.
inline constexpr double largest_fitted_scaling = 0.9;

/// g over t at many places, some of which are knots. Pre: t increases; the first and the last place are knots.
struct DenseData {
  std::span<const double> t;
  std::span<const double> g;
  std::span<const std::size_t> knots;
  Ends ends = Ends::open;
};

/// One coordinate fitted.
struct CoordinateFit {
  DerivativeRule rule = DerivativeRule::mean;
  InterpolationData data;
  double mean_square = 0.0;  ///< of phi - g at all places
};

/// The collage fit with `coefficients` Chebyshev coefficients for each scaling (0: no scaling) and, with `shapes`, a
/// search for alpha and beta of each interval; else both stay 3.
CoordinateFit collage_fit(const DenseData& dense, DerivativeRule rule, std::size_t coefficients, bool shapes);

/// The same with derivatives and shapes given. Pre: one for each knot, one for each interval.
CoordinateFit collage_fit(const DenseData& dense, std::vector<double> derivatives, std::vector<Shape> shapes,
                          std::size_t coefficients);

/// The fits of every method up to this one: each is the best of those for both derivative rules and of the methods it
/// contains, so that a method with more freedom is never worse. Time O(places), and for each interval's shape some
/// hundred looks at no more than 400 places.
std::vector<CoordinateFit> fits_up_to(Method last, const DenseData& dense);
CoordinateFit fit_by(Method method, const DenseData& dense);

/// Both coordinates of a plane curve fitted.
struct ContourFit {
  std::array<CoordinateFit, 2> coordinates;
  double rmse = 0.0;  ///< root of the mean squared distance at all places
};

/// A contour fitted by every method over the chord length of its points.
struct Comparison {
  std::vector<double> t;           ///< of each point
  std::vector<std::size_t> knots;  ///< indices of points
  std::size_t step = 1;            ///< every so-manieth point is fitted, where there are hundreds for each interval
  std::array<ContourFit, method_count> fits;
};

/// Knots at `intervals` equal steps; values and RMSE, which is of the points fitted, in units of the larger side. Pre:
/// intervals < points; no point repeats its predecessor; periodic: the last point is the first.
Comparison compare_methods(std::span<const Vec2> points, int intervals, Ends ends);

/// How many numbers a fitted plane curve of n intervals stores: knots and their parameters, then what is fitted.
std::size_t stored_numbers(Method method, std::size_t intervals);

}  // namespace burin::curves::fractal_interpolation
