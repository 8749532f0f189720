#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/measure/path_figures.hpp>

namespace burin::measure {

Flow PathFiguresSink::begin(const PathHead& head) {
  closed_ = head.closed;
  ++figures_.paths;
  has_point_ = false;
  return Flow::go;
}

Flow PathFiguresSink::points(std::span<const Vec2> points) {
  for (const Vec2 p : points) {
    ++figures_.points;
    figures_.box.add(p);
    if (has_point_) {
      edge_to(p);
      continue;
    }
    if (figures_.contours++ > 0) figures_.travel += distance(last_, p);
    has_point_ = true;
    has_edge_ = false;
    twice_area_ = 0.0;
    first_ = last_ = p;
  }
  return Flow::go;
}

Flow PathFiguresSink::contour() {
  finish_contour();
  return Flow::go;
}

Flow PathFiguresSink::end() {
  finish_contour();
  return Flow::go;
}

void PathFiguresSink::edge_to(Vec2 to) {
  const Vec2 edge = to - last_;
  const double edge_length = length(edge);
  if (edge_length > 0.0) {
    figures_.shortest_edge = figures_.edges == 0 ? edge_length : std::min(figures_.shortest_edge, edge_length);
    figures_.longest_edge = std::max(figures_.longest_edge, edge_length);
    ++figures_.edges;
    figures_.length += edge_length;
    // About the first point, so that a small shape far out loses no digits.
    twice_area_ += cross(last_ - first_, to - first_);
    if (has_edge_) {
      turn(last_edge_, edge);
    } else {
      first_edge_ = edge;
    }
    has_edge_ = true;
    last_edge_ = edge;
  }
  last_ = to;
}

void PathFiguresSink::turn(Vec2 from, Vec2 to) {
  const double degrees = math::atan2(cross(from, to), dot(from, to)) * (180.0 / math::pi);
  figures_.turn_degrees += degrees;
  figures_.bend_degrees += std::abs(degrees);
}

void PathFiguresSink::finish_contour() {
  if (closed_ && has_edge_) {
    edge_to(first_);
    turn(last_edge_, first_edge_);
    figures_.area += 0.5 * twice_area_;
  }
  has_point_ = false;
}

}  // namespace burin::measure
