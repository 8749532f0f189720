#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/dimension.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

constexpr int sample_count = 4000;

double theta_of_sample(int k) {
  return static_cast<double>(k) / sample_count;
}

double size_at(const Piece& piece, double theta) {
  return std::abs(scaling_at(piece.scaling, theta));
}

/// 1 + log_n of what the oscillation grows by from level to level.
double dimension_of_growth(const Interpolant& f, double growth) {
  if (growth <= 1.0) return 1.0;
  return 1.0 + math::log(growth) / math::log(static_cast<double>(f.pieces.size()));
}

/// Sum of min |s_i|.
double least_sum(const Interpolant& f) {
  double sum = 0.0;
  for (const Piece& piece : f.pieces) {
    double least = size_at(piece, 0.0);
    for (int k = 1; k <= sample_count; ++k) least = std::min(least, size_at(piece, theta_of_sample(k)));
    sum += least;
  }
  return sum;
}

}  // namespace

bool has_equal_intervals(const Interpolant& f) {
  const double width = 1.0 / static_cast<double>(f.pieces.size());
  return std::all_of(f.pieces.begin(), f.pieces.end(),
                     [&](const Piece& piece) { return std::abs(piece.width - width) <= 1e-9 * width; });
}

double constant_dimension(const Interpolant& f) {
  const auto excess = [&](double dimension) {
    double sum = 0.0;
    for (const Piece& piece : f.pieces) sum += size_at(piece, 0.5) * math::pow(piece.width, dimension - 1.0);
    return sum - 1.0;
  };
  if (excess(1.0) <= 0.0) return 1.0;
  double low = 1.0;
  double high = 2.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

DimensionBounds separate_bounds(const Interpolant& f) {
  BURIN_EXPECT(has_equal_intervals(f));
  double largest = 0.0;
  for (const Piece& piece : f.pieces) {
    double most = 0.0;
    for (int k = 0; k <= sample_count; ++k) most = std::max(most, size_at(piece, theta_of_sample(k)));
    largest += most;
  }
  return {dimension_of_growth(f, least_sum(f)), dimension_of_growth(f, largest)};
}

DimensionBounds joint_bounds(const Interpolant& f) {
  BURIN_EXPECT(has_equal_intervals(f));
  double least = static_cast<double>(f.pieces.size());
  double most = 0.0;
  for (int k = 0; k <= sample_count; ++k) {
    double sum = 0.0;
    for (const Piece& piece : f.pieces) sum += size_at(piece, theta_of_sample(k));
    least = std::min(least, sum);
    most = std::max(most, sum);
  }
  return {dimension_of_growth(f, least), dimension_of_growth(f, most)};
}

double spectral_dimension(const Interpolant& f) {
  BURIN_EXPECT(has_equal_intervals(f));
  constexpr std::size_t cells = 2048;
  constexpr int rounds = 100;
  std::vector<double> g(cells, 1.0);
  std::vector<double> image(cells);
  const auto value = [&](double theta) {
    const double at = std::clamp(theta * cells - 0.5, 0.0, cells - 1.0);
    const auto k = std::min(static_cast<std::size_t>(at), cells - 2);
    return g[k] + (at - static_cast<double>(k)) * (g[k + 1] - g[k]);
  };
  double radius = 0.0;
  for (int round = 0; round < rounds; ++round) {
    radius = 0.0;
    for (std::size_t k = 0; k < cells; ++k) {
      const double theta = (static_cast<double>(k) + 0.5) / cells;
      image[k] = 0.0;
      for (const Piece& piece : f.pieces) {
        image[k] += size_at(piece, theta) * value(piece.start + piece.width * theta);
      }
      radius = std::max(radius, image[k]);
    }
    if (radius == 0.0) break;
    for (std::size_t k = 0; k < cells; ++k) g[k] = image[k] / radius;
  }
  return dimension_of_growth(f, radius);
}

std::vector<double> oscillation_sums(const Interpolant& f, int levels, int depth) {
  BURIN_EXPECT(has_equal_intervals(f) && depth >= 1);
  std::size_t cell = 1;
  for (int k = 0; k < depth; ++k) cell *= f.pieces.size();
  std::vector<double> sums;
  for (int level = 0; level <= levels; ++level) {
    const std::vector<Vec2> points = level_set(f, level + depth - 1);
    double sum = 0.0;
    for (std::size_t first = 0; first + 1 < points.size(); first += cell) {
      const auto [low, high] = std::minmax_element(points.begin() + static_cast<std::ptrdiff_t>(first),
                                                   points.begin() + static_cast<std::ptrdiff_t>(first + cell + 1),
                                                   [](Vec2 a, Vec2 b) { return a.y < b.y; });
      sum += high->y - low->y;
    }
    sums.push_back(sum);
  }
  return sums;
}

std::optional<int> growth_certificate(const Interpolant& f, int levels) {
  const double growth = least_sum(f);
  if (growth <= 1.0) return std::nullopt;
  double drift = 0.0;
  for (const Stretch& stretch : stretches(f)) drift += stretch.drift;
  // O_(m+1) >= growth O_m - drift, so that one O_m above this makes them grow for ever.
  const double threshold = drift / (growth - 1.0);
  const std::vector<double> sums = oscillation_sums(f, levels, 2);
  const auto proof = std::find_if(sums.begin(), sums.end(), [&](double sum) { return sum > threshold; });
  if (proof == sums.end()) return std::nullopt;
  return static_cast<int>(proof - sums.begin());
}

}  // namespace burin::curves::fractal_interpolation
