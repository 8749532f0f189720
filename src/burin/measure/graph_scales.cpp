#include <algorithm>
#include <cmath>
#include <span>

#include <burin/measure/graph_scales.hpp>

namespace burin::measure {

namespace {

constexpr std::size_t samples_per_column = 8;
constexpr int widths = 5;
constexpr std::size_t fewest_columns = 8;

/// The only contour of the drawing, if it is open and its x never turns.
std::span<const Vec2> graph_of(const Recording& drawing) {
  std::span<const Vec2> graph;
  for (const Recording::Path& path : drawing.paths()) {
    for (const Recording::Contour& contour : drawing.contours(path)) {
      if (path.head.closed || !graph.empty()) return {};
      graph = drawing.points(contour);
    }
  }
  const auto turns = [&](double sign) {
    return std::adjacent_find(graph.begin(), graph.end(), [&](Vec2 a, Vec2 b) { return sign * (b.x - a.x) < 0.0; }) !=
           graph.end();
  };
  return graph.empty() || (turns(1.0) && turns(-1.0)) ? std::span<const Vec2>{} : graph;
}

/// The sum of the oscillations in columns [k, k + 1) of u = |x - x0| / side + shift, over every `step`-th point and the
/// last one.
double oscillations(std::span<const Vec2> graph, std::size_t step, double side, double shift) {
  const auto place = [&](std::size_t k) { return Vec2{std::abs(graph[k].x - graph[0].x) / side + shift, graph[k].y}; };
  double sum = 0.0;
  Vec2 before = place(0);
  double low = before.y;
  double high = before.y;
  double border = std::floor(before.x) + 1.0;
  for (std::size_t k = 0; k + 1 < graph.size();) {
    k = std::min(k + step, graph.size() - 1);
    const Vec2 here = place(k);
    for (; border < here.x; border += 1.0) {
      const double y = before.y + (here.y - before.y) * (border - before.x) / (here.x - before.x);
      sum += std::max(high, y) - std::min(low, y);
      low = high = y;
    }
    low = std::min(low, here.y);
    high = std::max(high, here.y);
    before = here;
  }
  return sum + high - low;
}

}  // namespace

std::vector<BoxScale> graph_scales(const Recording& drawing) {
  const std::span<const Vec2> graph = graph_of(drawing);
  std::size_t columns = fewest_columns;
  if (graph.size() <= (columns << (widths - 1)) * samples_per_column || graph.front().x == graph.back().x) return {};
  while (graph.size() > (columns << widths) * samples_per_column) columns *= 2;
  const double width = std::abs(graph.back().x - graph.front().x);
  std::vector<BoxScale> scales;
  for (int k = 0; k < widths; ++k, columns *= 2) {
    const double side = width / static_cast<double>(columns);
    const std::size_t step = (graph.size() - 1) / (columns * samples_per_column);
    double sum = 0.0;
    for (const double shift : {0.0, 1.0 / 3.0, 2.0 / 3.0}) sum += oscillations(graph, step, side, shift) / 3.0;
    if (!(sum > 0.0)) return {};
    scales.push_back({side, sum / side});
  }
  return scales;
}

}  // namespace burin::measure
