#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <burin/curves/refinement/lens.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/point_buffer.hpp>

/// Walks the refinement of a curve depth first.
namespace burin::curves {

/// Hides what is too small for a view or outside of it.
template <class Lens>
class Sight {
 public:
  Sight(const Lens& lens, const View& view) : lens_(lens), view_(view) {}

  template <class Point>
  bool hides(const Cover<Point>& cover) const {
    if (lens_.picture_error(cover) < view_.tolerance) return true;
    Box2 box;
    for (const Point& end : {cover.a, cover.b}) {
      const double radius = lens_.picture_radius(end, cover.radius);
      // A bound beyond all numbers hides nothing.
      if (!std::isfinite(radius)) return false;
      const Vec2 centre = lens_.picture(end);
      box.add(Box2{centre, centre}.grown(radius));
    }
    return !view_.box.touches(box);
  }

 private:
  const Lens& lens_;
  View view_;
};

/// Sends the pictures of points to a sink.
template <class Lens>
class PictureEmitter {
 public:
  PictureEmitter(PathSink& sink, const Lens& lens) : buffer_(sink), lens_(lens) {}

  template <class Make>
  Flow point(const Make& make) {
    return buffer_.add(lens_.picture(make()));
  }

  /// Pre: fewer points than PointBuffer::capacity.
  template <class Point>
  Flow run(std::span<const Point> points) {
    if (points.empty()) return Flow::go;
    Vec2* room = buffer_.reserve(points.size());
    if (room == nullptr) return Flow::stop;
    std::transform(points.begin(), points.end(), room, [&](const Point& p) { return lens_.picture(p); });
    return Flow::go;
  }

  Flow finish() { return buffer_.finish(false); }

 private:
  PointBuffer buffer_;
  const Lens& lens_;
};

/// Counts points without computing them, and gives up above `enough`.
class PointCounter {
 public:
  PointCounter(double count, double enough) : count_(count), enough_(enough) {}

  template <class Make>
  Flow point(const Make&) {
    count_ += 1.0;
    return count_ > enough_ ? Flow::stop : Flow::go;
  }

  double count() const { return count_; }

 private:
  double count_;
  double enough_;
};

/// A sight that hides nothing.
struct ShowAll {
  template <class Point>
  bool hides(const Cover<Point>&) const {
    return false;
  }
};

/// Emits a piece by emitter.point(make), where make() computes the point: the start of every piece of the last level,
/// and of a piece that `sight` hides its start alone, which is a point of the last level like all others.
template <class Tree, class S, class Emitter>
Flow descend(const Tree& tree, const typename Tree::Node& root, const S& sight, Emitter& emitter,
             std::vector<typename Tree::Node>& stack) {
  stack.assign(1, root);
  while (!stack.empty()) {
    const typename Tree::Node piece = stack.back();
    stack.pop_back();
    const bool is_last = tree.is_last(piece);
    if (is_last && tree.is_silent(piece)) continue;
    if (is_last || sight.hides(tree.cover(piece))) {
      if (emitter.point([&] { return tree.start(piece); }) == Flow::stop) return Flow::stop;
    } else {
      tree.push_children(piece, stack);
    }
  }
  return Flow::go;
}

}  // namespace burin::curves
