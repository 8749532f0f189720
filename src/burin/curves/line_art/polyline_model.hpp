#pragma once

#include <cstdint>
#include <vector>

#include <burin/curves/line_art/line_art.hpp>

namespace burin::curves::line_art {

/// Makes the polylines of the first model; each is a function of (parameters, seed, its number).
class PolylineModel {
 public:
  static constexpr Meet meet = Meet::end;

  /// `params` must outlive the model.
  PolylineModel(const LineArtParams& params, std::uint64_t seed);

  int line_count() const { return params_.line_count(); }
  const Composition& composition() const { return params_.compose; }
  /// Whether every polyline has the points that its draw asks for.
  bool has_known_counts() const { return !flow_ && !stretch_; }
  /// Points of a line, before it is smoothed; with flow or stretch an upper bound.
  std::size_t point_count(std::uint64_t line) const;
  /// Holds every polyline, generously. Pre: has_known_counts().
  Box2 reach() const;
  /// Replaces `points` by the polyline; a single point when it ends at once.
  void trace(std::uint64_t line, std::vector<Vec2>& points) const;
  double depth() const { return 0.0; }

 private:
  struct Walk;
  Vec2 start_of(std::uint64_t line) const;
  double first_heading(std::uint64_t line, const Spot& spot) const;
  void grow(Walk walk, std::size_t first_segment, std::size_t end_segment, std::vector<Vec2>& points) const;

  const LineArtParams& params_;
  std::uint64_t seed_;
  FieldFunction flow_;  ///< own copies: expressions are not shared between threads
  FieldFunction stretch_;
};

}  // namespace burin::curves::line_art
