#pragma once

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include <burin/curves/subdivision/control.hpp>
#include <burin/curves/subdivision/scheme.hpp>
#include <burin/geom/box2.hpp>

namespace burin::curves::subdivision {

/// How far a curve reaches in a direction: at least `reached`, by a point of it, and at most `bound`.
struct Support {
  double reached = -std::numeric_limits<double>::infinity();
  double bound = -std::numeric_limits<double>::infinity();
};

/// Farthest first: halves the piece that may still reach farther than any point seen, until none is left but for
/// `rounding` or after so many halvings. `size` is that of the curve.
template <class S>
class SupportSearch {
 public:
  SupportSearch(const S& scheme, int levels, Vec2 direction, double size)
      : scheme_(scheme), levels_(levels), direction_(direction), grain_(rounding_share * size * length(direction)) {}

  void add_point(Vec2 p) { best_ = std::max(best_, dot(direction_, p)); }

  void add_piece(const PieceOf<S, Vec2>& piece) {
    if (piece.level == levels_) return add_point(piece.window[S::start]);
    const Cover<Vec2> cover = scheme_.cover(piece, levels_ - piece.level);
    const double slack = cover.radius * length(direction_);
    const double promise = std::max(dot(direction_, cover.a), dot(direction_, cover.b)) + slack;
    // Not "promise > best": a bound that is not a number bounds nothing.
    if (!(promise <= best_)) branches_.push({promise, slack, piece});
  }

  Support result() {
    for (int halvings = 0; !branches_.empty() && !(branches_.top().promise <= best_); ++halvings) {
      const Branch branch = branches_.top();
      if (halvings == most_halvings) return {best_, branch.promise};
      branches_.pop();
      const bool is_done = branch.slack <= grain_;
      // A point of the last level takes time to find: only where it promises to be the farthest yet.
      if (is_done || dot(direction_, branch.piece.window[S::start]) > best_) {
        add_point(start_of(scheme_, branch.piece, levels_));
      }
      if (is_done) continue;
      const auto fresh = refined(scheme_, branch.piece);
      add_piece(half_of<S>(branch.piece, fresh, Half::left));
      add_piece(half_of<S>(branch.piece, fresh, Half::right));
    }
    return {best_, best_};
  }

 private:
  struct Branch {
    double promise;  ///< no point of the piece reaches farther
    double slack;
    PieceOf<S, Vec2> piece;
    bool operator<(const Branch& other) const { return promise < other.promise; }
  };

  /// A slack below this share of the curve's size is rounding.
  static constexpr double rounding_share = 1e-13;
  static constexpr int most_halvings = 100'000;

  const S& scheme_;
  int levels_;
  Vec2 direction_;
  double grain_;
  double best_ = -std::numeric_limits<double>::infinity();
  std::priority_queue<Branch> branches_;
};

/// Pre: the curve has a point.
template <class S>
Support support_of(const S& scheme, const std::vector<Control<Vec2>>& parts, int levels, Vec2 direction, double size) {
  SupportSearch<S> search(scheme, levels, direction, size);
  for (const Control<Vec2>& control : parts) {
    for (const Vec2 p : points_before(scheme, control, levels)) search.add_point(p);
    for (const Vec2 p : points_after(scheme, control, levels)) search.add_point(p);
    for (std::size_t i = 0; i < piece_count<S>(control); ++i) search.add_piece(piece_at<S>(control, i));
  }
  return search.result();
}

}  // namespace burin::curves::subdivision
