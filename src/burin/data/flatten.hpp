#pragma once

#include <vector>

#include <burin/geom/vec2.hpp>

/// Curves of SVG paths as chords. Each function appends the points after the curve's start to `points`, the last one
/// exactly the curve's end. No chord is farther than `tolerance` from its curve, unless that would take more than
/// max_chords of them: then that many, which is within a millionth of the curve's size. Pre: finite, |coordinate| <=
/// 1e18; any tolerance, 0 too. O(chords).
namespace burin::data {

inline constexpr int max_chords = 1024;

void flatten_quadratic(Vec2 start, Vec2 control, Vec2 end, double tolerance, std::vector<Vec2>& points);

void flatten_cubic(Vec2 start, Vec2 control_1, Vec2 control_2, Vec2 end, double tolerance, std::vector<Vec2>& points);

/// An elliptical arc as SVG writes it: radii, the turn of the first axis, and which of the four arcs.
struct EllipticArc {
  Vec2 radii;
  double turn_degrees = 0.0;
  bool large = false;
  bool sweep = false;
};

/// Radii that are too small are scaled up, a radius of 0 (or below 1e-100) gives a straight line, an arc that ends
/// where it starts gives nothing. Source: SVG 1.1, appendix F.6.
void flatten_arc(Vec2 start, const EllipticArc& arc, Vec2 end, double tolerance, std::vector<Vec2>& points);

}  // namespace burin::data
