#include <algorithm>
#include <array>

#include <burin/base/check.hpp>
#include <burin/passes/crop.hpp>
#include <burin/path/recording.hpp>

namespace burin::passes {

namespace {

/// The part of a segment inside the box, as parameters along it.
struct Inside {
  double from = 0.0;
  double to = 1.0;
  bool any() const { return from <= to; }
};

/// Liang and Barsky: each border shortens the part that is left.
Inside inside(const Box2& box, Vec2 p, Vec2 q) {
  Inside part;
  const auto cut = [&](double start, double direction, double low, double high) {
    if (direction == 0.0) {
      if (start < low || start > high) part = {1.0, 0.0};
      return;
    }
    const double a = (low - start) / direction;
    const double b = (high - start) / direction;
    part.from = std::max(part.from, std::min(a, b));
    part.to = std::min(part.to, std::max(a, b));
  };
  cut(p.x, q.x - p.x, box.low.x, box.high.x);
  cut(p.y, q.y - p.y, box.low.y, box.high.y);
  return part;
}

Vec2 clamped(const Box2& box, Vec2 p) {
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)};
}

}  // namespace

Crop::Crop(PathSink& next, const Box2& box) : Decorator(next), box_(box), strokes_(next), buffer_(next) {
  BURIN_EXPECT(!box.empty());
}

Flow Crop::begin(const PathHead& head) {
  head_ = head;
  strokes_.set_head(head);
  has_point_ = false;
  filling_ = false;
  return Flow::go;
}

Flow Crop::points(std::span<const Vec2> points) {
  for (const Vec2 point : points) {
    if (head_.paint != Paint::stroke) {
      if (fill_to(0, point) == Flow::stop) return Flow::stop;
    } else if (!has_point_) {
      strokes_.start(point, box_.contains(point));
    } else if (stroke_to(point) == Flow::stop) {
      return Flow::stop;
    }
    has_point_ = true;
  }
  return Flow::go;
}

Flow Crop::contour() {
  const Flow flow = head_.paint == Paint::stroke ? finish_stroke() : finish_fill();
  has_point_ = false;
  return flow;
}

Flow Crop::end() {
  if (head_.paint == Paint::stroke) return finish_stroke();
  if (finish_fill() == Flow::stop) return Flow::stop;
  return filling_ ? next().end() : Flow::go;
}

Flow Crop::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return PathSink::place(head, figure, at);
}

Flow Crop::stroke_to(Vec2 to) {
  const Vec2 last = strokes_.last();
  const Inside part = inside(box_, last, to);
  if (!part.any()) return strokes_.line_to(to, {});
  const Vec2 direction = to - last;
  const Segment left{part.from == 0.0 ? last : clamped(box_, last + part.from * direction),
                     part.to == 1.0 ? to : clamped(box_, last + part.to * direction)};
  return strokes_.line_to(to, {&left, 1});
}

Flow Crop::finish_stroke() {
  if (!has_point_) return Flow::go;
  if (strokes_.needs_closing() && stroke_to(strokes_.first()) == Flow::stop) return Flow::stop;
  return strokes_.finish();
}

double Crop::depth(std::size_t border, Vec2 point) const {
  switch (border) {
    case 0:
      return point.x - box_.low.x;
    case 1:
      return box_.high.x - point.x;
    case 2:
      return point.y - box_.low.y;
    default:
      return box_.high.y - point.y;
  }
}

Vec2 Crop::at_border(std::size_t border, Vec2 from, Vec2 to) const {
  const double a = depth(border, from);
  const double b = depth(border, to);
  Vec2 cut = from + a / (a - b) * (to - from);
  switch (border) {
    case 0:
      cut.x = box_.low.x;
      break;
    case 1:
      cut.x = box_.high.x;
      break;
    case 2:
      cut.y = box_.low.y;
      break;
    default:
      cut.y = box_.high.y;
      break;
  }
  return cut;
}

/// Sutherland and Hodgman, one point after another: each border hands on what it leaves to the next.
Flow Crop::fill_to(std::size_t border, Vec2 to) {
  if (border == borders_.size()) return add_fill_point(to);
  Border& b = borders_[border];
  const bool is_inside = depth(border, to) >= 0.0;
  if (!b.started) {
    b.started = true;
    b.first = to;
  } else if (is_inside != (depth(border, b.last) >= 0.0)) {
    if (fill_to(border + 1, at_border(border, b.last, to)) == Flow::stop) return Flow::stop;
  }
  b.last = to;
  return is_inside ? fill_to(border + 1, to) : Flow::go;
}

Flow Crop::finish_fill() {
  for (std::size_t border = 0; border < borders_.size(); ++border) {
    const Border b = borders_[border];
    if (!b.started || (depth(border, b.first) >= 0.0) == (depth(border, b.last) >= 0.0)) continue;
    if (fill_to(border + 1, at_border(border, b.last, b.first)) == Flow::stop) return Flow::stop;
  }
  borders_ = {};
  if (!contour_open_) return Flow::go;
  contour_open_ = false;
  return buffer_.finish(false);
}

Flow Crop::add_fill_point(Vec2 point) {
  if (!contour_open_) {
    if (!filling_) {
      PathHead closed = head_;
      closed.closed = true;  // a fill closes its contours anyway
      if (next().begin(closed) == Flow::stop) return Flow::stop;
    } else if (next().contour() == Flow::stop) {
      return Flow::stop;
    }
    filling_ = true;
    contour_open_ = true;
  }
  return buffer_.add(point);
}

}  // namespace burin::passes
