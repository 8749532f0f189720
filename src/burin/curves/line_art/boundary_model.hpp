#pragma once

#include <cstdint>
#include <vector>

#include <burin/curves/line_art/ends.hpp>
#include <burin/curves/line_art/line_art.hpp>

namespace burin::curves::line_art {

/// Makes the polylines of the second model; each is a function of (parameters, seed, its number).
class BoundaryModel {
 public:
  static constexpr Meet meet = Meet::drop;

  /// `params` must outlive the model.
  BoundaryModel(const LineArtBoundaryParams& params, std::uint64_t seed);

  int line_count() const { return params_.lines; }
  const Composition& composition() const { return params_.compose; }
  /// Whether every polyline stays within reach().
  bool has_known_counts() const { return !wander_; }
  /// Points of every line, before it is smoothed.
  std::size_t point_count(std::uint64_t line) const;
  /// Holds every polyline, generously. Pre: has_known_counts().
  Box2 reach() const;
  /// Replaces `points` by the polyline, from its place in `from` to its place in `to`, both exact.
  void trace(std::uint64_t line, std::vector<Vec2>& points);
  double depth() const { return 0.0; }

 private:
  void refine(std::uint64_t line, int level, const std::vector<Vec2>& from, std::vector<Vec2>& to) const;

  const LineArtBoundaryParams& params_;
  std::uint64_t seed_;
  Ends<LineArtBoundaryParams> ends_;
  FieldFunction wander_;  ///< an own copy: expressions are not shared between threads
  std::vector<Vec2> spare_;
};

}  // namespace burin::curves::line_art
