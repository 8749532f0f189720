#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <burin/curves/two_point/keyed_rule.hpp>
#include <burin/curves/two_point_3d/reach.hpp>

namespace burin::curves::two_point_3d {

namespace {

using two_point::Interval;
using two_point::Mark;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The longest that a blend of unit vectors can be: |1 - theta| + |theta|.
double longest_blend(const Thetas& thetas) {
  double longest = 1.0;
  for (const two_point::Amount& theta : thetas.by_marker) {
    for (const double end : {theta.range().low, theta.range().high}) {
      longest = std::max(longest, std::abs(1.0 - end) + std::abs(end));
    }
  }
  return longest;
}

/// Whether two neighbouring markers of an edge have the same normal.
bool share_normal(const Thetas& thetas, std::size_t marker) {
  const two_point::Amount& here = thetas.of(marker);
  const two_point::Amount& next = thetas.of(marker + 1);
  return here.is_constant() && next.is_constant() && here.low == next.low;
}

/// `factor` times a length: 0 whenever the length is, even for a factor beyond all numbers.
double scaled(double factor, double length) {
  return length == 0.0 ? 0.0 : factor * length;
}

/// The largest magnitude of a sum (sign 1) or difference (-1).
double largest_of(Interval a, Interval b, double sign) {
  if (sign > 0.0) return two_point::largest_magnitude({a.low + b.low, a.high + b.high});
  return two_point::largest_magnitude({a.low - b.high, a.high - b.low});
}

/// A sub-edge of an edge of length 1: how far its midpoint is from the edge's, and how long it is, both at most.
struct SubEdge {
  double away;
  double ratio;
};

SubEdge sub_edge(const std::vector<Mark>& marks, std::size_t j, const Thetas& thetas, double blend) {
  constexpr Interval none{0.0, 0.0};
  const Interval alpha = j == 0 ? none : marks[j - 1].alpha.range();
  const Interval next_alpha = j == marks.size() ? Interval{1.0, 1.0} : marks[j].alpha.range();
  const Interval beta = j == 0 ? none : marks[j - 1].beta.range();
  const Interval next_beta = j == marks.size() ? none : marks[j].beta.range();
  // Normals of their own may be opposite.
  const bool shared = j > 0 && j < marks.size() && share_normal(thetas, j);
  const double apart = two_point::largest_magnitude(beta) + two_point::largest_magnitude(next_beta);
  const double rise = shared ? largest_of(next_beta, beta, -1.0) : apart;
  const double across = 0.5 * (shared ? largest_of(next_beta, beta, 1.0) : apart);
  const Interval middle{0.5 * (alpha.low + next_alpha.low) - 0.5, 0.5 * (alpha.high + next_alpha.high) - 0.5};
  return {length(Vec2{two_point::largest_magnitude(middle), scaled(blend, across)}),
          length(Vec2{largest_of(next_alpha, alpha, -1.0), scaled(blend, rise)})};
}

/// Every sub-edge that there may be.
std::vector<SubEdge> sub_edges(const two_point::Motif& motif, const Thetas& thetas, double blend) {
  std::vector<SubEdge> all;
  for (const two_point::Stage& stage : motif.by_level) {
    for (const std::vector<Mark>& marks : stage.by_edge) {
      for (std::size_t j = 0; j <= marks.size(); ++j) all.push_back(sub_edge(marks, j, thetas, blend));
    }
  }
  return all;
}

/// The largest |beta|, when every alpha lies within its edge.
double largest_beta(const two_point::Motif& motif) {
  double largest = 0.0;
  for (const two_point::Stage& stage : motif.by_level) {
    for (const std::vector<Mark>& marks : stage.by_edge) {
      largest = std::max(largest, two_point::absolute_beta_bound(marks));
    }
  }
  return largest;
}

}  // namespace

SpaceReach::SpaceReach(const TwoPoint3dParams& params) : absolute_(params.motif.absolute) {
  constexpr double safety = 1.0 + 1e-9;  // room for rounding
  const double blend = params.normalize ? 1.0 : longest_blend(params.theta);
  reach_.push_back(absolute_ ? 0.0 : 0.5);
  if (absolute_) {
    const double beta = scaled(safety * blend, largest_beta(params.motif));
    double decay = 1.0;
    for (int level = 0; level < params.levels; ++level, decay *= params.motif.decay) {
      reach_.push_back(reach_.back() + scaled(beta, decay));
    }
    return;
  }
  const std::vector<SubEdge> all = sub_edges(params.motif, params.theta, blend);
  for (int level = 0; level < params.levels; ++level) {
    double farthest = 0.0;
    for (const auto& [away, ratio] : all) farthest = std::max(farthest, safety * (away + ratio * reach_.back()));
    // A beta that decays only shrinks both; of one that grows nothing is known.
    reach_.push_back(params.motif.decay <= 1.0 ? farthest : infinity);
  }
}

Cover<Vec3> SpaceReach::cover(Vec3 a, Vec3 b, int remaining, double decay) const {
  const double reach = reach_[static_cast<std::size_t>(remaining)];
  if (absolute_) return {a, b, reach * decay, reach * decay};
  const Vec3 middle = 0.5 * (a + b);
  const double edge = distance(a, b);
  // An edge without length has no refinement, even where nothing is known of others.
  const double radius = scaled(reach, edge);
  return {middle, middle, radius, radius};
}

bool SpaceReach::is_finite() const {
  return std::isfinite(reach_.back());
}

}  // namespace burin::curves::two_point_3d
