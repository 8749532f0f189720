#pragma once

#include <string>

#include <burin/burin.hpp>

#include "supersample.hpp"

namespace burin::test {

/// How far the native PNG of black lines of this width is from 32 x 32 samples, in the mean of the inked pixels, of
/// 255.
double difference_of_lines(const std::vector<Line>& lines, double width_px, int side_px);

/// The same of a two-point curve on a square page, with the points that the back end asks for, held against all points.
double difference_of_curve(const std::string& motif, int levels, double width_px, int side_px);

/// The most that is allowed.
inline double most_difference(double width_px) {
  return width_px >= 1.0 ? 4.0 : 6.0;
}

}  // namespace burin::test
