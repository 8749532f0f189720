#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <burin/curves/line_art/cells.hpp>
#include <burin/geom/clip.hpp>

namespace burin::curves::line_art {

/// The strokes drawn so far, to ask whether an edge keeps its distance from them. Memory follows the strokes.
class Neighbours {
 public:
  /// Pre: spacing > 0.
  explicit Neighbours(double spacing) : spacing_(spacing), side_(2.0 * spacing) {}

  /// Whether the edge is at least the spacing away from every edge that was added.
  bool is_free(Vec2 a, Vec2 b) const;
  void add(Vec2 a, Vec2 b);

 private:
  double spacing_;
  double side_;  ///< of a cell
  std::vector<Segment> edges_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> edges_in_;  ///< only looked up: its order is nowhere
};

/// Whether two segments come nearer than this.
bool nearer_than(const Segment& s, const Segment& t, double limit);

}  // namespace burin::curves::line_art
