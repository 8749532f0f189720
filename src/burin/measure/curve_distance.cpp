#include <algorithm>
#include <cmath>
#include <string>

#include <burin/geom/box2.hpp>
#include <burin/measure/curve_distance.hpp>

namespace burin::measure {

namespace {

/// The share of the arc length at each point, from 0 to 1; nothing for a curve without length.
Result<std::vector<double>> arc_shares(const std::vector<Vec2>& curve, const std::string& which) {
  std::vector<double> shares(curve.size(), 0.0);
  for (std::size_t i = 1; i < curve.size(); ++i) shares[i] = shares[i - 1] + distance(curve[i - 1], curve[i]);
  if (shares.empty() || !(shares.back() > 0.0)) return Problem{{}, "the " + which + " curve has no length"};
  const double whole = shares.back();
  for (double& share : shares) share /= whole;
  return shares;
}

}  // namespace

Result<CurveDistance> curve_distance(const std::vector<Vec2>& curve, const std::vector<Vec2>& other) {
  const Result<std::vector<double>> shares = arc_shares(curve, "first");
  if (!shares) return shares.problems();
  const Result<std::vector<double>> other_shares = arc_shares(other, "second");
  if (!other_shares) return other_shares.problems();
  Box2 box;
  double sum = 0.0;
  double farthest = 0.0;
  std::size_t edge = 1;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double share = (*shares)[i];
    while (edge + 1 < other.size() && (*other_shares)[edge] < share) ++edge;
    const double begin = (*other_shares)[edge - 1];
    const double width = (*other_shares)[edge] - begin;
    const double along = width > 0.0 ? std::clamp((share - begin) / width, 0.0, 1.0) : 0.0;
    const double apart = distance(curve[i], lerp(other[edge - 1], other[edge], along));
    sum += apart * apart;
    farthest = std::max(farthest, apart);
    box.add(curve[i]);
  }
  return CurveDistance{std::sqrt(sum / static_cast<double>(curve.size())), farthest,
                       std::max(box.width(), box.height())};
}

}  // namespace burin::measure
