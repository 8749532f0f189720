#pragma once

#include <span>
#include <vector>

#include <burin/curves/fractal_interpolation/interpolant.hpp>

/// Guaranteed bounds of a fractal interpolant. Source: reference interpolation 4, 5.
namespace burin::curves::fractal_interpolation {

/// The largest bound of |s_i|.
double largest_scaling(const Interpolant& f);

/// How far from the middle m of the nodes' values P and every B stay: |P - m| <= own, |B_i - m| <= whole.
struct Spans {
  double middle = 0.0;
  double own = 0.0;
  double whole = 0.0;
};
Spans spans(const Interpolant& f);

/// E with |phi - P| <= E.
double gap_bound(const Interpolant& f);

/// How much interval i's map stretches: |phi(L_i x) - phi(L_i y)| <= scaling |phi(x) - phi(y)| + drift |x - y| with
/// x, y in theta; `drift` = scaling_slope sup|phi - B_i| + scaling whole_slope + own_slope.
struct Stretch {
  double scaling = 0.0;        ///< sup |s_i|
  double scaling_slope = 0.0;  ///< Lip s_i
  double whole_slope = 0.0;    ///< Lip B_i
  double own_slope = 0.0;      ///< Lip P_i
  double drift = 0.0;
};
std::vector<Stretch> stretches(const Interpolant& f);

/// R with |phi - polyline through level set m| <= R for m = 0 .. levels. Safe but loose: a guarantee, no estimate.
std::vector<double> level_bounds(const Interpolant& f, int levels);

/// A bound of |phi - phi*| where phi* has values moved by dv and derivatives by dd, all else equal.
double stability_bound(const Interpolant& f, std::span<const double> dv, std::span<const double> dd);

}  // namespace burin::curves::fractal_interpolation
