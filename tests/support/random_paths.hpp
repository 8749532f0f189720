#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <burin/path/path_sink.hpp>

namespace burin::test {

/// A path to feed to a sink.
struct DrawnPath {
  PathHead head;
  std::vector<std::vector<Vec2>> contours;
};

/// Draws all paths, cutting each contour into spans of at most `span` points.
inline Flow draw(const std::vector<DrawnPath>& paths, PathSink& sink, std::size_t span = SIZE_MAX) {
  for (const DrawnPath& path : paths) {
    if (sink.begin(path.head) == Flow::stop) return Flow::stop;
    bool first = true;
    for (const std::vector<Vec2>& contour : path.contours) {
      if (!first && sink.contour() == Flow::stop) return Flow::stop;
      first = false;
      for (std::span<const Vec2> rest = contour; !rest.empty();) {
        const auto some = rest.first(std::min(span, rest.size()));
        if (sink.points(some) == Flow::stop) return Flow::stop;
        rest = rest.subspan(some.size());
      }
    }
    if (sink.end() == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

/// The same numbers from the same seed with every library, which std's distributions do not promise.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

/// Paths of every kind on `layers` layers: dots, long and short strokes, closed ones, several contours, level and
/// upright lines, repeated points, steps from far below the last decimal to the size of the page.
inline std::vector<DrawnPath> random_paths(std::uint64_t seed, std::size_t layers, std::size_t count) {
  Dice dice(seed);
  std::vector<DrawnPath> paths;
  for (std::size_t i = 0; i < count; ++i) {
    DrawnPath path;
    path.head.layer = static_cast<LayerId>(i * layers / count);
    path.head.closed = dice.below(3) == 0;
    path.head.paint = dice.below(5) == 0 ? Paint::fill_evenodd : Paint::stroke;
    const std::size_t contours = dice.below(4) == 0 ? 3 : 1;
    for (std::size_t c = 0; c < contours; ++c) {
      std::vector<Vec2> points{{dice.between(-50, 250), dice.between(-50, 350)}};
      const std::size_t length = dice.below(3) == 0 ? 1 + dice.below(1500) : 1 + dice.below(30);
      constexpr double steps[] = {2e-4, 0.01, 1.0, 300.0};
      const double step = steps[dice.below(4)];
      while (points.size() < length) {
        Vec2 next = points.back() + Vec2{dice.between(-step, step), dice.between(-step, step)};
        if (dice.below(6) == 0) next.y = points.back().y;
        if (dice.below(6) == 0) next.x = points.back().x;
        points.push_back(next);
      }
      path.contours.push_back(std::move(points));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace burin::test
