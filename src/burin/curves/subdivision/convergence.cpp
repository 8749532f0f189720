#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/base/number_text.hpp>
#include <burin/curves/subdivision/convergence.hpp>
#include <burin/curves/subdivision/matrix.hpp>

namespace burin::curves::subdivision {

namespace {

constexpr int most_steps = 12;
constexpr int longest_word = 10;
/// What still counts as 0 and as 1.
constexpr double rounding_of_sums = 1e-9;
constexpr double rounding_of_norms = 1e-12;

std::vector<double> without_zeros(const std::vector<double>& mask) {
  const auto is_something = [](double weight) { return weight != 0.0; };
  const auto first = std::find_if(mask.begin(), mask.end(), is_something);
  const auto last = std::find_if(mask.rbegin(), mask.rend(), is_something).base();
  return first < last ? std::vector(first, last) : std::vector{0.0};
}

/// mask / (1 + z); nothing when a remainder is left.
std::optional<std::vector<double>> divided(const std::vector<double>& mask) {
  std::vector<double> quotient;
  double carried = 0.0;
  for (std::size_t i = 0; i + 1 < mask.size(); ++i) {
    carried = mask[i] - carried;
    quotient.push_back(carried);
  }
  if (quotient.empty() || std::abs(mask.back() - carried) > rounding_of_sums) return std::nullopt;
  return quotient;
}

/// The map from neighbouring values to those of the left (0) or right (1) half: A_pq = mask_{half - p + 2q}.
Matrix half_map(const std::vector<double>& mask, std::size_t half) {
  const std::size_t size = std::max<std::size_t>(mask.size() - 1, 1);
  Matrix map(size);
  for (std::size_t p = 0; p < size; ++p) {
    for (std::size_t q = 0; q < size; ++q) {
      const std::size_t index = half + 2 * q;
      if (index >= p && index - p < mask.size()) map.at(p, q) = mask[index - p];
    }
  }
  if (mask.size() == 1) map.at(0, 0) = mask[0];
  return map;
}

double norm_of(const Matrix& matrix) {
  double norm = 0.0;
  for (std::size_t row = 0; row < matrix.size; ++row) {
    double sum = 0.0;
    for (std::size_t column = 0; column < matrix.size; ++column) sum += std::abs(matrix.at(row, column));
    norm = std::max(norm, sum);
  }
  return norm;
}

/// log2 of the spectral radius by Gelfand's formula: the norm of the power 2^n, taken to 1/2^n; -infinity for 0.
double log2_spectral_radius(Matrix matrix) {
  constexpr int squarings = 44;
  double logarithm = 0.0;
  double share = 1.0;
  for (int n = 0; n <= squarings; ++n) {
    const double norm = norm_of(matrix);
    if (norm == 0.0) return -std::numeric_limits<double>::infinity();
    logarithm += share * math::log2(norm);
    for (double& entry : matrix.entries) entry /= norm;
    matrix = product(matrix, matrix);
    share *= 0.5;
  }
  return logarithm;
}

/// Whether a word of bits is smaller than all its rotations: of words with the same radius one, and no repetition.
bool is_lyndon(unsigned word, int length) {
  const unsigned all = (1U << length) - 1U;
  for (int by = 1; by < length; ++by) {
    const unsigned rotated = ((word << by) | (word >> (length - by))) & all;
    if (rotated <= word) return false;
  }
  return true;
}

}  // namespace

std::vector<double> norms_of_powers(const std::vector<double>& mask, int steps) {
  std::vector<double> norms;
  std::vector<double> power{1.0};
  std::size_t spacing = 1;
  for (int step = 0; step < steps; ++step) {
    std::vector<double> next(2 * (power.size() - 1) + mask.size(), 0.0);
    for (std::size_t i = 0; i < power.size(); ++i) {
      for (std::size_t k = 0; k < mask.size(); ++k) next[2 * i + k] += mask[k] * power[i];
    }
    power = std::move(next);
    spacing *= 2;
    std::vector<double> sums(spacing, 0.0);
    for (std::size_t i = 0; i < power.size(); ++i) sums[i % spacing] += std::abs(power[i]);
    norms.push_back(*std::max_element(sums.begin(), sums.end()));
  }
  return norms;
}

double spectral_radius_bound(const std::vector<double>& mask, int longest) {
  const Matrix halves[] = {half_map(mask, 0), half_map(mask, 1)};
  double best = -std::numeric_limits<double>::infinity();
  for (int length = 1; length <= longest; ++length) {
    for (unsigned word = 0; word < (1U << length); ++word) {
      if (!is_lyndon(word, length)) continue;
      Matrix map = halves[word & 1U];
      for (int bit = 1; bit < length; ++bit) map = product(halves[(word >> bit) & 1U], map);
      best = std::max(best, log2_spectral_radius(map) / length);
    }
  }
  return math::pow(2.0, best);
}

Convergence classify(const std::vector<double>& mask) {
  Convergence result;
  std::vector<double> quotient = without_zeros(mask);
  while (const std::optional<std::vector<double>> next = divided(quotient)) {
    quotient = *next;
    ++result.sum_rules;
    const int smoothness = result.sum_rules - 1;
    std::vector<double> differences = quotient;
    for (double& weight : differences) weight *= static_cast<double>(1 << smoothness);
    const std::vector<double> norms = norms_of_powers(differences, most_steps);
    const auto proof =
        std::find_if(norms.begin(), norms.end(), [](double norm) { return norm < 1.0 - rounding_of_norms; });
    if (proof != norms.end()) {
      result.proven = smoothness;
      result.steps = static_cast<int>(proof - norms.begin()) + 1;
    }
    if (!result.excluded && spectral_radius_bound(differences, longest_word) >= 1.0 - rounding_of_norms) {
      result.excluded = smoothness;
    }
  }
  if (!result.excluded && quotient.size() > 1) result.excluded = result.sum_rules;
  result.exponent_low = -math::log2(norms_of_powers(quotient, most_steps).back()) / most_steps;
  result.exponent_high = -math::log2(spectral_radius_bound(quotient, longest_word));
  return result;
}

std::string convergence_text(const Convergence& convergence) {
  std::string text;
  if (convergence.proven >= 0) {
    text += fmt::format("proven: C{} by the norm of power {} of the difference scheme\n", convergence.proven,
                        convergence.steps);
  } else {
    text += "proven: nothing\n";
  }
  if (convergence.excluded == 0) {
    text += "excluded: C0; the scheme diverges\n";
  } else if (convergence.excluded) {
    text += fmt::format("excluded: C{} by a spectral radius\n", *convergence.excluded);
  } else {
    text += "excluded: nothing\n";
  }
  const std::string low = fixed_text(convergence.exponent_low, 4);
  const std::string high = fixed_text(convergence.exponent_high, 4);
  if (convergence.exponent_high <= 0.0) return text;
  return text + (low == high ? fmt::format("H\u00f6lder exponent: {}\n", low)
                             : fmt::format("H\u00f6lder exponent: {} to {}\n", low, high));
}

}  // namespace burin::curves::subdivision
