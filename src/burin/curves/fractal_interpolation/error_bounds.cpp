#include <burin/base/check.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>

namespace burin::curves::fractal_interpolation {

double largest_scaling(const Interpolant& f) {
  double largest = 0.0;
  for (const Piece& piece : f.pieces) largest = std::max(largest, sup_bound(piece.scaling));
  return largest;
}

Spans spans(const Interpolant& f) {
  double low = f.whole.right;
  double high = f.whole.right;
  for (const Piece& piece : f.pieces) {
    low = std::min(low, piece.ends.left);
    high = std::max(high, piece.ends.left);
  }
  const double middle = 0.5 * (low + high);
  const auto span = [&](const EndData& ends) {
    return std::max(std::abs(ends.left - middle), std::abs(ends.right - middle)) +
           std::max(std::abs(ends.left_slope), std::abs(ends.right_slope));
  };
  Spans result{middle, 0.0, span(f.whole)};
  for (const Piece& piece : f.pieces) result.own = std::max(result.own, span(piece.ends));
  return result;
}

double gap_bound(const Interpolant& f) {
  const double s = largest_scaling(f);
  const Spans span = spans(f);
  return s / (1.0 - s) * (span.own + span.whole);
}

std::vector<Stretch> stretches(const Interpolant& f) {
  const Spans span = spans(f);
  const double distance = (span.own + span.whole) / (1.0 - largest_scaling(f));
  std::vector<Stretch> result;
  result.reserve(f.pieces.size());
  for (std::size_t i = 0; i < f.pieces.size(); ++i) {
    const Piece& piece = f.pieces[i];
    Stretch stretch{sup_bound(piece.scaling), lipschitz_bound(piece.scaling), 0.0, slope_bound(piece.ends, piece.shape),
                    0.0};
    const bool same_whole = i > 0 && piece.shape == f.pieces[i - 1].shape;
    stretch.whole_slope = same_whole ? result.back().whole_slope : slope_bound(f.whole, piece.shape);
    stretch.drift = stretch.scaling_slope * distance + stretch.scaling * stretch.whole_slope + stretch.own_slope;
    result.push_back(stretch);
  }
  return result;
}

std::vector<double> level_bounds(const Interpolant& f, int levels) {
  double drift = 0.0;
  for (const Stretch& stretch : stretches(f)) drift = std::max(drift, stretch.drift);
  double widest = 0.0;
  for (const Piece& piece : f.pieces) widest = std::max(widest, piece.width);
  const double s = largest_scaling(f);
  double bound = 2.0 * (gap_bound(f) + spans(f).own);
  std::vector<double> bounds;
  double cell = 1.0;
  for (int level = 0; level <= levels; ++level) {
    bound = s * bound + drift * cell;
    cell *= widest;
    bounds.push_back(bound);
  }
  return bounds;
}

double stability_bound(const Interpolant& f, std::span<const double> dv, std::span<const double> dd) {
  const std::size_t n = f.pieces.size();
  BURIN_EXPECT(dv.size() == n + 1 && dd.size() == n + 1);
  const auto larger = [](std::span<const double> moved, std::size_t i, std::size_t j) {
    return std::max(std::abs(moved[i]), std::abs(moved[j]));
  };
  double own = 0.0;
  double least_shape = f.pieces.front().shape.alpha;
  for (std::size_t i = 0; i < n; ++i) {
    const Piece& piece = f.pieces[i];
    const double shape = std::min(piece.shape.alpha, piece.shape.beta);
    least_shape = std::min(least_shape, shape);
    own = std::max(own, larger(dv, i, i + 1) + piece.width * f.length * larger(dd, i, i + 1) / (1.0 + shape));
  }
  const double whole = larger(dv, 0, n) + f.length * larger(dd, 0, n) / (1.0 + least_shape);
  const double s = largest_scaling(f);
  return (own + s * whole) / (1.0 - s);
}

}  // namespace burin::curves::fractal_interpolation
