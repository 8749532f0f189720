#include <algorithm>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/contour.hpp>

namespace burin::curves::fractal_interpolation {

std::vector<double> chord_parameters(std::span<const Vec2> points) {
  BURIN_EXPECT(points.size() >= 2);
  std::vector<double> t{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) t.push_back(t.back() + distance(points[i - 1], points[i]));
  const double total = t.back();
  for (double& each : t) each /= total;
  return t;
}

double chord_length(std::span<const Vec2> points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

std::vector<std::size_t> spread_knots(std::span<const double> t, int intervals) {
  std::vector<std::size_t> knots;
  for (int k = 0; k <= intervals; ++k) {
    const double wanted = t.front() + (t.back() - t.front()) * k / intervals;
    const auto above = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), wanted) - t.begin());
    std::size_t nearest = std::min(above, t.size() - 1);
    if (nearest > 0 && std::abs(t[nearest - 1] - wanted) <= std::abs(t[nearest] - wanted)) --nearest;
    if (knots.empty() || nearest > knots.back()) knots.push_back(nearest);
  }
  return knots;
}

void project_from_degrees(std::vector<Vec2>& longitudes_latitudes) {
  Vec2 sum;
  for (const Vec2 p : longitudes_latitudes) sum = sum + p;
  const Vec2 mean = (1.0 / static_cast<double>(longitudes_latitudes.size())) * sum;
  const double shrink = math::cos_degrees(mean.y);
  for (Vec2& p : longitudes_latitudes) p.x = (p.x - mean.x) * shrink;
}

}  // namespace burin::curves::fractal_interpolation
