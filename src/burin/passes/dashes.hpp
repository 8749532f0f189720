#pragma once

#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/geom/dash_walk.hpp>
#include <burin/passes/cut_strokes.hpp>
#include <burin/path/decorators.hpp>

namespace burin::passes {

/// Cuts strokes into dashes, each an open path, so that a line that is cut further on keeps the dashes of the whole one
/// in every format. The pattern begins anew at each contour; a closed one that begins and ends in a dash has no gap
/// there. Fills pass as they are.
///
/// Memory: a closed contour up to its first gap, else O(1). Time: O(1) a point and dash.
class Dashes final : public Decorator {
 public:
  /// `lengths_mm`: on, off, on ...; a pattern shorter than a thousandth of a millimetre is a full line. What lies out
  /// of `box` may be left out. Pre: no length is below 0, and one is above; the box is not empty.
  Dashes(PathSink& next, const std::vector<double>& lengths_mm, const Box2& box)
      : Decorator(next), walk_(lengths_mm, 0.0), box_(box), strokes_(next) {}

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  bool passes_on() const;
  Flow stroke_to(Vec2 to);
  Flow finish_stroke();

  DashWalk walk_;
  Box2 box_;
  CutStrokes strokes_;
  std::vector<Segment> left_;
  PathHead head_{};
  bool has_point_ = false;
};

}  // namespace burin::passes
