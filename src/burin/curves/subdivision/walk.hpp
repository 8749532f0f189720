#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <burin/curves/subdivision/scheme.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::subdivision {

/// Walks the refinement of one piece after another, in travel order: emits the start of every piece of the last level.
/// An explicit stack of at most levels + 1 pieces and a block of 2^8 points are all the memory.
template <class S, class Point>
class Walk {
 public:
  Walk(const S& scheme, int levels) : scheme_(scheme), levels_(levels) {}

  /// All points, by runs: emitter.run(span of points).
  template <class Emitter>
  Flow all(const PieceOf<S, Point>& root, Emitter& emitter) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
      const PieceOf<S, Point> piece = stack_.back();
      stack_.pop_back();
      const bool is_inner = !piece.ends.first && !piece.ends.last && !piece.closes;
      if (piece.level == levels_ || (is_inner && levels_ - piece.level <= block_levels)) {
        if (!piece.closes && emitter.run(block(piece)) == Flow::stop) return Flow::stop;
      } else {
        push_halves(piece);
      }
    }
    return Flow::go;
  }

  /// What can be seen: a piece that `sight` hides is emitted as its start alone, a point of the last level like all
  /// others. emitter.point(make), where make() computes the point.
  template <class Sight, class Emitter>
  Flow seen(const PieceOf<S, Point>& root, const Sight& sight, Emitter& emitter) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
      const PieceOf<S, Point> piece = stack_.back();
      stack_.pop_back();
      if (piece.level == levels_ && piece.closes) continue;
      if (piece.level == levels_ || sight.hides(scheme_.cover(piece, levels_ - piece.level))) {
        if (emitter.point([&] { return start_of(scheme_, piece, levels_); }) == Flow::stop) return Flow::stop;
      } else {
        push_halves(piece);
      }
    }
    return Flow::go;
  }

 private:
  /// Levels that are refined in one go, level by level: half the work of piece by piece, for the same bits.
  static constexpr int block_levels = 8;
  static constexpr std::size_t block_points = (std::size_t{1} << block_levels) + S::window - 1;

  void push_halves(const PieceOf<S, Point>& piece) {
    const std::array<Point, S::window + 1> fresh = refined(scheme_, piece);
    stack_.push_back(half_of<S>(piece, fresh, Half::right));
    stack_.push_back(half_of<S>(piece, fresh, Half::left));
  }

  std::span<const Point> block(const PieceOf<S, Point>& piece) {
    Point* old = first_.data();
    Point* fresh = second_.data();
    std::size_t count = S::window;
    for (std::size_t i = 0; i < count; ++i) old[i] = piece.window[i];
    for (int level = piece.level; level < levels_; ++level) {
      scheme_.refine(old, count, fresh);
      count = 2 * count - S::window + 1;
      std::swap(old, fresh);
    }
    return {old + S::start, count - S::window + 1};
  }

  const S& scheme_;
  int levels_;
  std::vector<PieceOf<S, Point>> stack_;
  std::array<Point, block_points> first_;
  std::array<Point, block_points> second_;
};

}  // namespace burin::curves::subdivision
