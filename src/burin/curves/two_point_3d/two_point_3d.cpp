#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <burin/curves/refinement/curve.hpp>
#include <burin/curves/refinement/in_front.hpp>
#include <burin/curves/two_point_3d/edge_tree.hpp>
#include <burin/curves/two_point_3d/two_point_3d.hpp>

namespace burin::curves {

namespace two_point_3d {

namespace {

/// A depth that the curve does not fall below, whatever the seed.
double least_depth_of_roots(const EdgeTree& tree, const SpaceLens& lens) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t part = 0; part < tree.part_count(); ++part) {
    for (std::size_t i = 0; i < tree.root_count(part); ++i) {
      least = std::min(least, -Nearness{lens}.of(tree.cover(tree.root(part, i))).bound);
    }
  }
  return least;
}

struct TwoPoint3dFamily {
  using Params = TwoPoint3dParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    if (params.sign && params.motif.sign) {
      context.report(table.find("sign")->where, "'sign' is given twice: in the curve and in its motif");
      return false;
    }
    if (params.motif.join) {
      context.report(table.find("motif")->where, "'join' is for two-point, in the plane");
      return false;
    }
    const std::size_t thetas = params.theta.by_marker.size();
    for (const two_point::Stage& stage : params.motif.by_level) {
      if (thetas == 1 || thetas == stage.mark_count()) continue;
      context.report(table.find("theta")->where,
                     fmt::format("'theta' needs one value, or one for each of the {} markers; found {}",
                                 stage.mark_count(), thetas));
      return false;
    }
    const SpaceLens lens = lens_of(params, {});
    if (!lens.camera().is_perspective()) return true;
    return check_in_front(least_depth_of_roots(EdgeTree(params, 0), lens), lens.camera(), table.find("camera")->where,
                          context);
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext& context, const Affine2& frame) {
    return bounds_of_curve(EdgeTree(params, context.seed), lens_of(params, {}), frame);
  }

  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return forecast_curve(EdgeTree(params, context.seed), lens_of(params, context.origin),
                          usable_view(params, context.view), enough);
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_curve(EdgeTree(params, context.seed), lens_of(params, context.origin),
                      usable_view(params, context.view), sink);
  }

  static bool uses_seed(const Params& params) {
    const std::optional<two_point::SignRule>& sign = params.sign ? params.sign : params.motif.sign;
    return params.motif.is_random() || (sign && sign->kind == two_point::SignRule::Kind::random) ||
           std::any_of(params.theta.by_marker.begin(), params.theta.by_marker.end(),
                       [](const two_point::Amount& theta) { return theta.is_random(); });
  }

  static std::uint64_t retained_every(const Params& params) {
    return params.levels == 0 ? 0 : params.motif.stage(params.levels).child_count();
  }

 private:
  static SpaceLens lens_of(const Params& params, Vec2 origin) { return {params.camera.camera(), {}, origin}; }

  /// No view where nothing bounds what an edge generates.
  static View usable_view(const Params& params, const View& view) {
    return SpaceReach(params).is_finite() ? view : View{};
  }
};

}  // namespace

}  // namespace two_point_3d

Family two_point_3d_family() {
  return make_family<two_point_3d::TwoPoint3dFamily>(
      "two-point-3d", "fractal curves in space: every edge is refined across planes that its neighbours span",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, section 3, space form", "levels");
}

}  // namespace burin::curves

namespace burin::params {

using curves::two_point::Amount;
using curves::two_point_3d::Thetas;

bool ValueType<Thetas>::read(const Value& value, Thetas& thetas, ReadContext& context) {
  if (value.array() != nullptr) {
    if (!ValueType<std::vector<Amount>>::read(value, thetas.by_marker, context)) return false;
    if (!thetas.by_marker.empty()) return true;
    context.report(value.where, "a list of thetas needs at least one");
    return false;
  }
  Amount amount;
  if (!ValueType<Amount>::read(value, amount, context)) return false;
  thetas.by_marker = {amount};
  return true;
}

std::string ValueType<Thetas>::text(const Thetas& thetas) {
  return thetas.by_marker.size() == 1 ? ValueType<Amount>::text(thetas.by_marker.front())
                                      : ValueType<std::vector<Amount>>::text(thetas.by_marker);
}

}  // namespace burin::params
