#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <burin/curves/limit_facts.hpp>
#include <burin/curves/refinement/curve.hpp>
#include <burin/curves/refinement/in_front.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/curves/subdivision/tree.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves::subdivision {

/// A polyline's points as seen from an origin. What is near it is then refined in small numbers.
template <class Point>
std::vector<Point> seen_from(const Point& origin, const PolylineOf<Point>& polyline) {
  std::vector<Point> points = polyline.points;
  for (Point& p : points) p = p - origin;
  return points;
}

template <class Point>
Point mean_of(const std::vector<PolylineOf<Point>>& polylines) {
  Point sum{};
  double count = 0.0;
  for (const PolylineOf<Point>& polyline : polylines) {
    for (const Point& p : polyline.points) {
      sum = sum + p;
      count += 1.0;
    }
  }
  return (1.0 / count) * sum;
}

/// What all families of subdivision curves do alike, in the plane and in space. F has
///   using Params: with base (SpaceBase), camera (std::optional<CameraParams>) and levels
///   using Scheme
///   static Scheme scheme_of(const Params&)
///   static bool is_centred(const Params&)           whether the curve is refined about the mean of its points
///   template <class Point> static Control<Point> control_of(const Params&, const Scheme&, std::vector<Point>, closed)
///   static bool check(const Params&, const params::Table&, params::ReadContext&)
///   static LimitFacts limit_facts(const Params&)
///   static std::string theory(const Params&)
template <class F>
struct CurveFamily {
  using Params = typename F::Params;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    if (!F::check(params, table, context)) return false;
    if (!params.camera) return true;
    const Camera camera = params.camera->camera();
    if (!camera.is_perspective()) return true;
    return with_space_curve(params, camera, {}, [&](const auto& tree, const SpaceLens& lens) {
      return check_in_front(least_depth(tree, lens), camera, table.find("camera")->where, context);
    });
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext&, const Affine2& frame) {
    return with_curve(params, {},
                      [&](const auto& tree, const auto& lens) { return bounds_of_curve(tree, lens, frame); });
  }

  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    return with_curve(params, context.origin, [&](const auto& tree, const auto& lens) {
      return forecast_curve(tree, lens, context.view, enough);
    });
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return with_curve(params, context.origin,
                      [&](const auto& tree, const auto& lens) { return draw_curve(tree, lens, context.view, sink); });
  }

  static bool uses_seed(const Params&) { return false; }
  static LimitFacts limit_facts(const Params& params) { return F::limit_facts(params); }
  static std::string theory(const Params& params) { return F::theory(params); }

 private:
  template <class Point>
  static SchemeTree<typename F::Scheme, Point> tree_of(const Params& params, const Point& centre,
                                                       const std::vector<PolylineOf<Point>>& polylines) {
    const typename F::Scheme scheme = F::scheme_of(params);
    std::vector<Control<Point>> parts;
    for (const PolylineOf<Point>& polyline : polylines) {
      parts.push_back(F::control_of(params, scheme, seen_from(centre, polyline), polyline.closed));
    }
    return {scheme, std::move(parts), params.levels};
  }

  template <class Visit>
  static auto with_space_curve(const Params& params, const Camera& camera, Vec2 origin, const Visit& visit) {
    const std::vector<SpacePolyline> polylines = params.base.lifted();
    const Vec3 centre = F::is_centred(params) ? mean_of(polylines) : Vec3{};
    return visit(tree_of(params, centre, polylines), SpaceLens(camera, centre, origin));
  }

  /// Calls visit(tree, lens) for the curve, in the plane unless there is a camera or a base in space.
  template <class Visit>
  static auto with_curve(const Params& params, Vec2 origin, const Visit& visit) {
    if (params.camera || params.base.is_in_space()) {
      return with_space_curve(params, params.camera.value_or(params::CameraParams{}).camera(), origin, visit);
    }
    const std::vector<Polyline>& polylines = params.base.plane.polylines;
    const Vec2 centre = F::is_centred(params) ? mean_of(polylines) - origin : Vec2{};
    return visit(tree_of(params, origin + centre, polylines), PlaneLens(centre));
  }
};

}  // namespace burin::curves::subdivision
