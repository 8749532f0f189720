#include <algorithm>
#include <bit>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/measure/box_dimension.hpp>
#include <burin/measure/graph_scales.hpp>

namespace burin::measure {

namespace {

/// Calls visit(from, to) for every edge, the closing ones of closed contours too.
template <class Visit>
void for_edges(const Recording& drawing, const Visit& visit) {
  for (const Recording::Path& path : drawing.paths()) {
    for (const Recording::Contour& contour : drawing.contours(path)) {
      const std::span<const Vec2> points = drawing.points(contour);
      for (std::size_t i = 1; i < points.size(); ++i) visit(points[i - 1], points[i]);
      if (path.head.closed && points.size() > 1) visit(points.back(), points.front());
    }
  }
}

/// A bit for every cell of a grid.
class Cells {
 public:
  Cells(double low_x, double low_y, double high_x, double high_y)
      : low_x_(low_x), low_y_(low_y), columns_(static_cast<std::size_t>(high_x - low_x) + 1) {
    const std::size_t rows = static_cast<std::size_t>(high_y - low_y) + 1;
    bits_.assign((columns_ * rows + 63) / 64, 0);
  }

  void mark(Vec2 in_cells) {
    // A middle may be rounded onto the far border of the last cell.
    const auto column =
        std::min(static_cast<std::size_t>(std::max(std::floor(in_cells.x) - low_x_, 0.0)), columns_ - 1);
    const auto row = static_cast<std::size_t>(std::max(std::floor(in_cells.y) - low_y_, 0.0));
    const std::size_t cell = std::min(row * columns_ + column, bits_.size() * 64 - 1);
    bits_[cell / 64] |= std::uint64_t{1} << (cell % 64);
  }

  std::uint64_t marked() const {
    std::uint64_t count = 0;
    for (const std::uint64_t word : bits_) count += static_cast<std::uint64_t>(std::popcount(word));
    return count;
  }

 private:
  double low_x_;
  double low_y_;
  std::size_t columns_;
  std::vector<std::uint64_t> bits_;
};

/// Adds where the edge, from `from` to `to` in one coordinate, crosses whole numbers, as parameters along it.
void add_crossings(double from, double to, std::vector<double>& crossings) {
  if (from == to) return;
  const auto [low, high] = std::minmax(from, to);
  for (double line = std::ceil(low); line <= high; line += 1.0) crossings.push_back((line - from) / (to - from));
}

double median_edge(const Recording& drawing) {
  std::vector<double> lengths;
  for_edges(drawing, [&](Vec2 from, Vec2 to) {
    if (from != to) lengths.push_back(distance(from, to));
  });
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  if (lengths.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(lengths.begin(), middle));
}

/// Ordinary least squares of log(count) on log(1 / side).
void fit_line(BoxDimension& fit) {
  const auto n = static_cast<double>(fit.scales.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const BoxScale& scale : fit.scales) {
    mean_x -= math::log(scale.side) / n;
    mean_y += math::log(scale.count) / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const BoxScale& scale : fit.scales) {
    const double x = -math::log(scale.side) - mean_x;
    const double y = math::log(scale.count) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  fit.dimension = xy / xx;
  fit.intercept = mean_y - fit.dimension * mean_x;
  const double unexplained = std::max(0.0, yy - fit.dimension * xy);
  fit.r_squared = yy > 0.0 ? 1.0 - unexplained / yy : 1.0;
  fit.standard_error = n > 2.0 ? std::sqrt(unexplained / ((n - 2.0) * xx)) : 0.0;
}

}  // namespace

std::uint64_t box_count(const Recording& drawing, double side, Vec2 origin) {
  BURIN_EXPECT(side > 0.0);
  const Box2 box = drawing.bounds();
  if (box.empty()) return 0;
  const auto in_cells = [&](Vec2 p) { return Vec2{(p.x - origin.x) / side, (p.y - origin.y) / side}; };
  const Vec2 low = in_cells(box.low);
  const Vec2 high = in_cells(box.high);
  BURIN_EXPECT((high.x - low.x + 2.0) * (high.y - low.y + 2.0) <= 0x1p30);
  Cells cells(std::floor(low.x), std::floor(low.y), std::floor(high.x), std::floor(high.y));
  std::vector<double> crossings;
  for_edges(drawing, [&](Vec2 edge_from, Vec2 edge_to) {
    const Vec2 from = in_cells(edge_from);
    const Vec2 to = in_cells(edge_to);
    if (from == to) return;
    if (std::floor(from.x) == std::floor(to.x) && std::floor(from.y) == std::floor(to.y)) return cells.mark(from);
    crossings.assign({0.0, 1.0});
    add_crossings(from.x, to.x, crossings);
    add_crossings(from.y, to.y, crossings);
    for (double& t : crossings) t = std::clamp(t, 0.0, 1.0);
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 1; i < crossings.size(); ++i) {
      if (crossings[i] > crossings[i - 1]) cells.mark(lerp(from, to, 0.5 * (crossings[i - 1] + crossings[i])));
    }
  });
  return cells.marked();
}

namespace {

/// The scales of a drawing by boxes, and whether they are smaller than its edges.
void count_on_grids(const Recording& drawing, double median_edge, BoxDimension& fit) {
  constexpr double largest = 3.0;  // boxes of 2^-3 of the longer side
  constexpr double smallest = 8.0;
  constexpr double step = 0.5;
  constexpr int offsets = 3;
  const Vec2 low = drawing.bounds().low;
  const double finest_for_edges = std::floor(math::log2(fit.extent / (2.0 * median_edge)) / step) * step;
  fit.is_of_few_edges = finest_for_edges < largest + 2.0 * step;
  const double finest = fit.is_of_few_edges ? smallest : std::min(smallest, finest_for_edges);
  for (double k = largest; k <= finest; k += step) {
    const double side = fit.extent / math::pow(2.0, k);
    double sum = 0.0;
    for (int i = 0; i < offsets; ++i) {
      for (int j = 0; j < offsets; ++j) {
        const Vec2 origin{low.x - side * i / offsets, low.y - side * j / offsets};
        sum += static_cast<double>(box_count(drawing, side, origin));
      }
    }
    fit.scales.push_back({side, sum / (offsets * offsets)});
  }
}

}  // namespace

Result<BoxDimension> box_dimension(const Recording& drawing) {
  const Box2 box = drawing.bounds();
  const double longer = box.empty() ? 0.0 : std::max(box.width(), box.height());
  const double edge = median_edge(drawing);
  if (!(longer > 0.0) || !(edge > 0.0)) {
    return Problem{{}, "the box dimension needs a drawing of some extent"};
  }
  BoxDimension fit;
  fit.scales = graph_scales(drawing);
  fit.is_of_graph = !fit.scales.empty();
  fit.extent = fit.is_of_graph ? box.width() : longer;
  if (!fit.is_of_graph) count_on_grids(drawing, edge, fit);
  fit_line(fit);
  return fit;
}

}  // namespace burin::measure
