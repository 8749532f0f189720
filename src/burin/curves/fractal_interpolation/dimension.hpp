#pragma once

#include <optional>
#include <vector>

#include <burin/curves/fractal_interpolation/interpolant.hpp>
#include <burin/curves/limit_facts.hpp>

/// Box dimensions of graphs. Upper bounds always hold; lower ones need rough data, which growth_certificate proves.
/// Source: reference interpolation 6.
namespace burin::curves::fractal_interpolation {

/// Whether all intervals are equally long (to 1e-9), which the dimensions below need but for `constant_dimension`.
bool has_equal_intervals(const Interpolant& f);

/// D of sum |s_i| a_i^(D-1) = 1; 1 when sum |s_i| <= 1. For constant factors: |s_i| is taken at theta = 1/2.
double constant_dimension(const Interpolant& f);

/// 1 + log_n of the sum of min |s_i| and of max |s_i|: the paper's Theorem 3. Pre: equal intervals.
DimensionBounds separate_bounds(const Interpolant& f);

/// 1 + log_n of the minimum and maximum of the sum of |s_i|: sharper. Pre: equal intervals.
DimensionBounds joint_bounds(const Interpolant& f);

/// 1 + log_n of the spectral radius of (A g)(x) = sum |s_i(x)| g(L_i(x)), by power iteration. Pre: equal intervals.
double spectral_dimension(const Interpolant& f);

/// O_m, the sum of the oscillations of phi over the n^m cells of level m, for m = 0 .. levels; each from n^depth points
/// of the cell. Pre: equal intervals, depth >= 1.
std::vector<double> oscillation_sums(const Interpolant& f, int levels, int depth = 3);

/// The smallest m <= levels whose O_m proves the lower bound of `separate_bounds`; nothing when none does, or when it
/// would take more than a quarter of a million points. Pre: equal intervals.
std::optional<int> growth_certificate(const Interpolant& f, int levels = 7);

/// 1 + log_n of O_(m+1) / O_m for the largest m that takes at most a quarter of a million points; nothing when that is
/// not even m = 0, or when nothing oscillates. Pre: equal intervals.
std::optional<double> oscillation_dimension(const Interpolant& f);

/// What is proven and measured of a graph, and its spectral dimension, which intervals of different lengths have for
/// constant scaling only.
FractalDimension graph_dimension(const Interpolant& f);

/// D <= 2 of sum max(S^x_i, S^y_i, a_i)^D = 1, which covers the plane curve (x(t), y(t)) by its images. Pre: both have
/// the same intervals.
double contour_dimension_bound(const Interpolant& x, const Interpolant& y);

}  // namespace burin::curves::fractal_interpolation
