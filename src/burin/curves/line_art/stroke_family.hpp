#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/line_art/line_art.hpp>
#include <burin/curves/line_art/strokes.hpp>
#include <burin/path/decorators.hpp>

/// Draw, forecast and bounds of line art, given a model that makes its polylines. A model M has
///   static constexpr Meet meet;                      what becomes of polylines unless the composition says so
///   int line_count() const;  const Composition& composition() const;
///   bool has_known_counts() const;                   whether every polyline has point_count points within reach()
///   std::size_t point_count(std::uint64_t line) const;  Box2 reach() const;
///   void trace(std::uint64_t line, std::vector<Vec2>& points);
///   double depth() const;                            of the polyline traced last: that of Spot
namespace burin::curves::line_art {

inline bool is_seen(const std::vector<Vec2>& stroke, Vec2 origin, const View& view) {
  Box2 box;
  for (const Vec2 p : stroke) box.add(p - origin);
  return box.touches(view.box);
}

/// Whether the view shows every point without a look at them.
template <class Model>
bool sees_all(const Model& model, const DrawContext& context) {
  if (!context.view.is_limited()) return true;
  if (!model.has_known_counts()) return false;
  const Box2 reach = model.reach();
  const Box2& seen = context.view.box;
  return seen.contains(reach.low - context.origin) && seen.contains(reach.high - context.origin);
}

/// Calls visit(stroke, kind) for every stroke that the view shows, until it says stop.
template <class Model, class Visit>
Flow each_stroke(Model model, const DrawContext& context, const Visit& visit) {
  Strokes strokes(model.composition(), Model::meet, context.seed);
  const bool all_seen = sees_all(model, context);
  std::vector<Vec2> points;
  const auto lines = static_cast<std::uint64_t>(model.line_count());
  for (std::uint64_t line = 0; line < lines && !strokes.spent(); ++line) {
    if (context.stop.stop_requested()) return Flow::stop;
    model.trace(line, points);
    for (const std::vector<Vec2>& stroke : strokes.of(line, points, model.depth())) {
      if (!all_seen && !is_seen(stroke, context.origin, context.view)) continue;
      if (visit(stroke, strokes.kind()) == Flow::stop) return Flow::stop;
    }
  }
  return Flow::go;
}

template <class Model>
Flow draw_strokes(const Model& model, const DrawContext& context, PathSink& sink) {
  std::vector<Vec2> moved;
  return each_stroke(model, context, [&](const std::vector<Vec2>& stroke, std::uint16_t kind) {
    const std::vector<Vec2>* drawn = &stroke;
    if (context.origin != Vec2{}) {
      moved.clear();
      for (const Vec2 p : stroke) moved.push_back(p - context.origin);
      drawn = &moved;
    }
    if (sink.begin({.level = kind}) == Flow::stop || sink.points(*drawn) == Flow::stop) return Flow::stop;
    return sink.end();
  });
}

template <class Model>
std::optional<Box2> stroke_bounds(const Model& model, const DrawContext& context, const Affine2& frame) {
  BoundsSink sink;
  Mapped mapped(sink, frame);
  DrawContext every_point = context;
  every_point.view = {};
  if (draw_strokes(model, every_point, mapped) == Flow::stop) return std::nullopt;
  return sink.finite() ? std::optional(sink.box()) : std::nullopt;
}

/// Points of all polylines when none is composed away.
template <class Model>
double points_asked(const Model& model) {
  const Composition& composition = model.composition();
  double points = 0.0;
  const auto lines = static_cast<std::uint64_t>(model.line_count());
  for (std::uint64_t line = 0; line < lines; ++line) {
    points += smoothed_count(model.point_count(line), composition.smooth, composition.smooth_levels);
  }
  return points;
}

template <class Model>
Forecast stroke_forecast(const Model& model, const DrawContext& context, double enough) {
  const double asked = points_asked(model);
  if (model.has_known_counts() && model.composition().keeps_all() && sees_all(model, context)) {
    return {asked, asked, true};
  }
  double points = 0.0;
  const Flow flow = each_stroke(model, context, [&](const std::vector<Vec2>& stroke, std::uint16_t) {
    points += static_cast<double>(stroke.size());
    return points > enough ? Flow::stop : Flow::go;
  });
  return {points, asked, flow == Flow::go};
}

/// What of a polyline model is checked in the plane and in space: counts and lengths. False after reporting.
bool check_segments(const CountRange& segments, const NumberRange& length, const Composition& composition,
                    const params::Table& table, params::ReadContext& context);

/// What of a boundary model is checked in the plane and in space: weights, markers and how many points they make.
/// False after reporting.
bool check_boundary(const std::vector<double>& weights, std::size_t targets, const std::vector<double>& markers,
                    int levels, const Composition& composition, const params::Table& table,
                    params::ReadContext& context);

/// A line is made in one piece, so its points must fit into memory: false after reporting at `knob`.
bool check_line_points(double points, const params::Table& table, const char* knob, params::ReadContext& context);

/// What every family of strokes has alike, from the model that makes its polylines.
template <class P, class Model>
struct StrokeFamily {
  using Params = P;

  static std::optional<Box2> bounds(const Params& params, const DrawContext& context, const Affine2& frame) {
    return stroke_bounds(Model(params, context.seed), context, frame);
  }
  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return stroke_forecast(Model(params, context.seed), context, enough);
  }
  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_strokes(Model(params, context.seed), context, sink);
  }
};

}  // namespace burin::curves::line_art
