#include <burin/base/check.hpp>
#include <burin/curves/fractal_interpolation/derivatives.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

/// Lengths of the intervals and slopes of the chords.
struct Chords {
  std::vector<double> h;
  std::vector<double> slope;
};

Chords chords_of(std::span<const double> x, std::span<const double> values) {
  BURIN_EXPECT(x.size() == values.size() && x.size() >= 2);
  Chords chords;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    chords.h.push_back(x[i + 1] - x[i]);
    chords.slope.push_back((values[i + 1] - values[i]) / chords.h.back());
  }
  return chords;
}

/// Solves a tridiagonal system without pivoting (those of splines are diagonally dominant but for the first and last
/// row, which do no harm): lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = right[i].
std::vector<double> solve_tridiagonal(const std::vector<double>& lower, std::vector<double> diagonal,
                                      const std::vector<double>& upper, std::vector<double> right) {
  const std::size_t n = diagonal.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  right[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i > 0; --i) right[i - 1] = (right[i - 1] - upper[i - 1] * right[i]) / diagonal[i - 1];
  return right;
}

std::vector<double> not_a_knot(const Chords& chords) {
  const std::vector<double>& h = chords.h;
  const std::vector<double>& slope = chords.slope;
  const std::size_t last = h.size();
  std::vector<double> lower(last + 1, 0.0);
  std::vector<double> diagonal(last + 1, 0.0);
  std::vector<double> upper(last + 1, 0.0);
  std::vector<double> right(last + 1, 0.0);
  for (std::size_t i = 1; i < last; ++i) {
    lower[i] = h[i];
    diagonal[i] = 2.0 * (h[i - 1] + h[i]);
    upper[i] = h[i - 1];
    right[i] = 3.0 * (h[i] * slope[i - 1] + h[i - 1] * slope[i]);
  }
  const double a = h[0] + h[1];
  diagonal[0] = h[1];
  upper[0] = a;
  right[0] = ((h[0] + 2.0 * a) * h[1] * slope[0] + h[0] * h[0] * slope[1]) / a;
  const double b = h[last - 1] + h[last - 2];
  diagonal[last] = h[last - 2];
  lower[last] = b;
  right[last] =
      (h[last - 1] * h[last - 1] * slope[last - 2] + (2.0 * b + h[last - 1]) * h[last - 2] * slope[last - 1]) / b;
  return solve_tridiagonal(lower, std::move(diagonal), upper, std::move(right));
}

/// The cyclic system for the derivatives at nodes 0 .. n-1, by Sherman and Morrison.
std::vector<double> periodic_spline(const Chords& chords) {
  const std::vector<double>& h = chords.h;
  const std::vector<double>& slope = chords.slope;
  const std::size_t n = h.size();
  std::vector<double> lower(n);
  std::vector<double> diagonal(n);
  std::vector<double> upper(n);
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    lower[i] = h[i];
    diagonal[i] = 2.0 * (h[before] + h[i]);
    upper[i] = h[before];
    right[i] = 3.0 * (h[i] * slope[before] + h[before] * slope[i]);
  }
  const double corner = -diagonal[0];
  std::vector<double> bordered = diagonal;
  bordered[0] -= corner;
  bordered[n - 1] -= lower[0] * upper[n - 1] / corner;
  std::vector<double> column(n, 0.0);
  column[0] = corner;
  column[n - 1] = upper[n - 1];
  std::vector<double> d = solve_tridiagonal(lower, bordered, upper, std::move(right));
  const std::vector<double> z = solve_tridiagonal(lower, std::move(bordered), upper, std::move(column));
  const double ratio = lower[0] / corner;
  const double factor = (d[0] + ratio * d[n - 1]) / (1.0 + z[0] + ratio * z[n - 1]);
  for (std::size_t i = 0; i < n; ++i) d[i] -= factor * z[i];
  d.push_back(d[0]);
  return d;
}

}  // namespace

std::vector<double> mean_derivatives(std::span<const double> x, std::span<const double> values, Ends ends) {
  const auto [h, slope] = chords_of(x, values);
  const std::size_t last = h.size();
  std::vector<double> d(last + 1, slope[0]);
  if (last == 1) return d;
  const auto mean = [&h = h, &slope = slope](std::size_t before, std::size_t after) {
    return (h[after] * slope[before] + h[before] * slope[after]) / (h[before] + h[after]);
  };
  for (std::size_t i = 1; i < last; ++i) d[i] = mean(i - 1, i);
  if (ends == Ends::periodic) {
    d[0] = d[last] = mean(last - 1, 0);
  } else {
    d[0] = slope[0] + (slope[0] - slope[1]) * h[0] / (h[0] + h[1]);
    d[last] = slope[last - 1] + (slope[last - 1] - slope[last - 2]) * h[last - 1] / (h[last - 1] + h[last - 2]);
  }
  return d;
}

std::vector<double> spline_derivatives(std::span<const double> x, std::span<const double> values, Ends ends) {
  const Chords chords = chords_of(x, values);
  // Through two or three nodes the curve without a knot is the line or parabola that the mean rule is exact on.
  if (chords.h.size() < 3) return mean_derivatives(x, values, ends);
  return ends == Ends::periodic ? periodic_spline(chords) : not_a_knot(chords);
}

}  // namespace burin::curves::fractal_interpolation
