#pragma once

namespace burin::curves {

/// What is known of a piece of a curve before it is refined: every point of it at the last level, both ends included,
/// is within `radius` of the segment ab, and within `error` of the chord between its ends.
template <class Point>
struct Cover {
  Point a;
  Point b;
  double radius;
  double error;
};

}  // namespace burin::curves
