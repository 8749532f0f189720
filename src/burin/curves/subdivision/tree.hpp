#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <burin/curves/subdivision/control.hpp>
#include <burin/curves/subdivision/scheme.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::subdivision {

/// The curve of a scheme as a tree of pieces, each the parent of its two halves: see refinement/curve.hpp.
template <class S, class PointType>
class SchemeTree {
 public:
  using Point = PointType;
  using Node = PieceOf<S, Point>;

  SchemeTree(S scheme, std::vector<Control<Point>> parts, int levels)
      : scheme_(std::move(scheme)), parts_(std::move(parts)), levels_(levels) {}

  int levels() const { return levels_; }
  std::size_t part_count() const { return parts_.size(); }
  bool is_closed(std::size_t part) const { return parts_[part].closed; }
  const std::vector<Point>& base(std::size_t part) const { return parts_[part].points; }
  std::vector<Point> before(std::size_t part) const { return points_before(scheme_, parts_[part], levels_); }
  std::vector<Point> after(std::size_t part) const { return points_after(scheme_, parts_[part], levels_); }
  std::size_t root_count(std::size_t part) const { return piece_count<S>(parts_[part]); }
  Node root(std::size_t part, std::size_t index) const { return piece_at<S>(parts_[part], index); }
  double points_asked() const {
    double points = 0.0;
    for (const Control<Point>& control : parts_) points += points_at_level<S>(control, levels_);
    return points;
  }

  bool is_last(const Node& piece) const { return piece.level == levels_; }
  bool is_silent(const Node& piece) const { return piece.closes; }
  Cover<Point> cover(const Node& piece) const { return scheme_.cover(piece, levels_ - piece.level); }
  Point start(const Node& piece) const { return start_of(scheme_, piece, levels_); }
  Point first_guess(const Node& piece) const { return piece.window[S::start]; }
  void push_children(const Node& piece, std::vector<Node>& stack) const {
    const std::array<Point, S::window + 1> fresh = refined(scheme_, piece);
    stack.push_back(half_of<S>(piece, fresh, Half::right));
    stack.push_back(half_of<S>(piece, fresh, Half::left));
  }

  /// All points, by runs. An explicit stack of at most levels + 1 pieces and a block of 2^8 points are all the memory.
  class Runs {
   public:
    explicit Runs(const SchemeTree& tree) : tree_(tree) {}

    template <class Emitter>
    Flow emit(const Node& root, Emitter& emitter) {
      stack_.assign(1, root);
      while (!stack_.empty()) {
        const Node piece = stack_.back();
        stack_.pop_back();
        const bool is_inner = !piece.ends.first && !piece.ends.last && !piece.closes;
        if (tree_.is_last(piece) || (is_inner && tree_.levels_ - piece.level <= block_levels)) {
          if (!piece.closes && emitter.run(block(piece)) == Flow::stop) return Flow::stop;
        } else {
          tree_.push_children(piece, stack_);
        }
      }
      return Flow::go;
    }

   private:
    /// Levels that are refined in one go, level by level: half the work of piece by piece, for the same bits.
    static constexpr int block_levels = 8;
    static constexpr std::size_t block_points = (std::size_t{1} << block_levels) + S::window - 1;

    std::span<const Point> block(const Node& piece) {
      Point* old = first_.data();
      Point* fresh = second_.data();
      std::size_t count = S::window;
      for (std::size_t i = 0; i < count; ++i) old[i] = piece.window[i];
      for (int level = piece.level; level < tree_.levels_; ++level) {
        tree_.scheme_.refine(old, count, fresh);
        count = 2 * count - S::window + 1;
        std::swap(old, fresh);
      }
      return {old + S::start, count - S::window + 1};
    }

    const SchemeTree& tree_;
    std::vector<Node> stack_;
    std::array<Point, block_points> first_;
    std::array<Point, block_points> second_;
  };

 private:
  S scheme_;
  std::vector<Control<Point>> parts_;
  int levels_;
};

}  // namespace burin::curves::subdivision
