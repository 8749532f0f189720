#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/four_point.hpp>
#include <burin/curves/subdivision/convergence.hpp>
#include <burin/curves/subdivision/curve_family.hpp>

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
template <class Point>
Control<Point> open_control(const std::vector<Point>& points, GhostRule rule) {
  const std::size_t last = points.size() - 1;
  const auto ghost_at = [&](std::size_t end, std::size_t k) {
    const std::size_t step = std::min(k, last);
    return ghost(rule, points[end], points[end == 0 ? step : last - step]);
  };
  Control<Point> control{{ghost_at(0, 2), ghost_at(0, 1)}};
  control.points.insert(control.points.end(), points.begin(), points.end());
  control.points.push_back(ghost_at(last, 1));
  control.points.push_back(ghost_at(last, 2));
  return control;
}

struct FourPoint {
  using Params = FourPointParams;
  using Scheme = FourTap;

  static bool is_centred(const Params&) { return false; }

  static Scheme scheme_of(const Params& params) {
    const double outer = 0.5 * four_point_t(params);
    const double inner = 0.5 - outer;
    return {{0.0, 1.0, 0.0}, {outer, inner, inner, outer}, ghost_rule(params.ends), params.levels};
  }

  template <class Point>
  static Control<Point> control_of(const Params& params, const Scheme&, const std::vector<Point>& points, bool closed) {
    return closed ? closed_control<FourTap>(points, 0) : open_control(points, ghost_rule(params.ends));
  }

  static bool check(const Params&, const params::Table& table, params::ReadContext& context) {
    const params::Value* w = table.find("w");
    if (w == nullptr || table.find("t") == nullptr) return true;
    context.report(w->where, "'w' and 't' say the same, t = -2 w; give one of them");
    return false;
  }

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
  return make_family<CurveFamily<FourPoint>>(
      "four-point", "curves through given points by the four-point scheme, from smooth to fractal",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, eq. (3); Dyn, Gregory & Levin 1987", "levels");
}

}  // namespace burin::curves
