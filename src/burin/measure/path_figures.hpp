#pragma once

#include <cstdint>

#include <burin/geom/box2.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::measure {

/// What can be said of paths while they pass, in the units they come in.
struct PathFigures {
  std::uint64_t paths = 0;
  std::uint64_t contours = 0;
  std::uint64_t points = 0;
  std::uint64_t edges = 0;  ///< those of length 0 left out
  double length = 0.0;      ///< of all edges, the closing ones of closed contours too
  double shortest_edge = 0.0;
  double longest_edge = 0.0;
  double travel = 0.0;        ///< from the end of each contour to the beginning of the next, as a lifted pen goes
  double area = 0.0;          ///< of closed contours: the shoelace sum, counter-clockwise (y up) positive
  double turn_degrees = 0.0;  ///< sum of the turns at vertices, to the left positive (y up); a reversal counts 180
  double bend_degrees = 0.0;  ///< sum of their sizes
  Box2 box{};
};

/// Takes a drawing and keeps its figures. O(1) memory.
class PathFiguresSink final : public PathSink {
 public:
  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;

  const PathFigures& figures() const { return figures_; }

 private:
  void edge_to(Vec2 to);
  void turn(Vec2 from, Vec2 to);
  void finish_contour();

  PathFigures figures_;
  bool closed_ = false;
  bool has_point_ = false;
  bool has_edge_ = false;
  Vec2 first_{};
  Vec2 last_{};
  Vec2 first_edge_{};
  Vec2 last_edge_{};
  double twice_area_ = 0.0;
};

}  // namespace burin::measure
