#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include <burin/curves/two_point/bounds.hpp>

namespace burin::curves::two_point {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A slack below this share of the base's size is rounding.
constexpr double rounding_share = 1e-13;

Box2 base_box(const BaseShape& base) {
  Box2 box;
  for (const Polyline& polyline : base.polylines) {
    for (const Vec2 p : polyline.points) box.add(p);
  }
  return box;
}

template <class Visit>
void for_each_base_edge(const BaseShape& base, Visit visit) {
  std::uint64_t ordinal = 0;
  for (const Polyline& polyline : base.polylines) {
    for (std::size_t e = 0; e < polyline.edge_count(); ++e) {
      visit(polyline.edge_begin(e), polyline.edge_end(e), ordinal++);
    }
  }
}

/// The box of frame(points) from how far they reach in a direction.
template <class Support>
Box2 box_from_support(const Affine2& frame, Support support) {
  const Vec2 right{frame.a, frame.c};
  const Vec2 up{frame.b, frame.d};
  return {{frame.e - support(-right), frame.f - support(-up)}, {frame.e + support(right), frame.f + support(up)}};
}

/// An edge that may still reach farther than anything seen.
struct Candidate {
  Vec2 p;
  Vec2 d;
  std::uint32_t state;
};

/// Of all candidates with the same vector and state only the farthest matters. `unit` is the grain of comparison.
std::vector<Candidate> keep_dominant(std::vector<Candidate> candidates, Vec2 direction, double unit) {
  std::map<std::tuple<std::uint32_t, double, double>, Candidate> dominant;
  for (const Candidate& candidate : candidates) {
    const auto key = std::tuple{candidate.state, std::round(candidate.d.x / unit), std::round(candidate.d.y / unit)};
    const auto [at, inserted] = dominant.try_emplace(key, candidate);
    if (!inserted && dot(candidate.p, direction) > dot(at->second.p, direction)) at->second = candidate;
  }
  candidates.clear();
  for (const auto& [key, candidate] : dominant) candidates.push_back(candidate);
  return candidates;
}

/// max of dot(direction, p) over the vertices of S_m.
double support_of(const BaseShape& base, const BlockTables& tables, int levels, Vec2 direction, double size) {
  const double norm = length(direction);
  std::vector<Candidate> candidates;
  double best = -infinity;
  for_each_base_edge(base, [&](Vec2 p, Vec2 q, std::uint64_t edge) {
    best = std::max({best, dot(direction, p), dot(direction, q)});
    candidates.push_back({p, q - p, tables.automaton.start(edge)});
  });
  for (int level = 0; level < levels && !candidates.empty(); ++level) {
    std::vector<Candidate> children;
    double longest = 0.0;
    for (const Candidate& parent : candidates) {
      const double slack = tables.reach * length(parent.d) * norm;
      if (slack <= rounding_share * size * norm || dot(direction, parent.p + 0.5 * parent.d) + slack <= best) continue;
      const Automaton::State& state = tables.automaton.states[parent.state];
      for (std::size_t j = 0; j < state.children.size(); ++j) {
        const Vec2 p = parent.p + complex_product(state.vertices[j], parent.d);
        const Vec2 d = complex_product(state.vertices[j + 1] - state.vertices[j], parent.d);
        best = std::max(best, dot(direction, p));
        longest = std::max(longest, length(d));
        children.push_back({p, d, state.children[j]});
      }
    }
    constexpr double grain = 0x1p-36;
    candidates =
        longest > 0.0 ? keep_dominant(std::move(children), direction, longest * grain) : std::vector<Candidate>{};
  }
  return best;
}

/// An edge of the general rule, the most promising first.
struct Branch {
  double promise;  ///< nothing below it reaches farther
  Vec2 p;
  Vec2 q;
  std::uint64_t edge;
  int level;
  bool operator<(const Branch& other) const { return promise < other.promise; }
};

/// The same for the general rule, best first. After a million edges the promise of what is left is taken as it is: too
/// large by no more than the slack then reached.
double support_of(const BaseShape& base, const KeyedRule& rule, int levels, Vec2 direction, double size) {
  constexpr int most_branches = 1'000'000;
  const double norm = length(direction);
  std::priority_queue<Branch> branches;
  double best = -infinity;
  const auto add = [&](Vec2 p, Vec2 q, std::uint64_t edge, int level) {
    best = std::max({best, dot(direction, p), dot(direction, q)});
    const double slack = rule.reach(level, distance(p, q)) * norm;
    const double overhang = rule.detail(level, distance(p, q)) * norm;
    const double ends = std::max(dot(direction, p), dot(direction, q));
    // Absolute offsets hang over the edge itself, relative ones over its midpoint.
    const double promise = std::min(dot(direction, 0.5 * (p + q)) + slack, ends + overhang);
    if (level < levels && overhang > rounding_share * size * norm && promise > best) {
      branches.push({promise, p, q, edge, level});
    }
  };
  for_each_base_edge(base, [&](Vec2 p, Vec2 q, std::uint64_t edge) { add(p, q, edge, 0); });
  std::vector<Vec2> path;
  for (int visited = 0; !branches.empty(); ++visited) {
    const Branch branch = branches.top();
    if (branch.promise <= best) break;
    if (visited == most_branches) return branch.promise;
    branches.pop();
    rule.path(branch.p, branch.q, branch.level + 1, branch.edge, path);
    for (std::size_t j = 0; j + 1 < path.size(); ++j) {
      add(path[j], path[j + 1], branch.edge * (path.size() - 1) + j, branch.level + 1);
    }
  }
  return best;
}

template <class Rule>
Box2 box_of(const BaseShape& base, const Rule& rule, int levels, const Affine2& frame) {
  const Box2 box = base_box(base);
  const double size = std::max({box.width(), box.height(), std::numeric_limits<double>::min()});
  return box_from_support(frame, [&](Vec2 direction) { return support_of(base, rule, levels, direction, size); });
}

}  // namespace

std::optional<Box2> bounds(const BaseShape& base, const BlockTables& tables, int levels, const Affine2& frame) {
  if (!std::isfinite(tables.reach)) return std::nullopt;
  return box_of(base, tables, levels, frame);
}

std::optional<Box2> bounds(const BaseShape& base, const KeyedRule& rule, int levels, const Affine2& frame) {
  if (!std::isfinite(rule.detail(0, 1.0))) return std::nullopt;
  return box_of(base, rule, levels, frame);
}

}  // namespace burin::curves::two_point
