#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/curves/fractal_interpolation/rational_cubic.hpp>
#include <burin/curves/fractal_interpolation/scaling.hpp>
#include <burin/geom/vec2.hpp>

/// The rational fractal interpolation function phi with function scaling: the fixed point of
///   phi(L_i(x)) = s_i(x) (phi(x) - B_i(x)) + P_i(L_i(x))
/// where L_i contracts the whole onto interval i, P_i is the rational cubic of interval i and B_i the one of the whole
/// with the shape of interval i. Source: Song, Yang, Jiang, Bao, Zhang (2021), eq. (6); reference interpolation 1, 5.
namespace burin::curves::fractal_interpolation {

/// What is interpolated: n + 1 nodes with values and derivatives, n intervals with shapes and scalings.
struct InterpolationData {
  std::vector<double> x;
  std::vector<double> values;
  std::vector<double> derivatives;
  std::vector<Shape> shapes;
  std::vector<Scaling> scalings;
};

/// Interval i and its map, which takes (theta, y) to (start + width theta, s(theta) (y - B(theta)) + P(theta)).
struct Piece {
  double start = 0.0;  ///< theta of its left node
  double width = 1.0;  ///< in theta
  EndData ends;        ///< of P
  Shape shape;
  Scaling scaling;
};

/// The interpolant, ready for evaluation. theta = (x - begin) / length runs from 0 to 1.
struct Interpolant {
  double begin = 0.0;
  double length = 1.0;
  EndData whole;              ///< ends of every B
  double gap = 0.0;           ///< |phi - P| is at most this
  std::vector<Piece> pieces;  ///< at least one
};

/// A point of the graph.
struct GraphPoint {
  double theta = 0.0;
  double y = 0.0;
};

/// What keeps data from being interpolated.
struct DataTrouble {
  std::string_view of;  ///< "points", "derivatives", "alpha", "beta" or "scaling"; empty: there is none
  std::string text{};
};

/// Nodes that do not increase, numbers that are not finite, a negative shape parameter, a scaling whose bound is 1 or
/// more: the first of these. Pre: the sizes fit together.
DataTrouble trouble_with(const InterpolationData& data);

/// Pre: trouble_with finds none.
Interpolant make_interpolant(const InterpolationData& data);

/// P_i and B_i at theta of their interval.
inline double own_cubic(const Piece& piece, double theta) {
  return combine(weights_at(theta, piece.shape), piece.ends);
}
inline double whole_cubic(const Interpolant& f, const Piece& piece, double theta) {
  return combine(weights_at(theta, piece.shape), f.whole);
}

/// The map of a piece applied to a point.
inline GraphPoint mapped(const Interpolant& f, const Piece& piece, GraphPoint p) {
  const Weights w = weights_at(p.theta, piece.shape);
  return {piece.start + piece.width * p.theta,
          scaling_at(piece.scaling, p.theta) * (p.y - combine(w, f.whole)) + combine(w, piece.ends)};
}

/// Node k, 0 <= k <= pieces.
GraphPoint node_point(const Interpolant& f, std::size_t k);

/// The piece that holds theta: the right-hand one at a node, the last one at 1. O(log n).
std::size_t piece_at(const Interpolant& f, double theta);

/// P at x: the classical rational spline, phi for s = 0. x is clamped to the nodes' range.
double classical_value(const Interpolant& f, double x);

/// phi at x, clamped to the nodes' range, with a truncation error of at most `tolerance`. A rough phi turns the
/// rounding of x into an error of about eps^tau, tau = min log S_i / log a_i. O(log(1/tolerance) / log(1/S) * log n).
double value_at(const Interpolant& f, double x, double tolerance = 1e-12);

/// The point of the address: node `node` after the maps of `digits`, the last one first. Good to rounding.
GraphPoint point_at(const Interpolant& f, std::span<const std::uint32_t> digits, std::size_t node);

/// Level set m: n^(m+1) + 1 points (x, phi(x)) in increasing x, all exactly on the graph. Level 0: the nodes. Time and
/// memory O(n^(m+1)).
std::vector<Vec2> level_set(const Interpolant& f, int level);

/// `count` points of the graph by random iteration from the first node, x uniformly distributed; splitmix64 from
/// `seed`. For point clouds, not for lines.
std::vector<Vec2> chaos_points(const Interpolant& f, std::size_t count, std::uint64_t seed);

}  // namespace burin::curves::fractal_interpolation
