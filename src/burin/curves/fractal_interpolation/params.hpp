#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/fractal_interpolation/fit.hpp>
#include <burin/params/fields.hpp>

namespace burin::curves {

namespace fractal_interpolation {

/// What the data is a function of.
enum class Over : std::uint8_t { x, chords };
constexpr auto words(Over) {
  return std::array<params::Word<Over>, 2>{{{"x", Over::x}, {"chords", Over::chords}}};
}

/// What is drawn.
enum class Plot : std::uint8_t { curve, nodes, error, perturbation };
constexpr auto words(Plot) {
  return std::array<params::Word<Plot>, 4>{
      {{"curve", Plot::curve}, {"nodes", Plot::nodes}, {"error", Plot::error}, {"perturbation", Plot::perturbation}}};
}

/// A number for every interval: one for all, or a list that starts over.
struct EachInterval {
  std::vector<double> values;
};

/// The same of scalings.
struct EachScaling {
  std::vector<Scaling> values{Scaling{}};
};

/// A rule, or the derivatives themselves when there are any.
struct Derivatives {
  DerivativeRule rule = DerivativeRule::mean;
  std::vector<double> given{};
};

/// What x(t) or y(t) of a contour has of its own.
struct Coordinate {
  std::optional<EachInterval> alpha;
  std::optional<EachInterval> beta;
  std::optional<EachScaling> scaling;
  std::optional<Derivatives> derivatives;

  static constexpr auto fields() {
    return std::tuple{params::field("alpha", &Coordinate::alpha, "as in the curve"),
                      params::field("beta", &Coordinate::beta, "as in the curve"),
                      params::field("scaling", &Coordinate::scaling, "as in the curve"),
                      params::field("derivatives", &Coordinate::derivatives, "as in the curve")};
  }
};
static_assert(params::ParamStruct<Coordinate>);

}  // namespace fractal_interpolation

/// Rational fractal interpolation with function scaling, of y over x or of a plane contour over its chord length. At
/// alpha = beta = 3 it is the polynomial one; with derivatives = "spline" and no scaling too, the cubic spline.
/// Source: Song, Yang, Jiang, Bao, Zhang (2021); reference interpolation.
struct FractalInterpolationParams {
  std::vector<Vec2> points;
  std::string data;
  std::optional<fractal_interpolation::Over> over;
  bool closed = false;
  bool lonlat = false;
  std::optional<int> intervals;
  std::vector<double> at;
  std::optional<fractal_interpolation::Method> fit;
  fractal_interpolation::EachInterval alpha{{3.0}};
  fractal_interpolation::EachInterval beta{{3.0}};
  fractal_interpolation::EachScaling scaling;
  fractal_interpolation::Derivatives derivatives;
  fractal_interpolation::Coordinate x;
  fractal_interpolation::Coordinate y;
  std::optional<int> block;
  int levels = 3;
  fractal_interpolation::Plot plot = fractal_interpolation::Plot::curve;
  std::string exact;
  std::vector<double> perturbation;
  double stretch = 1.0;
  std::vector<double> part;

  static constexpr auto fields() {
    using P = FractalInterpolationParams;
    return std::tuple{
        params::field("points", &P::points, "[[x, y], ...]: what the curve passes through"),
        params::field("data", &P::data, "instead of points: a CSV file of them, one x,y a line"),
        params::field(
            "over", &P::over,
            "x: y is a function of x, which must increase; chords: x and y are functions of the length of the "
            "chords, for curves that turn back; unset: x, or chords when closed"),
        params::field("closed", &P::closed, "a contour that returns to its first point"),
        params::field("lonlat", &P::lonlat,
                      "x and y are degrees of longitude and latitude: x becomes (lon - mean) cos(mean lat)"),
        params::field("intervals", &P::intervals, {2, 1'000'000},
                      "pass only through the points nearest to this many equal steps; unset: through all"),
        params::field("at", &P::at, "the parameter of each point of a contour; unset: the length of the chords"),
        params::field(
            "fit", &P::fit,
            "what comes nearest to all points and passes through those of `intervals`, instead of alpha, beta, "
            "scaling and derivatives; unset: nothing is fitted"),
        params::field("alpha", &P::alpha,
                      "shape of each interval at its left end, 0 or more: a number, or a list whose length divides the "
                      "number of intervals and starts over; 3 is Hermite's cubic, large is straight"),
        params::field("beta", &P::beta, "the same at its right end"),
        params::field("scaling", &P::scaling,
                      "how much of the whole each interval repeats, below 1: a number s, { chebyshev = [c0, c1, ...] } "
                      "for c0 + c1 T1(2x-1) + ..., { sine = [c0, c1, c2, c3] } for c0 + c1 sin(c2 x + c3) or "
                      "{ exponential = [c0, c1] } for c0 exp(c1 x), x from 0 to 1 over the whole; or a list of these, "
                      "in which [c0, c1] is short for chebyshev, that starts over"),
        params::field(
            "derivatives", &P::derivatives,
            "mean: by the arithmetic mean of the chords' slopes; spline: those of the cubic spline; or a list, "
            "one for each point"),
        params::field("x", &P::x, "{ alpha, beta, scaling, derivatives } of a contour's x alone"),
        params::field("y", &P::y, "the same for its y"),
        params::field("block", &P::block, {2, 1'000'000},
                      "intervals that make a fractal of their own; unset: all together"),
        params::field("levels", &P::levels, {0, 1000},
                      "level m has N^(m+1) + 1 points for N intervals; what is drawn is limited by the view"),
        params::field("plot", &P::plot,
                      "curve; nodes: a dot at each point passed through; error: `exact` minus the curve; perturbation: "
                      "the curve minus the one with its points moved by `perturbation`"),
        params::field("exact", &P::exact, "for plot = \"error\": an expression in x"),
        params::field("perturbation", &P::perturbation, "for plot = \"perturbation\": how far up each point is moved"),
        params::field("stretch", &P::stretch, params::positive, "y is drawn this many times as high"),
        params::field("part", &P::part,
                      "[from, to]: only this part of the curve, counted from 0 to 1 along x or the chords")};
  }
};

}  // namespace burin::curves

template <>
struct burin::params::ValueType<burin::curves::fractal_interpolation::EachInterval> {
  using Each = burin::curves::fractal_interpolation::EachInterval;
  static std::string name() { return "number or list of number"; }
  static bool read(const Value& value, Each& each, ReadContext& context);
  static std::string text(const Each& each);
};

template <>
struct burin::params::ValueType<burin::curves::fractal_interpolation::EachScaling> {
  using Each = burin::curves::fractal_interpolation::EachScaling;
  static std::string name() { return "scaling or list of scaling"; }
  static bool read(const Value& value, Each& each, ReadContext& context);
  static std::string text(const Each& each);
};

template <>
struct burin::params::ValueType<burin::curves::fractal_interpolation::Derivatives> {
  using Derivatives = burin::curves::fractal_interpolation::Derivatives;
  static std::string name() { return "mean | spline | list of number"; }
  static bool read(const Value& value, Derivatives& derivatives, ReadContext& context);
  static std::string text(const Derivatives& derivatives);
};

template <>
struct burin::params::ValueType<burin::curves::fractal_interpolation::Coordinate> {
  using Coordinate = burin::curves::fractal_interpolation::Coordinate;
  static std::string name() { return "table"; }
  static bool read(const Value& value, Coordinate& coordinate, ReadContext& context);
  static std::string text(const Coordinate&) { return {}; }
};
