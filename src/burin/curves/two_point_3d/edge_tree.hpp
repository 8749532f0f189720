#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/curves/two_point/keyed_rule.hpp>
#include <burin/curves/two_point_3d/reach.hpp>
#include <burin/curves/two_point_3d/two_point_3d.hpp>

namespace burin::curves::two_point_3d {

/// What the refinement of an edge depends on besides the points: which edge of its level it is, and the flags that it
/// got from its parent.
struct EdgeState {
  std::uint64_t ordinal = 0;  ///< from 0, modulo 2^64
  bool flip = false;          ///< mirrored
  bool reverse = false;       ///< built from its far end
};

/// An edge from window[2] to window[3] with two points to either side: they give the normals of the edge and of both
/// neighbours, and the neighbours' markers are the points beside those of the edge in the next level.
struct EdgePiece {
  std::array<Vec3, 6> window;
  std::size_t first = 0;  ///< what of the window there is: an open polyline ends
  std::size_t last = 5;
  std::array<EdgeState, 3> edges;  ///< before it, itself, after it
  int level = 0;
};

/// The curve as a tree of edges: see refinement/curve.hpp.
class EdgeTree {
 public:
  using Point = Vec3;
  using Node = EdgePiece;

  EdgeTree(const TwoPoint3dParams& params, std::uint64_t seed);

  int levels() const { return levels_; }
  std::size_t part_count() const { return polylines_.size(); }
  bool is_closed(std::size_t part) const { return polylines_[part].closed; }
  const std::vector<Vec3>& base(std::size_t part) const { return polylines_[part].points; }
  std::vector<Vec3> before(std::size_t) const { return {}; }
  std::vector<Vec3> after(std::size_t part) const;
  std::size_t root_count(std::size_t part) const { return polylines_[part].edge_count(); }
  EdgePiece root(std::size_t part, std::size_t index) const;
  double points_asked() const;

  bool is_last(const EdgePiece& piece) const { return piece.level == levels_; }
  bool is_silent(const EdgePiece&) const { return false; }
  Cover<Vec3> cover(const EdgePiece& piece) const;
  Vec3 start(const EdgePiece& piece) const { return piece.window[2]; }
  Vec3 first_guess(const EdgePiece& piece) const { return piece.window[2]; }
  void push_children(const EdgePiece& piece, std::vector<EdgePiece>& stack) const;

 private:
  Vec3 marker(const EdgePiece& piece, std::size_t edge, std::size_t marker) const;
  EdgeState child_state(const EdgeState& parent, std::size_t child, std::size_t child_count) const;

  two_point::KeyedRule rule_;
  SpaceReach reach_;
  Thetas thetas_;
  std::uint64_t seed_;
  Orient orient_;
  bool normalize_;
  bool uses_flags_;
  Vec3 up_;
  int levels_;
  std::vector<SpacePolyline> polylines_;
  std::vector<std::uint64_t> edges_before_;  ///< of each polyline
};

}  // namespace burin::curves::two_point_3d
