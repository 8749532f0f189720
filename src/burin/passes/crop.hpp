#pragma once

#include <array>
#include <cstddef>

#include <burin/geom/box2.hpp>
#include <burin/passes/cut_strokes.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/point_buffer.hpp>

namespace burin::passes {

/// Lets through what lies in a box, borders included. Strokes are cut into the pieces inside it, which are open; a
/// closed stroke that never leaves the box stays closed. Fills become the part of their area inside: contours keep
/// their windings, and run along the border where they were cut. What only touches the box may go or stay.
///
/// Memory: the part of a closed stroke before it first leaves the box, else O(1). Time: O(1) a point.
class Crop final : public Decorator {
 public:
  /// Pre: the box is not empty.
  Crop(PathSink& next, const Box2& box);

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  /// One border of the box while a fill's contour passes it.
  struct Border {
    bool started = false;
    Vec2 first{};
    Vec2 last{};
  };

  Flow stroke_to(Vec2 to);
  Flow finish_stroke();
  Flow fill_to(std::size_t border, Vec2 to);
  Flow finish_fill();
  Flow add_fill_point(Vec2 point);

  /// How far the point lies inside a border; negative outside.
  double depth(std::size_t border, Vec2 point) const;
  Vec2 at_border(std::size_t border, Vec2 from, Vec2 to) const;

  Box2 box_;
  CutStrokes strokes_;
  PointBuffer buffer_;  ///< of a fill
  PathHead head_{};
  bool has_point_ = false;

  std::array<Border, 4> borders_{};
  bool filling_ = false;       ///< the fill's path is begun
  bool contour_open_ = false;  ///< and its contour has a point
};

}  // namespace burin::passes
