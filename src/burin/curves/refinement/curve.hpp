#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <burin/curves/refinement/descent.hpp>
#include <burin/curves/refinement/farthest.hpp>
#include <burin/path/decorators.hpp>

/// Draw, forecast and bounds of a curve that is refined piece by piece, in the plane or in space. Its tree T has
///   using Point, Node;                              a node is a piece
///   std::size_t part_count() const;                 parts are paths
///   bool is_closed(part) const;
///   const std::vector<Point>& base(part) const;     from which the part is refined: says how large it is
///   std::vector<Point> before(part), after(part) const;  points of the last level beside those of the pieces
///   std::size_t root_count(part) const;  Node root(part, index) const;
///   double points_asked() const;
///   int levels() const;
///   bool is_last(node) const;                       of the last level: it begins with its only point
///   bool is_silent(node) const;                     of the last level: its point comes elsewhere
///   Cover<Point> cover(node) const;
///   Point start(node) const;                        the point of the last level that the piece begins with
///   Point first_guess(node) const;                  about where that is, without work
///   void push_children(node, std::vector<Node>& stack) const;  last first
/// and perhaps Runs, a faster way to all points: Runs(tree).emit(root, emitter).
namespace burin::curves {

template <class Tree, class Lens>
Flow draw_part(const Tree& tree, std::size_t part, const Lens& lens, const View& view, PathSink& sink) {
  const PathHead head{.closed = tree.is_closed(part), .level = static_cast<std::uint16_t>(tree.levels())};
  if (sink.begin(head) == Flow::stop) return Flow::stop;
  PictureEmitter<Lens> emitter(sink, lens);
  const auto emit_points = [&](const std::vector<typename Tree::Point>& points) {
    for (const auto& p : points) {
      if (emitter.point([&p] { return p; }) == Flow::stop) return Flow::stop;
    }
    return Flow::go;
  };
  if (emit_points(tree.before(part)) == Flow::stop) return Flow::stop;
  const auto emit_roots = [&](const auto& emit) {
    for (std::size_t i = 0; i < tree.root_count(part); ++i) {
      if (emit(tree.root(part, i)) == Flow::stop) return Flow::stop;
    }
    return Flow::go;
  };
  std::vector<typename Tree::Node> stack;
  Flow flow = Flow::go;
  if (view.is_limited()) {
    const Sight<Lens> sight(lens, view);
    flow = emit_roots([&](const auto& root) { return descend(tree, root, sight, emitter, stack); });
  } else if constexpr (requires { typename Tree::Runs; }) {
    typename Tree::Runs runs(tree);
    flow = emit_roots([&](const auto& root) { return runs.emit(root, emitter); });
  } else {
    flow = emit_roots([&](const auto& root) { return descend(tree, root, ShowAll{}, emitter, stack); });
  }
  if (flow == Flow::stop || emit_points(tree.after(part)) == Flow::stop) return Flow::stop;
  return emitter.finish() == Flow::stop ? Flow::stop : sink.end();
}

template <class Tree, class Lens>
Flow draw_curve(const Tree& tree, const Lens& lens, const View& view, PathSink& sink) {
  for (std::size_t part = 0; part < tree.part_count(); ++part) {
    if (draw_part(tree, part, lens, view, sink) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

template <class Tree, class Lens>
Forecast forecast_curve(const Tree& tree, const Lens& lens, const View& view, double enough) {
  const double asked = tree.points_asked();
  if (!view.is_limited()) return {asked, asked, true};
  const Sight<Lens> sight(lens, view);
  std::vector<typename Tree::Node> stack;
  double count = 0.0;
  for (std::size_t part = 0; part < tree.part_count(); ++part) {
    PointCounter counter(count + static_cast<double>(tree.before(part).size() + tree.after(part).size()), enough);
    for (std::size_t i = 0; i < tree.root_count(part); ++i) {
      if (descend(tree, tree.root(part, i), sight, counter, stack) == Flow::stop)
        return {counter.count(), asked, false};
    }
    count = counter.count();
  }
  return {count, asked, true};
}

/// Below this share of a curve's size a doubt about its reach is rounding.
inline constexpr double rounding_share = 1e-13;

/// The box of frame(picture), exact to rounding. When pieces that may still matter are too many, the curve is run
/// through; nothing when that is too long as well, and what is left open too large to be taken as it is.
template <class Tree, class Lens>
std::optional<Box2> bounds_of_curve(const Tree& tree, const Lens& lens, const Affine2& frame) {
  constexpr double most_points_replayed = 5e7;
  constexpr double open_share = 1e-6;
  Box2 base;
  for (std::size_t part = 0; part < tree.part_count(); ++part) {
    for (const auto& p : tree.base(part)) base.add(lens.picture(p));
  }
  const double size = std::max({base.width(), base.height(), std::numeric_limits<double>::min()});
  bool is_exact = true;
  const auto reach = [&](Vec2 direction) {
    const double scale = size * length(direction);
    const Farthest farthest = farthest_of(tree, PictureReach<Lens>{lens, direction}, rounding_share * scale);
    is_exact = is_exact && farthest.bound - farthest.reached <= open_share * scale;
    return farthest.bound;
  };
  const Vec2 right{frame.a, frame.c};
  const Vec2 up{frame.b, frame.d};
  Box2 box{{frame.e - reach(-right), frame.f - reach(-up)}, {frame.e + reach(right), frame.f + reach(up)}};
  if (!is_exact) {
    if (tree.points_asked() > most_points_replayed) return std::nullopt;
    BoundsSink bounds;
    Mapped mapped(bounds, frame);
    static_cast<void>(draw_curve(tree, lens, {}, mapped));
    box = bounds.box();
  }
  return is_finite(box.low) && is_finite(box.high) ? std::optional(box) : std::nullopt;
}

/// A depth that no point of the curve falls below; minus infinity if nothing is known.
template <class Tree>
double least_depth(const Tree& tree, const SpaceLens& lens) {
  const double grain = rounding_share * lens.camera().distance();
  const double bound = -farthest_of(tree, Nearness{lens}, grain).bound;
  return std::isnan(bound) ? -std::numeric_limits<double>::infinity() : bound;
}

}  // namespace burin::curves
