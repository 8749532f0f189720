#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <burin/geom/affine2.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/params/fields.hpp>
#include <burin/params/points.hpp>

namespace burin::curves {

/// A polyline, or a polygon whose last edge returns to its first point (which is not repeated).
template <class Point>
struct PolylineOf {
  std::vector<Point> points;
  bool closed = false;

  std::size_t edge_count() const { return closed ? points.size() : points.size() - 1; }
  Point edge_begin(std::size_t edge) const { return points[edge]; }
  Point edge_end(std::size_t edge) const { return points[edge + 1 == points.size() ? 0 : edge + 1]; }
};

/// A polygon given with its first point repeated is the polygon without.
template <class Point>
void drop_repeated_end(PolylineOf<Point>& polyline) {
  if (polyline.closed && polyline.points.size() > 2 && polyline.points.front() == polyline.points.back()) {
    polyline.points.pop_back();
  }
}

using Polyline = PolylineOf<Vec2>;
using SpacePolyline = PolylineOf<Vec3>;

/// What a scheme refines: S_0, model units, y up. Edges are counted through all polylines.
struct BaseShape {
  std::vector<Polyline> polylines{{{{0.0, 0.0}, {1.0, 0.0}}, false}};
  std::string text = "\"segment\"";  ///< as it was written, for help

  std::size_t edge_count() const;
};

/// "square": a closed default for families that do nothing to a segment.
BaseShape square_base();

/// The keys of a base written as a table, for help and docs.
std::vector<params::FieldInfo> base_fields();

}  // namespace burin::curves

/// "segment" (0,0)-(1,0); "triangle" and "square": counter-clockwise on that segment; { shape = "ngon", n = 5 } and
/// { shape = "star", n = 5, inner = 0.4 }: about the origin, circumradius 1, first corner up, counter-clockwise;
/// { points = [[x, y], ...], closed = true }; { csv = "file" }; { path = "M0 0 ..." } (SVG path data, turned y up);
/// { curve = { family = ... } }: the points of another curve.
template <>
struct burin::params::ValueType<burin::curves::BaseShape> {
  static std::string name() { return "base"; }
  static bool read(const Value& value, burin::curves::BaseShape& base, ReadContext& context);
  static std::string text(const burin::curves::BaseShape& base) { return base.text; }
};
