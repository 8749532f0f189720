#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>
#include <burin/curves/fractal_interpolation/interpolant.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

DataTrouble scaling_trouble(const Scaling& scaling, std::size_t interval) {
  if (!all_finite(scaling.c)) return {"scaling", fmt::format("the scaling of interval {} is not finite", interval + 1)};
  const double bound = sup_bound(scaling);
  if (bound < 1.0) return {};
  return {"scaling", fmt::format("the scaling of interval {} may reach {} in size; its bound (the sum of its "
                                 "coefficients' sizes) must stay below 1, else nothing converges",
                                 interval + 1, shortest_text(bound))};
}

DataTrouble shape_trouble(std::string_view name, double value, std::size_t interval) {
  if (!std::isfinite(value)) return {name, fmt::format("'{}' of interval {} is not finite", name, interval + 1)};
  if (value >= 0.0) return {};
  return {name,
          fmt::format("'{}' of interval {} is {}; it must be 0 or more", name, interval + 1, shortest_text(value))};
}

DataTrouble node_trouble(const InterpolationData& data) {
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    if (!std::isfinite(data.x[i]) || !std::isfinite(data.values[i])) {
      return {"points", fmt::format("point {} is not finite", i + 1)};
    }
    if (!std::isfinite(data.derivatives[i])) {
      return {"derivatives", fmt::format("the derivative at point {} is not finite", i + 1)};
    }
    if (i > 0 && !(data.x[i] > data.x[i - 1])) {
      return {"points", fmt::format("x must increase from point to point, but {} follows {}", shortest_text(data.x[i]),
                                    shortest_text(data.x[i - 1]))};
    }
  }
  if (std::isfinite(data.x.back() - data.x.front())) return {};
  return {"points", "the points are too far apart for numbers"};
}

double theta_at(const Interpolant& f, double x) {
  return std::clamp((x - f.begin) / f.length, 0.0, 1.0);
}

/// theta of the point of piece i whose theta of the whole is `theta`. The last node is met exactly, as the others are.
double local_theta(const Piece& piece, double theta) {
  if (theta >= 1.0) return 1.0;
  return std::clamp((theta - piece.start) / piece.width, 0.0, 1.0);
}

Vec2 model_point(const Interpolant& f, GraphPoint p) {
  return {f.begin + f.length * p.theta, p.y};
}

}  // namespace

DataTrouble trouble_with(const InterpolationData& data) {
  const std::size_t n = data.shapes.size();
  BURIN_EXPECT(n > 0 && data.x.size() == n + 1 && data.values.size() == n + 1 && data.derivatives.size() == n + 1 &&
               data.scalings.size() == n);
  DataTrouble trouble = node_trouble(data);
  for (std::size_t i = 0; i < n && trouble.of.empty(); ++i) {
    trouble = shape_trouble("alpha", data.shapes[i].alpha, i);
    if (trouble.of.empty()) trouble = shape_trouble("beta", data.shapes[i].beta, i);
    if (trouble.of.empty()) trouble = scaling_trouble(data.scalings[i], i);
  }
  return trouble;
}

Interpolant make_interpolant(const InterpolationData& data) {
  BURIN_EXPECT(trouble_with(data).of.empty());
  const std::size_t n = data.shapes.size();
  Interpolant f;
  f.begin = data.x.front();
  f.length = data.x.back() - data.x.front();
  const auto ends = [&](std::size_t i, std::size_t j) {
    const double h = data.x[j] - data.x[i];
    return EndData{data.values[i], data.values[j], h * data.derivatives[i], h * data.derivatives[j]};
  };
  f.whole = ends(0, n);
  for (std::size_t i = 0; i < n; ++i) {
    f.pieces.push_back({(data.x[i] - f.begin) / f.length, (data.x[i + 1] - data.x[i]) / f.length, ends(i, i + 1),
                        data.shapes[i], data.scalings[i]});
  }
  f.gap = gap_bound(f);
  return f;
}

GraphPoint node_point(const Interpolant& f, std::size_t k) {
  if (k == f.pieces.size()) return {1.0, f.pieces.back().ends.right};
  return {f.pieces[k].start, f.pieces[k].ends.left};
}

std::size_t piece_at(const Interpolant& f, double theta) {
  const auto after = std::upper_bound(f.pieces.begin(), f.pieces.end(), theta,
                                      [](double t, const Piece& piece) { return t < piece.start; });
  return after == f.pieces.begin() ? 0 : static_cast<std::size_t>(after - f.pieces.begin()) - 1;
}

double classical_value(const Interpolant& f, double x) {
  const double theta = theta_at(f, x);
  const Piece& piece = f.pieces[piece_at(f, theta)];
  return own_cubic(piece, local_theta(piece, theta));
}

double value_at(const Interpolant& f, double x, double tolerance) {
  double theta = theta_at(f, x);
  const Piece* piece = &f.pieces[piece_at(f, theta)];
  theta = local_theta(*piece, theta);
  double sum = own_cubic(*piece, theta);
  double factor = 1.0;
  // The remainder is at most |factor| f.gap; a tolerance of 0 ends where the factor is lost in rounding.
  while (std::abs(factor) * f.gap > tolerance && std::abs(factor) > 1e-300) {
    factor *= scaling_at(piece->scaling, theta);
    const double whole = whole_cubic(f, *piece, theta);
    piece = &f.pieces[piece_at(f, theta)];
    theta = local_theta(*piece, theta);
    sum += factor * (own_cubic(*piece, theta) - whole);
  }
  return sum;
}

GraphPoint point_at(const Interpolant& f, std::span<const std::uint32_t> digits, std::size_t node) {
  GraphPoint p = node_point(f, node);
  for (std::size_t k = digits.size(); k > 0; --k) p = mapped(f, f.pieces[digits[k - 1]], p);
  return p;
}

std::vector<Vec2> level_set(const Interpolant& f, int level) {
  std::vector<GraphPoint> points;
  for (std::size_t k = 0; k <= f.pieces.size(); ++k) points.push_back(node_point(f, k));
  for (int m = 0; m < level; ++m) {
    std::vector<GraphPoint> finer;
    finer.reserve((points.size() - 1) * f.pieces.size() + 1);
    for (const Piece& piece : f.pieces) {
      for (std::size_t k = 0; k + 1 < points.size(); ++k) finer.push_back(mapped(f, piece, points[k]));
    }
    finer.push_back(mapped(f, f.pieces.back(), points.back()));
    points = std::move(finer);
  }
  std::vector<Vec2> graph;
  graph.reserve(points.size());
  for (const GraphPoint& p : points) graph.push_back(model_point(f, p));
  return graph;
}

std::vector<Vec2> chaos_points(const Interpolant& f, std::size_t count, std::uint64_t seed) {
  constexpr std::uint64_t splitmix_step = 0x9E3779B97F4A7C15U;
  std::vector<Vec2> points;
  points.reserve(count);
  GraphPoint p = node_point(f, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const double u = unit_interval(mix(seed + k * splitmix_step));
    std::size_t i = 0;
    for (double below = f.pieces[0].width; i + 1 < f.pieces.size() && !(u < below); below += f.pieces[i].width) ++i;
    p = mapped(f, f.pieces[i], p);
    points.push_back(model_point(f, p));
  }
  return points;
}

}  // namespace burin::curves::fractal_interpolation
