#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <burin/curves/fractal_interpolation/curve.hpp>
#include <burin/curves/fractal_interpolation/enclosures.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::fractal_interpolation {

/// Walks the cells of one block depth first, in the order of x or t, and hands the left end of each that is not divided
/// to `emit(Vec2) -> Flow`. O(levels) memory. Under a limited view a cell is not divided when it lies outside, when the
/// curve in it stays within the tolerance of its chord, or when it is narrower than the tolerance.
template <class Emit>
class CellWalk {
 public:
  /// `span` is the whole curve's parameter range; no `enclosures`: every point of the level set.
  CellWalk(const Curve& curve, const Block& block, Interval span, const std::vector<Enclosures>& enclosures,
           const DrawContext& context, Emit& emit)
      : curve_(curve),
        block_(block),
        span_(span),
        enclosures_(enclosures),
        context_(context),
        emit_(emit),
        piece_count_(static_cast<std::uint32_t>(block.functions.front().pieces.size())),
        exact_(curve.exact) {}

  Flow walk() { return cell(0.0, 1.0); }

  /// The right end of the block.
  Flow end() {
    std::array<GraphPoint, 2> ends;
    for (std::size_t c = 0; c < block_.functions.size(); ++c) {
      ends[c] = node_point(block_.functions[c], piece_count_);
    }
    return point(ends);
  }

 private:
  const Interpolant& first() const { return block_.functions.front(); }

  /// Where in the part of the curve theta of this block lies.
  double place(double theta) const { return (first().begin + first().length * theta - span_.low) / span_.width(); }

  Flow cell(double begin, double width) {
    if (curve_.part) {
      constexpr double rounding = 1e-9;
      if (place(begin + width) < curve_.part->low - rounding || place(begin) > curve_.part->high + rounding) {
        return Flow::go;
      }
    }
    if (digits_.size() > static_cast<std::size_t>(curve_.levels)) return left_end();
    if (!enclosures_.empty() && !digits_.empty() && !is_worth_dividing()) return left_end();
    if (context_.stop.stop_requested()) return Flow::stop;
    for (std::uint32_t digit = 0; digit < piece_count_; ++digit) {
      const Piece& piece = first().pieces[digit];
      digits_.push_back(digit);
      const Flow flow = cell(begin + width * piece.start, width * piece.width);
      digits_.pop_back();
      if (flow == Flow::stop) return Flow::stop;
    }
    return Flow::go;
  }

  Flow left_end() {
    std::array<GraphPoint, 2> ends;
    for (std::size_t c = 0; c < block_.functions.size(); ++c) ends[c] = cell_left(block_.functions[c], digits_);
    return point(ends);
  }

  bool is_worth_dividing() const {
    std::array<CellBox, 2> boxes;
    std::array<double, 2> reach{};
    for (std::size_t c = 0; c < block_.functions.size(); ++c) {
      boxes[c] = cell_box(block_.functions[c], enclosures_[c], digits_);
      reach[c] = boxes[c].range.reach_from(boxes[c].left.y);
    }
    const double tolerance = context_.view.tolerance;
    Box2 box;
    double deviation = 0.0;  // two points of the cell are nowhere farther apart
    double size = 0.0;
    if (curve_.planar) {
      box = {{boxes[0].range.low, boxes[1].range.low}, {boxes[0].range.high, boxes[1].range.high}};
      deviation = 2.0 * length(Vec2{reach[0], reach[1]});
      size = boxes[0].width * block_.chord_length;
    } else {
      const double x = first().begin + first().length * boxes[0].left.theta;
      size = first().length * boxes[0].width;
      box = {{x, curve_.stretch * boxes[0].range.low}, {x + size, curve_.stretch * boxes[0].range.high}};
      deviation = 2.0 * curve_.stretch * reach[0];
    }
    const Box2 seen{box.low - context_.origin, box.high - context_.origin};
    return deviation > tolerance && size > tolerance && seen.touches(context_.view.box);
  }

  /// The point of the model these ends are, unless it is outside the part that is drawn.
  Flow point(const std::array<GraphPoint, 2>& ends) {
    if (curve_.part) {
      const double at = place(ends[0].theta);
      if (at < curve_.part->low || at > curve_.part->high) return Flow::go;
    }
    if (curve_.planar) return emit_(Vec2{ends[0].y, ends[1].y} - context_.origin);
    const double x = first().begin + first().length * ends[0].theta;
    double y = ends[0].y;
    if (exact_) y = (*exact_)(std::array{x}) - y;
    return emit_(Vec2{x, curve_.stretch * y} - context_.origin);
  }

  const Curve& curve_;
  const Block& block_;
  Interval span_;
  const std::vector<Enclosures>& enclosures_;
  const DrawContext& context_;
  Emit& emit_;
  std::uint32_t piece_count_;
  std::optional<expr::Expression> exact_;  ///< a copy: one machine must not run on two threads
  std::vector<std::uint32_t> digits_;
};

/// x or t of the whole curve.
inline Interval parameter_span(const Curve& curve) {
  const Interpolant& last = curve.blocks.back().functions.front();
  return {curve.blocks.front().functions.front().begin, last.begin + last.length};
}

/// Every point that is drawn, in order. A closed curve does not repeat its first point. `limited`: the view of the
/// context counts.
template <class Emit>
Flow trace(const Curve& curve, const DrawContext& context, bool limited, Emit emit) {
  const Interval span = parameter_span(curve);
  for (const Block& block : curve.blocks) {
    std::vector<Enclosures> enclosures;
    if (limited) {
      for (const Interpolant& f : block.functions) enclosures.push_back(make_enclosures(f));
    }
    CellWalk<Emit> walk(curve, block, span, enclosures, context, emit);
    if (walk.walk() == Flow::stop) return Flow::stop;
    const bool is_last = &block == &curve.blocks.back();
    if (is_last && !(curve.closed && !curve.part) && walk.end() == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

}  // namespace burin::curves::fractal_interpolation
