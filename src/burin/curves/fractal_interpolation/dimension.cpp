#include <utility>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/dimension.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

constexpr int sample_count = 4000;
constexpr double most_points = 1 << 18;

/// The last level whose oscillations, from n^depth points of a cell, take at most `most_points`; -1: not even level 0.
int affordable_level(const Interpolant& f, int depth) {
  const auto n = static_cast<double>(f.pieces.size());
  int level = -depth - 1;
  for (double points = 1.0; points <= most_points; points *= n) ++level;
  return std::max(level, -1);
}

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

/// The root of a decreasing function of the dimension from 1 to 2; an end when it has none there.
template <class Excess>
double root_dimension(Excess excess) {
  double low = 1.0;
  double high = 2.0;
  if (excess(low) <= 0.0) return low;
  if (excess(high) >= 0.0) return high;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// D of sum size_i a_i^(D-1) = 1.
template <class SizeOf>
double dimension_of_sizes(const Interpolant& f, SizeOf size_of) {
  return root_dimension([&](double dimension) {
    double sum = 0.0;
    for (const Piece& piece : f.pieces) sum += size_of(piece) * math::pow(piece.width, dimension - 1.0);
    return sum - 1.0;
  });
}

bool has_constant_scaling(const Interpolant& f) {
  return std::all_of(f.pieces.begin(), f.pieces.end(),
                     [](const Piece& piece) { return lipschitz_bound(piece.scaling) == 0.0; });
}

}  // namespace

bool has_equal_intervals(const Interpolant& f) {
  const double width = 1.0 / static_cast<double>(f.pieces.size());
  return std::all_of(f.pieces.begin(), f.pieces.end(),
                     [&](const Piece& piece) { return std::abs(piece.width - width) <= 1e-9 * width; });
}

double constant_dimension(const Interpolant& f) {
  return dimension_of_sizes(f, [](const Piece& piece) { return size_at(piece, 0.5); });
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
    const double before = std::exchange(radius, 0.0);
    for (std::size_t k = 0; k < cells; ++k) {
      const double theta = (static_cast<double>(k) + 0.5) / cells;
      image[k] = 0.0;
      for (const Piece& piece : f.pieces) {
        image[k] += size_at(piece, theta) * value(piece.start + piece.width * theta);
      }
      radius = std::max(radius, image[k]);
    }
    if (radius == 0.0 || std::abs(radius - before) <= 1e-13 * radius) break;
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
  double growth = least_sum(f);
  // Between two samples |s_i| may be smaller still.
  for (const Piece& piece : f.pieces) growth -= 0.5 * lipschitz_bound(piece.scaling) / sample_count;
  if (growth <= 1.0) return std::nullopt;
  double drift = 0.0;
  for (const Stretch& stretch : stretches(f)) drift += stretch.drift;
  // O_(m+1) >= growth O_m - drift, so that one O_m above this makes them grow for ever.
  const double threshold = drift / (growth - 1.0);
  constexpr int depth = 2;
  const std::vector<double> sums = oscillation_sums(f, std::min(levels, affordable_level(f, depth)), depth);
  const auto proof = std::find_if(sums.begin(), sums.end(), [&](double sum) { return sum > threshold; });
  if (proof == sums.end()) return std::nullopt;
  return static_cast<int>(proof - sums.begin());
}

std::optional<double> oscillation_dimension(const Interpolant& f) {
  constexpr int depth = 3;
  const std::vector<double> sums = oscillation_sums(f, affordable_level(f, depth), depth);
  if (sums.size() < 2 || sums[sums.size() - 2] <= 0.0) return std::nullopt;
  return 1.0 + math::log(sums.back() / sums[sums.size() - 2]) / math::log(static_cast<double>(f.pieces.size()));
}

FractalDimension graph_dimension(const Interpolant& f) {
  FractalDimension dimension;
  if (!has_equal_intervals(f)) {
    dimension.bounds.upper = dimension_of_sizes(f, [](const Piece& piece) { return sup_bound(piece.scaling); });
    if (has_constant_scaling(f)) dimension.spectral = constant_dimension(f);
    return dimension;
  }
  dimension.bounds.upper = joint_bounds(f).upper;
  dimension.spectral = spectral_dimension(f);
  dimension.oscillation = oscillation_dimension(f);
  dimension.certificate = growth_certificate(f);
  if (dimension.certificate) dimension.bounds.lower = separate_bounds(f).lower;
  return dimension;
}

double contour_dimension_bound(const Interpolant& x, const Interpolant& y) {
  BURIN_EXPECT(x.pieces.size() == y.pieces.size());
  return root_dimension([&](double dimension) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.pieces.size(); ++i) {
      const double size = std::max({sup_bound(x.pieces[i].scaling), sup_bound(y.pieces[i].scaling), x.pieces[i].width});
      sum += math::pow(size, dimension);
    }
    return sum - 1.0;
  });
}

}  // namespace burin::curves::fractal_interpolation
