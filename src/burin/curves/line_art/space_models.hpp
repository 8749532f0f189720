#pragma once

#include <cstdint>
#include <vector>

#include <burin/curves/line_art/ends.hpp>
#include <burin/curves/line_art/line_art_3d.hpp>
#include <burin/curves/line_art/seen_in_space.hpp>

namespace burin::curves::line_art {

/// Makes the polylines of the first model in space; each is a function of (parameters, seed, its number).
class SpacePolylineModel {
 public:
  static constexpr Meet meet = Meet::end;

  /// `params` must outlive the model.
  SpacePolylineModel(const LineArt3dParams& params, std::uint64_t seed);

  int line_count() const { return params_.lines; }
  const Composition& composition() const { return params_.compose; }
  /// Whether no polyline can come behind the eye.
  bool has_known_counts() const { return !is_unbounded(reach()); }
  std::size_t point_count(std::uint64_t line) const;
  /// Holds the picture of every polyline, generously.
  Box2 reach() const;
  /// Replaces `points` by the picture of the polyline.
  void trace(std::uint64_t line, std::vector<Vec2>& points);
  double depth() const { return depth_; }

 private:
  Vec3 first_heading(std::uint64_t line) const;

  const LineArt3dParams& params_;
  std::uint64_t seed_;
  Camera camera_;
  double depth_ = 0.0;
  std::vector<Vec3> polyline_;
};

/// Makes the polylines of the second model in space; each is a function of (parameters, seed, its number).
class SpaceBoundaryModel {
 public:
  static constexpr Meet meet = Meet::drop;

  /// `params` must outlive the model.
  SpaceBoundaryModel(const LineArtBoundary3dParams& params, std::uint64_t seed);

  int line_count() const { return params_.lines; }
  const Composition& composition() const { return params_.compose; }
  /// Whether no polyline can come behind the eye.
  bool has_known_counts() const { return !is_unbounded(reach()); }
  std::size_t point_count(std::uint64_t line) const;
  /// Holds the picture of every polyline, generously.
  Box2 reach() const;
  /// Replaces `points` by the picture of the polyline; by nothing if it comes behind the eye.
  void trace(std::uint64_t line, std::vector<Vec2>& points);
  double depth() const { return depth_; }

 private:
  void refine(std::uint64_t line, int level, const std::vector<Vec3>& from, std::vector<Vec3>& to) const;

  const LineArtBoundary3dParams& params_;
  std::uint64_t seed_;
  Ends<LineArtBoundary3dParams> ends_;
  Camera camera_;
  double depth_ = 0.0;
  std::vector<Vec3> polyline_;
  std::vector<Vec3> spare_;
};

}  // namespace burin::curves::line_art
