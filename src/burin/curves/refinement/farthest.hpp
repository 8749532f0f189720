#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include <burin/curves/refinement/cover.hpp>
#include <burin/curves/refinement/lens.hpp>

namespace burin::curves {

/// How far a curve reaches: at least `reached`, by a point of it, and at most `bound`.
struct Farthest {
  double reached = -std::numeric_limits<double>::infinity();
  double bound = -std::numeric_limits<double>::infinity();
};

/// What the points of a piece may reach, and how much of that is doubt.
struct Promise {
  double bound;
  double slack;
};

/// How far the picture reaches in a direction.
template <class Lens>
struct PictureReach {
  const Lens& lens;
  Vec2 direction;

  template <class Point>
  double of(const Point& p) const {
    return dot(direction, lens.picture(p));
  }
  template <class Point>
  Promise of(const Cover<Point>& cover) const {
    const double norm = length(direction);
    const double a = of(cover.a);
    const double b = of(cover.b);
    const double slack_a = norm * lens.picture_radius(cover.a, cover.radius);
    const double slack_b = norm * lens.picture_radius(cover.b, cover.radius);
    return {std::max(a + slack_a, b + slack_b), std::max(slack_a, slack_b)};
  }
};

/// How near a curve comes to the plane through the eye: farthest where its depth is least.
struct Nearness {
  const SpaceLens& lens;

  double of(Vec3 p) const { return -lens.depth(p); }
  Promise of(const Cover<Vec3>& cover) const {
    return {std::max(of(cover.a), of(cover.b)) + cover.radius, cover.radius};
  }
};

/// Farthest first: splits the piece that may still reach farther than any point seen, until none is left but for
/// `grain` or after so many splits. Any measure of points and covers will do.
template <class Tree, class Measure>
class FarthestSearch {
 public:
  FarthestSearch(const Tree& tree, const Measure& measure, double grain)
      : tree_(tree), measure_(measure), grain_(grain) {}

  void add_point(const typename Tree::Point& p) { best_ = std::max(best_, measure_.of(p)); }

  void add_piece(const typename Tree::Node& piece) {
    if (tree_.is_last(piece)) return add_point(tree_.start(piece));
    const Promise promise = measure_.of(tree_.cover(piece));
    // Not "bound > best": a bound that is not a number bounds nothing.
    if (!(promise.bound <= best_)) branches_.push({promise, piece});
  }

  Farthest result() {
    for (int splits = 0; !branches_.empty() && !(branches_.top().promise.bound <= best_); ++splits) {
      const Branch branch = branches_.top();
      if (splits == most_splits) return {best_, branch.promise.bound};
      branches_.pop();
      const bool is_done = branch.promise.slack <= grain_;
      // A point of the last level takes time to find: only where it promises to be the farthest yet.
      if (is_done || measure_.of(tree_.first_guess(branch.piece)) > best_) add_point(tree_.start(branch.piece));
      if (is_done) continue;
      children_.clear();
      tree_.push_children(branch.piece, children_);
      for (const typename Tree::Node& child : children_) add_piece(child);
    }
    return {best_, best_};
  }

 private:
  struct Branch {
    Promise promise;
    typename Tree::Node piece;
    bool operator<(const Branch& other) const { return promise.bound < other.promise.bound; }
  };

  static constexpr int most_splits = 100'000;

  const Tree& tree_;
  const Measure& measure_;
  double grain_;
  double best_ = -std::numeric_limits<double>::infinity();
  std::priority_queue<Branch> branches_;
  std::vector<typename Tree::Node> children_;
};

/// Pre: the curve has a point.
template <class Tree, class Measure>
Farthest farthest_of(const Tree& tree, const Measure& measure, double grain) {
  FarthestSearch<Tree, Measure> search(tree, measure, grain);
  for (std::size_t part = 0; part < tree.part_count(); ++part) {
    for (const auto& p : tree.before(part)) search.add_point(p);
    for (const auto& p : tree.after(part)) search.add_point(p);
    for (std::size_t i = 0; i < tree.root_count(part); ++i) search.add_piece(tree.root(part, i));
  }
  return search.result();
}

}  // namespace burin::curves
