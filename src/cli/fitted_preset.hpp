#pragma once

#include <span>
#include <string>

#include <burin/curves/fractal_interpolation/fit.hpp>

namespace burin::cli {

/// What a fitted curve was made from, for the preset that draws it over its data.
struct FittedData {
  std::string file;  ///< as the preset is to name it
  bool closed = false;
  bool lonlat = false;
};

/// A preset with the data as a thick pale line, the fit over it and a dot at each knot. The fit is stored as numbers:
/// knots, their parameters, alpha, beta and scaling. `points` are those that were fitted.
std::string fitted_preset(const curves::fractal_interpolation::Comparison& comparison,
                          curves::fractal_interpolation::Method method, std::span<const Vec2> points,
                          const FittedData& data);

}  // namespace burin::cli
