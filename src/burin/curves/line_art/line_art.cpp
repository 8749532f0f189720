#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/line_art/boundary_model.hpp>
#include <burin/curves/line_art/line_art.hpp>
#include <burin/curves/line_art/polyline_model.hpp>
#include <burin/curves/line_art/strokes.hpp>
#include <burin/path/decorators.hpp>

namespace burin::curves {

namespace line_art {

namespace {

bool is_seen(const std::vector<Vec2>& stroke, Vec2 origin, const View& view) {
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
    for (const std::vector<Vec2>& stroke : strokes.of(line, points)) {
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

/// A line is made in one piece, so its points must fit into memory.
bool check_line_points(double points, const params::Table& table, const char* knob, params::ReadContext& context) {
  if (points <= most_points_a_line) return true;
  const params::Value* value = table.find(knob);
  const Where where = value != nullptr ? value->where : Where{};
  context.report(where,
                 fmt::format("a polyline would have {} points, and {} are the most; lower '{}' or 'smooth_levels'",
                             count_text(points), count_text(most_points_a_line), knob));
  return false;
}

struct PolylineFamily {
  using Params = LineArtParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    const auto fail = [&](const char* key, std::string message) {
      context.report(table.find(key)->where, std::move(message));
      return false;
    };
    if (params.lines && params.starts) {
      return fail("starts", "'lines' and 'starts' are given: the lines are starts x lines_per_start");
    }
    if (params.starts && double{1} * *params.starts * params.lines_per_start > most_lines) {
      return fail("starts", fmt::format("starts x lines_per_start is more than {} lines", most_lines));
    }
    constexpr int most_segments = 100'000;
    if (params.segments.low < 1 || params.segments.high > most_segments) {
      return fail("segments", fmt::format("a polyline has 1 to {} segments", most_segments));
    }
    if (params.length.low < 0.0 || params.length.high > farthest) {
      return fail("length", "a segment's length is between 0 and 1e12");
    }
    if (params.flow && params.heading) {
      return fail("heading", "'heading' and 'flow' both say where polylines go first; leave one out");
    }
    const Composition& composition = params.compose;
    return check_line_points(smoothed_count(static_cast<std::size_t>(params.segments.high) + 1, composition.smooth,
                                            composition.smooth_levels),
                             table, "segments", context);
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext& context, const Affine2& frame) {
    return stroke_bounds(PolylineModel(params, context.seed), context, frame);
  }
  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return stroke_forecast(PolylineModel(params, context.seed), context, enough);
  }
  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_strokes(PolylineModel(params, context.seed), context, sink);
  }

  static bool uses_seed(const Params& params) {
    const bool any_heading = !params.heading && !params.flow;
    const bool random_start = !std::holds_alternative<SpotRegion>(params.start.shape) && params.places != Places::steps;
    return any_heading || random_start || params.spread > 0.0 || params.turn > 0.0 ||
           params.segments.low < params.segments.high || params.length.low < params.length.high ||
           params.flow.uses_chance() || params.stretch.uses_chance() || params.compose.uses_seed() ||
           std::holds_alternative<AreaRegion>(params.start.shape);
  }
};

struct BoundaryFamily {
  using Params = LineArtBoundaryParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    const auto fail = [&](const char* key, std::string message) {
      const params::Value* value = table.find(key);
      context.report(value != nullptr ? value->where : Where{}, std::move(message));
      return false;
    };
    if (params.to.all.empty()) return fail("to", "'to' needs a region");
    if (!params.weights.empty()) {
      if (params.weights.size() != params.to.all.size()) {
        return fail("weights", fmt::format("{} regions in 'to' need as many weights, found {}", params.to.all.size(),
                                           params.weights.size()));
      }
      const bool negative = std::any_of(params.weights.begin(), params.weights.end(), [](double w) { return w < 0.0; });
      const bool positive = std::any_of(params.weights.begin(), params.weights.end(), [](double w) { return w > 0.0; });
      if (negative || !positive) return fail("weights", "weights are not below 0, and one of them is above");
    }
    double before = 0.0;
    for (const double marker : params.markers) {
      if (!(marker > before && marker < 1.0)) {
        return fail("markers", fmt::format("markers ascend between 0 and 1; {} does not", shortest_text(marker)));
      }
      before = marker;
    }
    double points = 1.0;
    for (int level = 0; level < params.levels; ++level) points *= static_cast<double>(params.markers.size() + 1);
    for (int level = 0; level < params.compose.smooth_levels && params.compose.smooth != Smoothing::none; ++level) {
      points *= 2.0;
    }
    return check_line_points(points, table, "levels", context);
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext& context, const Affine2& frame) {
    return stroke_bounds(BoundaryModel(params, context.seed), context, frame);
  }
  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return stroke_forecast(BoundaryModel(params, context.seed), context, enough);
  }
  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_strokes(BoundaryModel(params, context.seed), context, sink);
  }

  static bool uses_seed(const Params& params) {
    const auto is_random_place = [](const Region& region, bool in_steps) {
      return std::holds_alternative<AreaRegion>(region.shape) ||
             (!std::holds_alternative<SpotRegion>(region.shape) && !in_steps);
    };
    const bool steps = params.places == Places::steps;
    const bool end_in_steps = steps && (params.pairing == Pairing::ordered || params.pairing == Pairing::crossed);
    const bool random_ends = params.to.all.size() > 1 || is_random_place(params.from, steps) ||
                             std::any_of(params.to.all.begin(), params.to.all.end(),
                                         [&](const Region& region) { return is_random_place(region, end_in_steps); });
    const bool random_offsets = params.offset > 0.0 && params.levels > 0 && !params.markers.empty();
    return random_ends || random_offsets || params.compose.uses_seed();
  }
};

}  // namespace

}  // namespace line_art

Family line_art_family() {
  return make_family<line_art::PolylineFamily>(
      "line-art", "line art in Dehlinger's manner: thousands of random polylines, free or along a flow",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, section 5, properties (1) to (4)", "lines");
}

Family line_art_boundary_family() {
  return make_family<line_art::BoundaryFamily>(
      "line-art-boundary", "line art held between two regions: chords refined by random offsets",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, section 5, boundary model", "lines");
}

}  // namespace burin::curves
