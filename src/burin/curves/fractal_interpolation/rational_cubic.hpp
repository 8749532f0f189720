#pragma once

#include <burin/curves/fractal_interpolation/interval.hpp>

/// The rational cubic that interpolates values and derivatives at both ends of an interval. Its local coordinate theta
/// runs from 0 to 1. Source: Song, Yang, Jiang, Bao, Zhang (2021); reference interpolation 1.
namespace burin::curves::fractal_interpolation {

/// Shape parameters, both >= 0. At alpha = beta = 3 the cubic is Hermite's polynomial, towards infinity a straight
/// line.
struct Shape {
  double alpha = 3.0;
  double beta = 3.0;
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// What each end adds to the cubic: w1 + w2 = 1, w3 >= 0 >= w4.
struct Weights {
  double left;         ///< w1, of the left value
  double right;        ///< w2, of the right value
  double left_slope;   ///< w3, of the left derivative times the interval's length
  double right_slope;  ///< w4, of the right one
};

/// The weights at theta in [0, 1].
Weights weights_at(double theta, Shape shape);

/// Their derivatives by theta.
Weights weight_slopes_at(double theta, Shape shape);

/// Values at both ends of an interval, and derivatives there by theta (that is, times the interval's length).
struct EndData {
  double left = 0.0;
  double right = 0.0;
  double left_slope = 0.0;
  double right_slope = 0.0;
};

inline double combine(const Weights& w, const EndData& ends) {
  return w.left * ends.left + w.right * ends.right +
         (w.left_slope * ends.left_slope + w.right_slope * ends.right_slope);
}

/// An interval that holds the values of the cubic over theta in `over`, a part of [0, 1]; the tighter the shorter
/// `over` is. By the convex hull of the control points of that part.
Interval value_range(const EndData& ends, Shape shape, Interval over);

/// A bound of |d/dtheta| of the cubic on [0, 1], at most 2 percent above the true maximum. By branch and bound on the
/// derivative's control points.
double slope_bound(const EndData& ends, Shape shape);

}  // namespace burin::curves::fractal_interpolation
