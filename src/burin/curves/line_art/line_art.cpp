#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/line_art/boundary_model.hpp>
#include <burin/curves/line_art/line_art.hpp>
#include <burin/curves/line_art/polyline_model.hpp>
#include <burin/curves/line_art/stroke_family.hpp>

namespace burin::curves {

namespace line_art {

bool check_line_points(double points, const params::Table& table, const char* knob, params::ReadContext& context) {
  if (points <= most_points_a_line) return true;
  const params::Value* value = table.find(knob);
  const Where where = value != nullptr ? value->where : Where{};
  context.report(where,
                 fmt::format("a polyline would have {} points, and {} are the most; lower '{}' or 'smooth_levels'",
                             count_text(points), count_text(most_points_a_line), knob));
  return false;
}

bool check_segments(const CountRange& segments, const NumberRange& length, const Composition& composition,
                    const params::Table& table, params::ReadContext& context) {
  constexpr int most_segments = 100'000;
  if (segments.low < 1 || segments.high > most_segments) {
    context.report(table.find("segments")->where, fmt::format("a polyline has 1 to {} segments", most_segments));
    return false;
  }
  if (length.low < 0.0 || length.high > farthest) {
    context.report(table.find("length")->where, "a segment's length is between 0 and 1e12");
    return false;
  }
  return check_line_points(
      smoothed_count(static_cast<std::size_t>(segments.high) + 1, composition.smooth, composition.smooth_levels), table,
      "segments", context);
}

bool check_boundary(const std::vector<double>& weights, std::size_t targets, const std::vector<double>& markers,
                    int levels, const Composition& composition, const params::Table& table,
                    params::ReadContext& context) {
  const auto fail = [&](const char* key, std::string message) {
    const params::Value* value = table.find(key);
    context.report(value != nullptr ? value->where : Where{}, std::move(message));
    return false;
  };
  if (targets == 0) return fail("to", "'to' needs a region");
  if (!weights.empty()) {
    if (weights.size() != targets) {
      return fail("weights", fmt::format("{} regions in 'to' need as many weights, found {}", targets, weights.size()));
    }
    const bool negative = std::any_of(weights.begin(), weights.end(), [](double w) { return w < 0.0; });
    const bool positive = std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; });
    if (negative || !positive) return fail("weights", "weights are not below 0, and one of them is above");
  }
  double before = 0.0;
  for (const double marker : markers) {
    if (!(marker > before && marker < 1.0)) {
      return fail("markers", fmt::format("markers ascend between 0 and 1; {} does not", shortest_text(marker)));
    }
    before = marker;
  }
  double points = 1.0;
  for (int level = 0; level < levels; ++level) points *= static_cast<double>(markers.size() + 1);
  for (int level = 0; level < composition.smooth_levels && composition.smooth != Smoothing::none; ++level) {
    points *= 2.0;
  }
  return check_line_points(points, table, "levels", context);
}

namespace {

struct PolylineFamily : StrokeFamily<LineArtParams, PolylineModel> {
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
    if (params.flow && params.heading) {
      return fail("heading", "'heading' and 'flow' both say where polylines go first; leave one out");
    }
    return check_segments(params.segments, params.length, params.compose, table, context);
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

struct BoundaryFamily : StrokeFamily<LineArtBoundaryParams, BoundaryModel> {
  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    return check_boundary(params.weights, params.to.all.size(), params.markers, params.levels, params.compose, table,
                          context);
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
