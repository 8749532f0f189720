#include <algorithm>
#include <cmath>
#include <functional>

#include <burin/base/check.hpp>
#include <burin/curves/fractal_interpolation/least_squares.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

double l1_norm(const std::vector<double>& c) {
  double sum = 0.0;
  for (const double x : c) sum += std::abs(x);
  return sum;
}

}  // namespace

std::vector<double> least_squares(std::span<const double> gram, std::span<const double> moment) {
  // Elimination without pivoting, as fits a Gram matrix; what is left of a dependent column is rounding.
  constexpr double rounding = 1e-13;
  const std::size_t k = moment.size();
  std::vector<double> g(gram.begin(), gram.end());
  std::vector<double> c(moment.begin(), moment.end());
  std::vector<bool> dependent(k, false);
  for (std::size_t j = 0; j < k; ++j) {
    dependent[j] = !(g[j * k + j] > rounding * gram[j * k + j]);
    if (dependent[j]) continue;
    for (std::size_t i = j + 1; i < k; ++i) {
      const double factor = g[i * k + j] / g[j * k + j];
      for (std::size_t l = j; l < k; ++l) g[i * k + l] -= factor * g[j * k + l];
      c[i] -= factor * c[j];
    }
  }
  for (std::size_t j = k; j-- > 0;) {
    if (dependent[j]) {
      c[j] = 0.0;
      continue;
    }
    for (std::size_t l = j + 1; l < k; ++l) c[j] -= g[j * k + l] * c[l];
    c[j] /= g[j * k + j];
  }
  return c;
}

std::vector<double> project_on_l1_ball(std::vector<double> c, double radius) {
  if (l1_norm(c) <= radius) return c;
  std::vector<double> sizes;
  for (const double x : c) sizes.push_back(std::abs(x));
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  // Every coordinate is shrunk by the same amount, those below it to 0.
  double shrink = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    sum += sizes[k];
    const double amount = (sum - radius) / static_cast<double>(k + 1);
    if (sizes[k] > amount) shrink = amount;
  }
  for (double& x : c) x = std::copysign(std::max(std::abs(x) - shrink, 0.0), x);
  return c;
}

std::vector<double> least_squares_within(std::span<const double> gram, std::span<const double> moment, double radius) {
  const std::size_t k = moment.size();
  BURIN_EXPECT(gram.size() == k * k);
  std::vector<double> c = least_squares(gram, moment);
  if (l1_norm(c) <= radius) return c;
  c = project_on_l1_ball(std::move(c), radius);
  if (k == 1) return c;
  constexpr int most_rounds = 2000;
  double steepness = 0.0;
  for (std::size_t j = 0; j < k; ++j) steepness += gram[j * k + j];
  std::vector<double> ahead = c;
  double momentum = 1.0;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<double> next = ahead;
    for (std::size_t i = 0; i < k; ++i) {
      double slope = -moment[i];
      for (std::size_t j = 0; j < k; ++j) slope += gram[i * k + j] * ahead[j];
      next[i] -= slope / steepness;
    }
    next = project_on_l1_ball(std::move(next), radius);
    const double next_momentum = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
    double moved = 0.0;
    for (std::size_t i = 0; i < k; ++i) {
      const double step = next[i] - c[i];
      moved = std::max(moved, std::abs(step));
      ahead[i] = next[i] + (momentum - 1.0) / next_momentum * step;
    }
    c = std::move(next);
    momentum = next_momentum;
    if (moved <= 1e-13 * radius) break;
  }
  return c;
}

}  // namespace burin::curves::fractal_interpolation
