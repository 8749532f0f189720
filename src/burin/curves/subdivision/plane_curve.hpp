#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/subdivision/control.hpp>
#include <burin/curves/subdivision/support.hpp>
#include <burin/curves/subdivision/walk.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/point_buffer.hpp>

/// What a family of subdivision curves in the plane is made of: draw, forecast and bounds, given the scheme and the
/// control points.
namespace burin::curves::subdivision {

template <class S>
struct PlaneCurve {
  S scheme;
  std::vector<Control<Vec2>> parts;
  int levels = 0;
  Vec2 centre{};  ///< the control points are counted from here
};

/// A polyline's points as seen from an origin. What is near it is then refined in small numbers.
inline std::vector<Vec2> seen_from(Vec2 origin, const Polyline& polyline) {
  std::vector<Vec2> points = polyline.points;
  for (Vec2& p : points) p = p - origin;
  return points;
}

/// Hides what is too small for a view or outside of it.
class PlaneSight {
 public:
  explicit PlaneSight(const View& view) : view_(view) {}

  bool hides(const Cover<Vec2>& cover) const {
    if (cover.error < view_.tolerance) return true;
    // A bound beyond all numbers hides nothing.
    if (!std::isfinite(cover.radius)) return false;
    Box2 box;
    box.add(cover.a);
    box.add(cover.b);
    return !view_.box.touches(box.grown(cover.radius));
  }

 private:
  View view_;
};

/// Sends points to a sink.
class PointEmitter {
 public:
  explicit PointEmitter(PathSink& sink) : buffer_(sink) {}

  template <class Make>
  Flow point(const Make& make) {
    return buffer_.add(make());
  }

  Flow run(std::span<const Vec2> points) {
    if (points.empty()) return Flow::go;
    Vec2* room = buffer_.reserve(points.size());
    if (room == nullptr) return Flow::stop;
    std::copy(points.begin(), points.end(), room);
    return Flow::go;
  }

  Flow finish() { return buffer_.finish(false); }

 private:
  PointBuffer buffer_;
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

/// The view from a curve's own centre.
inline View moved(View view, Vec2 centre) {
  view.box = {view.box.low - centre, view.box.high - centre};
  return view;
}

template <class S>
Flow draw_part(const PlaneCurve<S>& curve, const Control<Vec2>& control, const View& view, PathSink& sink) {
  const PathHead head{.closed = control.closed, .level = static_cast<std::uint16_t>(curve.levels)};
  if (sink.begin(head) == Flow::stop) return Flow::stop;
  PointEmitter emitter(sink);
  Walk<S, Vec2> walk(curve.scheme, curve.levels);
  const PlaneSight sight(view);
  const auto end_run = [&](const std::vector<Vec2>& points) {
    for (const Vec2 p : points) {
      if (emitter.point([p] { return p; }) == Flow::stop) return Flow::stop;
    }
    return Flow::go;
  };
  if (end_run(points_before(curve.scheme, control, curve.levels)) == Flow::stop) return Flow::stop;
  for (std::size_t i = 0; i < piece_count<S>(control); ++i) {
    const PieceOf<S, Vec2> piece = piece_at<S>(control, i);
    const Flow flow = view.is_limited() ? walk.seen(piece, sight, emitter) : walk.all(piece, emitter);
    if (flow == Flow::stop) return Flow::stop;
  }
  if (end_run(points_after(curve.scheme, control, curve.levels)) == Flow::stop) return Flow::stop;
  return emitter.finish() == Flow::stop ? Flow::stop : sink.end();
}

template <class S>
Flow draw_curve(const PlaneCurve<S>& curve, const DrawContext& context, PathSink& sink) {
  Mapped mapped(sink, translation(curve.centre));
  PathSink& target = curve.centre == Vec2{} ? sink : mapped;
  for (const Control<Vec2>& control : curve.parts) {
    if (draw_part(curve, control, moved(context.view, curve.centre), target) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

template <class S>
double points_asked(const PlaneCurve<S>& curve) {
  double points = 0.0;
  for (const Control<Vec2>& control : curve.parts) points += points_at_level<S>(control, curve.levels);
  return points;
}

template <class S>
Forecast forecast_curve(const PlaneCurve<S>& curve, const DrawContext& context, double enough) {
  const double asked = points_asked(curve);
  const View view = moved(context.view, curve.centre);
  if (!view.is_limited()) return {asked, asked, true};
  const PlaneSight sight(view);
  double count = 0.0;
  for (const Control<Vec2>& control : curve.parts) {
    const std::size_t pieces = piece_count<S>(control);
    PointCounter counter(count + static_cast<double>(points_beside<S>(control)), enough);
    Walk<S, Vec2> walk(curve.scheme, curve.levels);
    for (std::size_t i = 0; i < pieces; ++i) {
      if (walk.seen(piece_at<S>(control, i), sight, counter) == Flow::stop) return {counter.count(), asked, false};
    }
    count = counter.count();
  }
  return {count, asked, true};
}

/// The box of frame(curve), exact to rounding. When pieces that may still matter are too many, the curve is run
/// through; nothing when that is too long as well, and what is left open too large to be taken as it is.
template <class S>
std::optional<Box2> bounds_of_curve(const PlaneCurve<S>& curve, const Affine2& frame) {
  constexpr double most_points_replayed = 5e7;
  constexpr double open_share = 1e-6;
  Box2 base;
  for (const Control<Vec2>& control : curve.parts) {
    for (const Vec2 p : control.points) base.add(p);
  }
  const double size = std::max({base.width(), base.height(), std::numeric_limits<double>::min()});
  const Affine2 map = frame * translation(curve.centre);
  const Vec2 right{map.a, map.c};
  const Vec2 up{map.b, map.d};
  bool is_exact = true;
  const auto reach = [&](Vec2 direction) {
    const Support support = support_of(curve.scheme, curve.parts, curve.levels, direction, size);
    is_exact = is_exact && support.bound - support.reached <= open_share * size * length(direction);
    return support.bound;
  };
  Box2 box{{map.e - reach(-right), map.f - reach(-up)}, {map.e + reach(right), map.f + reach(up)}};
  if (!is_exact) {
    if (points_asked(curve) > most_points_replayed) return std::nullopt;
    BoundsSink bounds;
    Mapped mapped(bounds, frame);
    static_cast<void>(draw_curve(curve, {}, mapped));
    box = bounds.box();
  }
  return is_finite(box.low) && is_finite(box.high) ? std::optional(box) : std::nullopt;
}

}  // namespace burin::curves::subdivision
