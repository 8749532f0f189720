#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/base/number_text.hpp>
#include <burin/curves/fractal_interpolation/dimension.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>
#include <burin/curves/fractal_interpolation/limit.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

bool is_whole_curve(const Curve& curve) {
  return curve.plot == Plot::curve && !curve.part;
}

FractalDimension dimension_of(const Block& block) {
  const Interpolant& first = block.functions.front();
  if (block.functions.size() == 1) return graph_dimension(first);
  return {.bounds = {1.0, contour_dimension_bound(first, block.functions.back())}};
}

std::optional<double> larger(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::optional(std::max(*a, *b)) : std::nullopt;
}

/// Of two pieces of one curve: the dimension of both is the larger one.
FractalDimension united(const FractalDimension& a, const FractalDimension& b) {
  FractalDimension both = a.bounds.lower >= b.bounds.lower ? a : b;
  both.bounds.upper = std::max(a.bounds.upper, b.bounds.upper);
  both.spectral = larger(a.spectral, b.spectral);
  both.oscillation = larger(a.oscillation, b.oscillation);
  return both;
}

Smoothness united(const Smoothness& a, const Smoothness& b) {
  Smoothness both{std::min(a.proven, b.proven), a.excluded ? a.excluded : b.excluded,
                  std::min(a.exponent_low, b.exponent_low), a.exponent_high ? a.exponent_high : b.exponent_high};
  if (a.exponent_high && b.exponent_high) both.exponent_high = std::min(*a.exponent_high, *b.exponent_high);
  return both;
}

std::string shown(double bound) {
  return fmt::format("{:.4g}", bound);
}

std::string smoothness_text(const Smoothness& smoothness) {
  std::string text = smoothness.proven == 1
                         ? "proven: C1, for every scaling stays below its interval's share of the whole\n"
                         : "proven: C0\n";
  if (smoothness.excluded) text += fmt::format("excluded: C{}, by the dimension\n", *smoothness.excluded);
  text += fmt::format("H\u00f6lder exponent: at least {}", fixed_text(smoothness.exponent_low, 4));
  if (smoothness.exponent_high) text += fmt::format(", at most {}", fixed_text(*smoothness.exponent_high, 4));
  return text + '\n';
}

std::string dimension_text(const FractalDimension& dimension) {
  std::string text = fmt::format("box dimension: {} to {}", fixed_text(dimension.bounds.lower, 4),
                                 fixed_text(dimension.bounds.upper, 4));
  if (dimension.certificate)
    text += fmt::format(", the lower bound by the growth from level {}", *dimension.certificate);
  text += '\n';
  if (dimension.spectral) {
    text += fmt::format("for rough data: {}, by the spectral radius\n", fixed_text(*dimension.spectral, 4));
  }
  if (dimension.oscillation) {
    text += fmt::format("measured: {}, by how the oscillations grow\n", fixed_text(*dimension.oscillation, 4));
  }
  return text;
}

}  // namespace

Smoothness smoothness_of(const Interpolant& f, const FractalDimension& dimension) {
  Smoothness smoothness{.proven = 1, .exponent_low = 1.0};
  for (const Piece& piece : f.pieces) {
    const double s = sup_bound(piece.scaling);
    if (s < piece.width) continue;
    smoothness.proven = 0;
    smoothness.exponent_low = std::min(smoothness.exponent_low, math::log(s) / math::log(piece.width));
  }
  if (dimension.bounds.lower > 1.0) {
    smoothness.excluded = 1;
    smoothness.exponent_high = 2.0 - dimension.bounds.lower;
  }
  return smoothness;
}

LimitFacts limit_facts(const Curve& curve) {
  LimitFacts facts;
  if (!is_whole_curve(curve)) return facts;
  for (const Block& block : curve.blocks) {
    const FractalDimension dimension = dimension_of(block);
    for (const Interpolant& f : block.functions) {
      const Smoothness smoothness = smoothness_of(f, dimension);
      facts.smoothness = facts.smoothness ? united(*facts.smoothness, smoothness) : smoothness;
    }
    facts.fractal_dimension = facts.fractal_dimension ? united(*facts.fractal_dimension, dimension) : dimension;
  }
  return facts;
}

std::string theory_text(const Curve& curve) {
  std::size_t intervals = 0;
  double scaling = 0.0;
  double gap = 0.0;
  double miss = 0.0;
  for (const Block& block : curve.blocks) {
    intervals += block.functions.front().pieces.size();
    // Of x and y of a contour, the squares count together.
    double block_gap = 0.0;
    double block_miss = 0.0;
    for (const Interpolant& f : block.functions) {
      scaling = std::max(scaling, largest_scaling(f));
      const double polyline = level_bounds(f, curve.levels).back();
      block_gap += f.gap * f.gap;
      block_miss += polyline * polyline;
    }
    gap = std::max(gap, std::sqrt(block_gap));
    miss = std::max(miss, std::sqrt(block_miss));
  }
  std::string text = fmt::format(
      "{} intervals, the scaling at most {} in size\n"
      "nowhere farther from the curve without scaling than {}\n"
      "nowhere farther from its polyline of level {} than {}\n",
      intervals, shortest_text(scaling), shown(gap), curve.levels, shown(miss));
  const LimitFacts facts = limit_facts(curve);
  if (facts.smoothness) text += smoothness_text(*facts.smoothness);
  if (facts.fractal_dimension) text += dimension_text(*facts.fractal_dimension);
  return text;
}

}  // namespace burin::curves::fractal_interpolation
