#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <burin/path/recording.hpp>

/// Polygons asked in the plainest way.
namespace burin::test {

/// How often the contours wind around a point.
inline int winding(const std::vector<std::vector<Vec2>>& contours, Vec2 at) {
  int turns = 0;
  for (const std::vector<Vec2>& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 p = contour[i];
      const Vec2 q = contour[(i + 1) % contour.size()];
      if ((p.y <= at.y) == (q.y <= at.y)) continue;
      const double x = p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x);
      if (x > at.x) turns += q.y > p.y ? 1 : -1;
    }
  }
  return turns;
}

/// The shoelace sum: counter-clockwise contours (y up) count as positive.
inline double signed_area(const std::vector<std::vector<Vec2>>& contours) {
  double twice = 0.0;
  for (const std::vector<Vec2>& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) twice += cross(contour[i], contour[(i + 1) % contour.size()]);
  }
  return 0.5 * twice;
}

/// Every contour of every path, in order.
inline std::vector<std::vector<Vec2>> contours_of(const Recording& recording) {
  std::vector<std::vector<Vec2>> all;
  for (const Recording::Path& path : recording.paths()) {
    for (const Recording::Contour& contour : recording.contours(path)) {
      const auto points = recording.points(contour);
      all.emplace_back(points.begin(), points.end());
    }
  }
  return all;
}

/// The length of all strokes, the closing edges of closed ones included.
inline double stroke_length(const Recording& recording) {
  double sum = 0.0;
  for (const Recording::Path& path : recording.paths()) {
    for (const Recording::Contour& contour : recording.contours(path)) {
      const auto points = recording.points(contour);
      for (std::size_t i = path.head.closed ? 0 : 1; i < points.size(); ++i) {
        sum += distance(points[i == 0 ? points.size() - 1 : i - 1], points[i]);
      }
    }
  }
  return sum;
}

}  // namespace burin::test
