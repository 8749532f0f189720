#pragma once

#include <vector>

#include <burin/base/result.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::measure {

/// How far a curve is from another that is run through at the same pace.
struct CurveDistance {
  double rmse = 0.0;      ///< root mean square over the points of the first
  double farthest = 0.0;  ///< the largest of those distances
  double extent = 0.0;    ///< the longer side of the first's box, by which both may be divided
};

/// Holds every point of `curve` against the point of `other` at the same share of the arc length. A problem when one of
/// them has no length. O(points). Source: reference interpolation 8.
Result<CurveDistance> curve_distance(const std::vector<Vec2>& curve, const std::vector<Vec2>& other);

}  // namespace burin::measure
