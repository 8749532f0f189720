#include <utility>

#include <burin/curves/smoothing.hpp>

namespace burin::curves {

namespace {

void cut_corners(const std::vector<Vec2>& from, std::vector<Vec2>& to) {
  to.push_back(from.front());
  for (std::size_t i = 0; i + 1 < from.size(); ++i) {
    to.push_back(0.75 * from[i] + 0.25 * from[i + 1]);
    to.push_back(0.25 * from[i] + 0.75 * from[i + 1]);
  }
  to.push_back(from.back());
}

void interpolate_four_points(const std::vector<Vec2>& from, std::vector<Vec2>& to) {
  const std::size_t last = from.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const Vec2 before = i == 0 ? 2.0 * from[0] - from[1] : from[i - 1];
    const Vec2 after = i + 1 == last ? 2.0 * from[last] - from[last - 1] : from[i + 2];
    to.push_back(from[i]);
    to.push_back(0.5625 * (from[i] + from[i + 1]) - 0.0625 * (before + after));
  }
  to.push_back(from.back());
}

}  // namespace

void smooth(std::vector<Vec2>& points, Smoothing smoothing, int levels, std::vector<Vec2>& spare) {
  if (smoothing == Smoothing::none || points.size() < 3) return;
  for (int level = 0; level < levels; ++level) {
    spare.clear();
    smoothing == Smoothing::corners ? cut_corners(points, spare) : interpolate_four_points(points, spare);
    std::swap(points, spare);
  }
}

double smoothed_count(std::size_t points, Smoothing smoothing, int levels) {
  auto count = static_cast<double>(points);
  if (smoothing == Smoothing::none || points < 3) return count;
  for (int level = 0; level < levels; ++level) count = 2.0 * count - (smoothing == Smoothing::corners ? 0.0 : 1.0);
  return count;
}

}  // namespace burin::curves
