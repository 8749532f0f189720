#pragma once

#include <optional>
#include <vector>

#include <burin/curves/fractal_interpolation/interpolant.hpp>
#include <burin/curves/fractal_interpolation/params.hpp>
#include <burin/expr/expression.hpp>

namespace burin::curves::fractal_interpolation {

/// Intervals that make a fractal of their own.
struct Block {
  std::vector<Interpolant> functions;  ///< y(x), or x(t) and y(t)
  double chord_length = 0.0;           ///< of its nodes
};

/// What is drawn, made once from the parameters: data read, cleaned and fitted.
struct Curve {
  bool planar = false;  ///< x(t), y(t) instead of y(x)
  bool closed = false;
  int levels = 0;
  Plot plot = Plot::curve;
  double stretch = 1.0;
  std::optional<Interval> part;           ///< of the whole, from 0 to 1
  std::optional<expr::Expression> exact;  ///< of x, for Plot::error
  std::vector<Block> blocks;              ///< one at least
};

/// The parameters as a curve; nothing after reporting what is wrong with them. O(points) and what a fit takes.
std::optional<Curve> make_curve(const FractalInterpolationParams& params, const params::Table& table,
                                params::ReadContext& context);

}  // namespace burin::curves::fractal_interpolation
