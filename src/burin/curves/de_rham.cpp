#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/de_rham.hpp>
#include <burin/curves/subdivision/convergence.hpp>
#include <burin/curves/subdivision/cover.hpp>
#include <burin/curves/subdivision/curve_family.hpp>
#include <burin/curves/subdivision/reach.hpp>

namespace burin::curves {

double near_t(const DeRhamParams& params) {
  const double t = params.lambda ? *params.lambda / (2.0 * *params.lambda + 1.0) : params.t;
  return params.order == DeRhamOrder::near ? t : 1.0 - t;
}

double de_rham_spectral_radius(double t) {
  if (t <= 0.25) return 1.0 - 2.0 * t;
  if (t >= 0.5) return std::max(t, 2.0 * t - 1.0);
  const double sum = 2.0 * t - 3.0 * t * t;
  const double product = t * (1.0 - 2.0 * t);
  return std::sqrt(0.5 * (sum + std::sqrt(sum * sum - 4.0 * product * product)));
}

namespace {

using namespace subdivision;

std::vector<double> mask_of(double t) {
  return {t, 1.0 - t, 1.0 - t, t};
}

/// A piece is the corner at the window's middle point, from the first of the points it becomes to the first of those
/// that the next corner becomes.
class CornerCut {
 public:
  static constexpr std::size_t window = 3;
  static constexpr std::size_t start = 1;

  CornerCut(double t, bool normalized, bool clamped, int levels)
      : far_(normalized ? t / std::abs(1.0 - 2.0 * t) : t),
        near_(normalized ? (1.0 - t) / std::abs(1.0 - 2.0 * t) : 1.0 - t),
        normalized_(normalized),
        clamped_(clamped) {
    reach_ = make_reach(window_maps(*this), levels);
  }

  template <class Point>
  void refine(const Point* old, std::size_t count, Point* fresh) const {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      fresh[2 * i] = near_ * old[i] + far_ * old[i + 1];
      fresh[2 * i + 1] = far_ * old[i] + near_ * old[i + 1];
    }
  }

  template <class Point>
  void mend(const Piece<Point, window>& piece, std::array<Point, window + 1>& fresh) const {
    if (!clamped_) return;
    if (piece.ends.first) fresh.front() = piece.window.front();
    if (piece.ends.last) fresh.back() = piece.window.back();
  }

  bool keeps_points() const { return false; }

  template <class Point>
  Cover<Point> cover(const Piece<Point, window>& piece, int remaining) const {
    // Normalized, no point gets farther from the centre than the farthest of the window.
    if (normalized_) return disc_of_window(piece.window, Point{});
    if (far_ >= 0.0 && far_ <= 0.5) return triangle(piece);
    const bool at_end = piece.ends.first || piece.ends.last;
    const Cover<Point> disc =
        disc_of_piece(piece, start, (at_end ? reach_.at_ends : reach_.inner)[static_cast<std::size_t>(remaining)]);
    const bool in_hull = far_ >= 0.0 && far_ <= 1.0;
    if (!in_hull) return disc;
    const Cover<Point> hull = disc_of_window(piece.window, disc.a);
    return hull.radius < disc.radius ? hull : disc;
  }

 private:
  /// For 0 <= t <= 1/2 the midpoints of edges stay on the curve, and between two of them it is an arc that bends one
  /// way inside the triangle of the corner.
  template <class Point>
  Cover<Point> triangle(const Piece<Point, window>& piece) const {
    const auto& [before, corner, after] = piece.window;
    const bool pinned_before = clamped_ && piece.ends.first;
    const bool pinned_after = clamped_ && piece.ends.last;
    const Point a = pinned_before ? before : 0.5 * (before + corner);
    const Point b = pinned_after ? after : far_ * corner + near_ * after;
    const double height = distance_to_segment(corner, a, b);
    return {a, b, height, height};
  }

  double far_;
  double near_;
  bool normalized_;
  bool clamped_;
  Reach reach_;
};

/// An open edge alone has no corner: it is refined as it stands.
template <class Point>
std::vector<Point> refined_edge(const CornerCut& scheme, std::vector<Point> ends, bool clamped, int levels) {
  for (int level = 0; level < levels && !clamped; ++level) {
    std::vector<Point> fresh(2);
    scheme.refine(ends.data(), ends.size(), fresh.data());
    if (fresh == ends) break;
    ends = fresh;
  }
  return ends;
}

/// What is known of the curve by t alone. Source: reference curves C.
std::string_view behaviour(double t) {
  if (t < 0.0) return "diverges like (1-2t)^level: a star of spikes";
  if (t == 0.0) return "the base itself";
  if (t == 0.25) return "tangent-continuous: Chaikin's, the uniform quadratic B-spline";
  if (t <= 1.0 / 3.0) return "tangent-continuous";
  if (t < 0.5) return "convex where the base is, with corners at a dense set of points";
  if (t == 0.5) return "the polygon through the midpoints of the edges";
  if (t < 1.0) return "a continuous fractal, nowhere smooth";
  return t == 1.0 ? "the base in an order that changes with every level" : "diverges like (2t-1)^level: woven bands";
}

struct DeRham {
  using Params = DeRhamParams;
  using Scheme = CornerCut;

  static bool is_centred(const Params& params) {
    const double t = near_t(params);
    return params.normalize && (t < 0.0 || t > 1.0);
  }

  static Scheme scheme_of(const Params& params) {
    return {near_t(params), is_centred(params), params.ends == DeRhamEnds::clamp, params.levels};
  }

  template <class Point>
  static Control<Point> control_of(const Params& params, const Scheme& scheme, std::vector<Point> points, bool closed) {
    if (closed) return closed_control<CornerCut>(points, 1);
    if (points.size() > 2) return {std::move(points), false, 1, 0};
    return {refined_edge(scheme, std::move(points), params.ends == DeRhamEnds::clamp, params.levels)};
  }

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    const params::Value* lambda = table.find("lambda");
    if (lambda == nullptr) return true;
    if (table.find("t") != nullptr) {
      context.report(lambda->where, "'lambda' and 't' say the same; give one of them");
      return false;
    }
    if (*params.lambda != -0.5) return true;
    context.report(lambda->where, "'lambda' = -0.5 has no t = lambda/(2 lambda + 1)");
    return false;
  }

  static LimitFacts limit_facts(const Params& params) {
    return {.smoothness = classify(mask_of(near_t(params))).smoothness()};
  }

  static std::string theory(const Params& params) {
    const double t = near_t(params);
    const double radius = de_rham_spectral_radius(t);
    std::string text = fmt::format("t = {} in the near order: {}\n", shortest_text(t), behaviour(t));
    if (t > 0.0 && t < 1.0) {
      text += fmt::format("converges, for 0 < t < 1: the longest edge shrinks like {}^level\n", fixed_text(radius, 6));
    } else {
      text += "does not converge to a continuous curve for all bases: that is so just for 0 < t < 1\n";
    }
    return text + convergence_text(classify(mask_of(t)));
  }
};

}  // namespace

Family de_rham_family() {
  return make_family<CurveFamily<DeRham>>(
      "de-rham", "corners cut off again and again: Chaikin's and de Rham's curves, fractals, stars of spikes",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, eq. (1), (2); G. de Rham 1947", "levels");
}

}  // namespace burin::curves
