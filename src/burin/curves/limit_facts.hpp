#pragma once

#include <optional>

namespace burin::curves {

/// How smooth a limit is as a function of its parameter. C-1: not even continuous.
struct Smoothness {
  int proven = -1;                        ///< C^proven for all data; -1: nothing proven
  std::optional<int> excluded{};          ///< not C^excluded for all data; 0: there is no limit
  double exponent_low = 0.0;              ///< Hoelder exponent: at least this
  std::optional<double> exponent_high{};  ///< and at most this
};

/// Bounds of a box dimension.
struct DimensionBounds {
  double lower = 1.0;
  double upper = 1.0;
};

/// The box dimension of a fractal interpolation's curve.
struct FractalDimension {
  DimensionBounds bounds{};             ///< proven
  std::optional<double> spectral{};     ///< what it is for rough data, by a spectral radius
  std::optional<double> oscillation{};  ///< measured: how much more the curve swings in all from level to level
  std::optional<int> certificate{};     ///< the level whose oscillations prove a lower bound above 1
};

/// What is known of the limit of a curve beside its points.
struct LimitFacts {
  std::optional<double> similarity_dimension{};
  std::optional<Smoothness> smoothness{};
  std::optional<FractalDimension> fractal_dimension{};
};

}  // namespace burin::curves
