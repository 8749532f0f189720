#pragma once

#include <burin/base/double_double.hpp>

namespace burin::math {

/// An angle as quadrant * 90 degrees + rest, |rest| <= 45 degrees and a little; quadrant is in 0..3.
struct ReducedAngle {
  int quadrant = 0;
  DoubleDouble rest;  ///< in radians, relative error below 2^-70
};

/// Pre: radians is finite. Any magnitude is reduced by the true pi.
ReducedAngle reduce_radians(double radians);
/// Pre: degrees is finite. The whole quadrants are removed exactly.
ReducedAngle reduce_degrees(double degrees);

}  // namespace burin::math
