#include <algorithm>

#include <burin/curves/two_point_3d/edge_tree.hpp>
#include <burin/curves/two_point_3d/normals.hpp>

namespace burin::curves::two_point_3d {

namespace {

/// What a draw of theta is for: two-point has 1 for alpha and 2 for beta.
constexpr std::uint64_t theta_purpose = 3;

}  // namespace

EdgeTree::EdgeTree(const TwoPoint3dParams& params, std::uint64_t seed)
    : rule_(params.motif, params.sign, seed),
      reach_(params),
      thetas_(params.theta),
      seed_(seed),
      orient_(params.orient),
      normalize_(params.normalize),
      uses_flags_(params.motif.has_flags() && !params.sign && !params.motif.sign),
      up_(params.up),
      levels_(params.levels),
      polylines_(params.base.lifted()) {
  std::uint64_t edges = 0;
  for (const SpacePolyline& polyline : polylines_) {
    edges_before_.push_back(edges);
    edges += polyline.edge_count();
  }
}

std::vector<Vec3> EdgeTree::after(std::size_t part) const {
  const SpacePolyline& polyline = polylines_[part];
  return polyline.closed ? std::vector<Vec3>{} : std::vector<Vec3>{polyline.points.back()};
}

double EdgeTree::points_asked() const {
  double per_edge = 1.0;
  for (int level = 1; level <= levels_; ++level) {
    per_edge *= static_cast<double>(rule_.child_count(level));
  }
  double points = 0.0;
  for (const SpacePolyline& polyline : polylines_) {
    points += static_cast<double>(polyline.edge_count()) * per_edge + (polyline.closed ? 0.0 : 1.0);
  }
  return points;
}

EdgePiece EdgeTree::root(std::size_t part, std::size_t index) const {
  const SpacePolyline& polyline = polylines_[part];
  const std::size_t count = polyline.points.size();
  const std::size_t edges = polyline.edge_count();
  EdgePiece piece;
  if (!polyline.closed) {
    piece.first = index >= 2 ? 0 : 2 - index;
    piece.last = std::min<std::size_t>(5, count + 1 - index);
  }
  for (std::size_t i = piece.first; i <= piece.last; ++i) {
    piece.window[i] = polyline.points[(index + i + 2 * count - 2) % count];
  }
  for (std::size_t i = 0; i < 3; ++i) piece.edges[i].ordinal = edges_before_[part] + (index + i + edges - 1) % edges;
  return piece;
}

Cover<Vec3> EdgeTree::cover(const EdgePiece& piece) const {
  return reach_.cover(piece.window[2], piece.window[3], levels_ - piece.level, rule_.decay(piece.level + 1));
}

Vec3 EdgeTree::marker(const EdgePiece& piece, std::size_t edge, std::size_t marker) const {
  const auto point = [&](std::size_t i) { return i >= piece.first && i <= piece.last ? &piece.window[i] : nullptr; };
  const EdgeState& state = piece.edges[edge];
  const int level = piece.level + 1;
  const Vec3 a = piece.window[edge + 1];
  const Vec3 b = piece.window[edge + 2];
  const Vec3 d = b - a;
  const std::vector<two_point::Mark>& marks = rule_.motif().marks(level, state.ordinal);
  // Built from the far end, what was last comes first, on the other side.
  const std::size_t j = state.reverse ? marks.size() + 1 - marker : marker;
  auto [alpha, beta] = rule_.place(marks[j - 1], level, state.ordinal, j);
  double theta = thetas_.of(j).at(seed_, {level, state.ordinal, j, theta_purpose});
  if (state.reverse) {
    alpha = 1.0 - alpha;
    theta = 1.0 - theta;
  }
  const double sign = state.flip == state.reverse ? 1.0 : -1.0;
  const double scale = rule_.motif().absolute ? 1.0 : length(d);
  const double factor = sign * rule_.sign_and_decay(level, state.ordinal) * beta * scale;
  const Normals normals = normals_of(point(edge), a, b, point(edge + 3), orient_, up_);
  return a + alpha * d + factor * blend(normals, theta, normalize_);
}

EdgeState EdgeTree::child_state(const EdgeState& parent, std::size_t child, std::size_t child_count) const {
  EdgeState state{parent.ordinal * child_count + child, parent.flip, parent.reverse};
  if (!uses_flags_) return state;
  const std::size_t j = parent.reverse ? child_count - 1 - child : child;
  const auto flag = [&](const std::vector<std::uint8_t>& flags) { return !flags.empty() && flags[j] != 0; };
  state.flip = state.flip != flag(rule_.motif().flip);
  state.reverse = state.reverse != flag(rule_.motif().reverse);
  return state;
}

void EdgeTree::push_children(const EdgePiece& piece, std::vector<EdgePiece>& stack) const {
  const std::size_t k = rule_.child_count(piece.level + 1);
  // The points of the next level from two before the edge to two after it; three edges have k sub-edges each.
  const std::size_t run_first = piece.first <= 1 ? k - 2 : k;
  const std::size_t run_last = piece.last >= 4 ? 2 * k + 2 : 2 * k;
  std::vector<Vec3> run(2 * k + 3);
  for (std::size_t i = run_first; i <= run_last; ++i) {
    run[i] = i % k == 0 ? piece.window[i / k + 1] : marker(piece, i / k, i % k);
  }
  const auto state_at = [&](std::size_t child) { return child_state(piece.edges[child / k], child % k, k); };
  for (std::size_t child = 2 * k; child-- > k;) {
    EdgePiece made;
    const std::size_t begin = child - 2;  // of its window
    made.first = run_first > begin ? run_first - begin : 0;
    made.last = std::min<std::size_t>(5, run_last - begin);
    for (std::size_t i = made.first; i <= made.last; ++i) made.window[i] = run[begin + i];
    made.edges = {state_at(child - 1), state_at(child), state_at(child + 1)};
    made.level = piece.level + 1;
    stack.push_back(made);
  }
}

}  // namespace burin::curves::two_point_3d
