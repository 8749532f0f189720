#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/four_parameter.hpp>
#include <burin/curves/subdivision/convergence.hpp>
#include <burin/curves/subdivision/curve_family.hpp>

namespace burin::curves {

namespace {

/// What still counts as 0 in a side condition, and as 1 in a norm.
constexpr double rounding = 1e-12;

}  // namespace

std::vector<double> four_parameter_mask(double lambda, double mu, double nu, double omega) {
  return {-2.0 * omega * (1.0 - nu),      mu,     0.5 + 2.0 * omega * nu, 1.0 - lambda - mu,
          0.5 + 2.0 * omega * (1.0 - nu), lambda, -2.0 * omega * nu};
}

bool FourParameterTheorems::applies(int k) const {
  return (k < 2 || std::abs(sides[0]) <= rounding) && (k < 3 || std::abs(sides[1]) <= rounding);
}

FourParameterTheorems four_parameter_theorems(double lambda, double mu, double nu, double omega) {
  const double right = -2.0 * omega * (1.0 - nu);
  const double left = -2.0 * omega * nu;
  const double c1 = 2.0 * omega + mu - 2.0 * omega * nu;
  const double c2 = 0.5 - 2.0 * omega - mu + 4.0 * omega * nu;
  const double c3 = 0.5 + 2.0 * omega - lambda - 4.0 * omega * nu;
  const double c4 = lambda + 2.0 * omega * nu;
  const double e1 = 2.0 * lambda - mu - 4.0 * omega + 12.0 * omega * nu;
  const double e2 = 0.5 + 2.0 * omega - 2.0 * lambda - 8.0 * omega * nu;
  const double e3 = lambda + 4.0 * omega * nu;
  const double g1 = 0.5 + 2.0 * omega - 3.0 * lambda - 14.0 * omega * nu;
  const double g2 = lambda + 6.0 * omega * nu;
  using std::abs;
  FourParameterTheorems theorems;
  theorems.norms = {std::max(abs(left) + abs(c3) + abs(c1), abs(c4) + abs(c2) + abs(right)),
                    2.0 * std::max(abs(left) + abs(e2) + abs(right), abs(e3) + abs(e1)),
                    4.0 * std::max(abs(left) + abs(g1), abs(g2) + abs(right))};
  theorems.sides = {mu - lambda + 4.0 * omega - 8.0 * omega * nu,
                    -0.5 - mu - 4.0 * omega + 5.0 * lambda + 24.0 * omega * nu};
  for (int k = 1; k <= 3; ++k) {
    if (theorems.applies(k) && theorems.norms[static_cast<std::size_t>(k - 1)] < 1.0 - rounding) {
      theorems.covered = k - 1;
    }
  }
  return theorems;
}

namespace {

using namespace subdivision;

std::vector<double> mask_of(const FourParameterParams& params) {
  return four_parameter_mask(params.lambda, params.mu, params.nu, params.omega);
}

/// Two ghosts at each side, which are refined like other points.
template <class Point>
Control<Point> open_control(const std::vector<Point>& points, GhostRule rule) {
  if (rule == GhostRule::given) return {points, false, FourTap::start, FourTap::window - FourTap::start - 2};
  const std::size_t last = points.size() - 1;
  const auto ghost_at = [&](std::size_t end, std::size_t next, std::size_t k) {
    if (rule == GhostRule::linear) {
      const auto steps = static_cast<double>(k);
      return (steps + 1.0) * points[end] - steps * points[next];
    }
    // Reflected again where the curve is shorter than the reflection.
    const std::size_t step = k % (2 * last);
    const std::size_t back = step <= last ? step : 2 * last - step;
    return ghost(rule, points[end], points[end == 0 ? back : last - back]);
  };
  Control<Point> control{{ghost_at(0, 1, 2), ghost_at(0, 1, 1)}};
  control.points.insert(control.points.end(), points.begin(), points.end());
  control.points.push_back(ghost_at(last, last - 1, 1));
  control.points.push_back(ghost_at(last, last - 1, 2));
  return control;
}

struct FourParameter {
  using Params = FourParameterParams;
  using Scheme = FourTap;

  static bool is_centred(const Params&) { return false; }

  static Scheme scheme_of(const Params& params) {
    const std::vector<double> a = mask_of(params);
    return {{a[5], a[3], a[1]}, {a[6], a[4], a[2], a[0]}, GhostRule::given, params.levels};
  }

  template <class Point>
  static Control<Point> control_of(const Params& params, const Scheme&, const std::vector<Point>& points, bool closed) {
    return closed ? closed_control<FourTap>(points, 0) : open_control(points, params.ends);
  }

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    if (params.ends != GhostRule::given) return true;
    for (const SpacePolyline& polyline : params.base.lifted()) {
      if (polyline.closed || polyline.points.size() >= FourTap::window) continue;
      context.report(table.find("ends")->where,
                     fmt::format("'ends' = \"given\" needs a base of at least {} points, two of them beyond each end; "
                                 "found {}",
                                 FourTap::window, polyline.points.size()));
      return false;
    }
    return true;
  }

  static LimitFacts limit_facts(const Params& params) { return {.smoothness = classify(mask_of(params)).smoothness()}; }

  static std::string theory(const Params& params) {
    const FourParameterTheorems theorems = four_parameter_theorems(params.lambda, params.mu, params.nu, params.omega);
    std::string text = fmt::format("lambda = {}, mu = {}, nu = {}, omega = {}\n", shortest_text(params.lambda),
                                   shortest_text(params.mu), shortest_text(params.nu), shortest_text(params.omega));
    for (int k = 1; k <= 3; ++k) {
      const auto index = static_cast<std::size_t>(k - 1);
      text += fmt::format("Theorem {} (C{}): ", k, k - 1);
      if (!theorems.applies(k)) {
        const std::size_t side = std::abs(theorems.sides[0]) > rounding ? 0 : 1;
        text +=
            fmt::format("does not apply, its side condition is {} instead of 0\n", fixed_text(theorems.sides[side], 9));
        continue;
      }
      text += fmt::format("norm {} {}\n", fixed_text(theorems.norms[index], 9),
                          theorems.norms[index] < 1.0 - rounding ? "is below 1" : "is not below 1: says nothing");
    }
    text +=
        theorems.covered < 0 ? "by the theorems: nothing\n" : fmt::format("by the theorems: C{}\n", theorems.covered);
    return text + convergence_text(classify(mask_of(params)));
  }
};

}  // namespace

Family four_parameter_family() {
  return make_family<CurveFamily<FourParameter>>(
      "four-parameter",
      "curves near or through control points by the four-parameter scheme: B-splines, smooth, fractal",
      "Zhao, Peng & Ye, Improved Four Points Subdivision Scheme and its Applications, eq. (1), Theorems 1-3", "levels");
}

}  // namespace burin::curves
