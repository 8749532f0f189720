#pragma once

#include <span>
#include <vector>

#include <burin/geom/clip.hpp>
#include <burin/path/stroke_pieces.hpp>

namespace burin::passes {

/// Draws what is left of strokes when parts of their segments are taken away: each piece is an open path, a closed
/// stroke of which nothing is missing stays closed, and the piece that runs over its first point is one.
///
/// Memory: a closed stroke until its first gap, else O(1).
class CutStrokes {
 public:
  explicit CutStrokes(PathSink& sink) : sink_(sink), pieces_(sink) {}

  /// The contours that follow are of such a path. start line_to* finish, again and again.
  void set_head(const PathHead& head) { head_ = head; }

  /// A contour's first point, and whether it is left: a contour of one point is a dot.
  void start(Vec2 point, bool is_left);

  /// `left`: the parts of the segment from `last()` that are left, in order and apart from one another; ends that are
  /// the segment's own are equal to them.
  Flow line_to(Vec2 to, std::span<const Segment> left);

  Vec2 first() const { return first_; }
  Vec2 last() const { return last_; }
  /// Whether the contour needs a line_to(first()) before it is finished.
  bool needs_closing() const { return head_.closed && !is_dot_; }
  Flow finish();

 private:
  Flow gap();
  Flow draw(const Segment& part);
  Flow whole();

  PathSink& sink_;
  StrokePieces pieces_;
  PathHead head_{};
  Vec2 first_{};
  Vec2 last_{};
  bool is_dot_ = false;
  bool first_is_left_ = false;
  bool opens_ = false;         ///< the contour is closed and without a gap so far
  std::vector<Vec2> opening_;  ///< of a closed contour, from its first point to its first gap
};

}  // namespace burin::passes
