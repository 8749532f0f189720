#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/four_point.hpp>
#include <burin/curves/subdivision/convergence.hpp>
#include <burin/curves/subdivision/plane_curve.hpp>

namespace burin::curves {

double four_point_t(const FourPointParams& params) {
  return params.w ? -2.0 * *params.w : params.t;
}

namespace {

using namespace subdivision;

std::vector<double> mask_of(double t) {
  const double outer = 0.5 * t;
  return {outer, 0.0, 0.5 - outer, 1.0, 0.5 - outer, 0.0, outer};
}

GhostRule ghost_rule(FourPointEnds ends) {
  if (ends == FourPointEnds::linear) return GhostRule::linear;
  return ends == FourPointEnds::reflect ? GhostRule::reflect : GhostRule::replicate;
}

/// Two ghosts at each side, of which the inner one counts: after each level it is made anew.
Control<Vec2> open_control(const std::vector<Vec2>& points, GhostRule rule) {
  const std::size_t last = points.size() - 1;
  const auto ghost_at = [&](std::size_t end, std::size_t k) {
    const std::size_t step = std::min(k, last);
    return ghost(rule, points[end], points[end == 0 ? step : last - step]);
  };
  Control<Vec2> control{{ghost_at(0, 2), ghost_at(0, 1)}};
  control.points.insert(control.points.end(), points.begin(), points.end());
  control.points.push_back(ghost_at(last, 1));
  control.points.push_back(ghost_at(last, 2));
  return control;
}

PlaneCurve<FourTap> curve_of(const FourPointParams& params, Vec2 origin) {
  const double outer = 0.5 * four_point_t(params);
  const double inner = 0.5 - outer;
  const GhostRule rule = ghost_rule(params.ends);
  PlaneCurve<FourTap> curve{
      FourTap({0.0, 1.0, 0.0}, {outer, inner, inner, outer}, rule, params.levels), {}, params.levels};
  for (const Polyline& polyline : params.base.polylines) {
    const std::vector<Vec2> points = seen_from(origin, polyline);
    curve.parts.push_back(polyline.closed ? closed_control<FourTap>(points, 0) : open_control(points, rule));
  }
  return curve;
}

struct FourPointFamily {
  using Params = FourPointParams;

  static bool check(const Params&, const params::Table& table, params::ReadContext& context) {
    const params::Value* w = table.find("w");
    if (w == nullptr || table.find("t") == nullptr) return true;
    context.report(w->where, "'w' and 't' say the same, t = -2 w; give one of them");
    return false;
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext&, const Affine2& frame) {
    return bounds_of_curve(curve_of(params, {}), frame);
  }

  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return forecast_curve(curve_of(params, context.origin), context, enough);
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_curve(curve_of(params, context.origin), context, sink);
  }

  static bool uses_seed(const Params&) { return false; }

  static LimitFacts limit_facts(const Params& params) {
    return {.smoothness = classify(mask_of(four_point_t(params))).smoothness()};
  }

  static std::string theory(const Params& params) {
    const double t = four_point_t(params);
    return fmt::format("t = {}, tension w = {}: the four-parameter scheme with lambda = mu = 0, nu = 1/2, omega = w\n",
                       shortest_text(t), shortest_text(-0.5 * t)) +
           convergence_text(classify(mask_of(t)));
  }
};

}  // namespace

Family four_point_family() {
  return make_family<FourPointFamily>(
      "four-point", "curves through given points by the four-point scheme, from smooth to fractal",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, eq. (3); Dyn, Gregory & Levin 1987", "levels");
}

}  // namespace burin::curves
