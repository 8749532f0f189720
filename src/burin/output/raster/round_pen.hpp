#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <burin/output/raster/body_table.hpp>
#include <burin/output/raster/convex.hpp>

namespace burin::output::raster {

// In the frame of its samples a pixel is a square grid of step 1, and what is drawn lies in it as on the page.
/// Square of a step of the grid, in units.
inline constexpr double squared_step = column_x * column_x + column_y * column_y;
/// Parts of a column that the vector kernels count bounds in.
inline constexpr double fixed_point = 4096.0;

/// What a segment adds to a stroke with round joins and caps: its body, and the disc about one of its ends. Most
/// strokes of most drawings are made of these, and most of them are short: the kernels have ways of their own for them.
/// What the disc about its other end has besides, a kernel may add or not: the next segment adds it, or the stroke's
/// cap.
struct RoundSegment {
  Point from;
  Point to;  ///< the disc's centre; another point than `from`
};

/// Numbers of all segments with the same step from end to end, for the vector kernels.
struct RoundStep {
  RoundStep() = default;
  /// Pre: the step is not zero.
  RoundStep(Point step_of_segment, double half_width);

  Point step;           ///< zero: none
  bool suits = false;   ///< the numbers are exact enough
  float across = 0.0F;  ///< slope of the sides, in columns per row of samples
  float along = 0.0F;   ///< slope of the ends
  float side = 0.0F;    ///< half the body's width in a row of samples
  float low_end = 0.0F;
  float high_end = 0.0F;
  // What the segment reaches of the page, in units from its end.
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  float x_per_y = 0.0F;     ///< of the segment
  float half_level = 0.0F;  ///< half of what its strip covers of a level line; huge when it is level itself

  /// Then a table would have paid already.
  static constexpr int uses_for_table = 100;
  int uses = 0;
  std::unique_ptr<BodyTable> table;  ///< null: none
};

/// Draws round segments of one width. It keeps what it has computed of the last steps: curves repeat a few.
struct RoundPen {
  explicit RoundPen(double half_width_units);

  double half_width;
  int whole_radius;       ///< the half width without its fraction
  float squared_radius;   ///< in columns of samples, as the vector kernels count them
  float uncertain_below;  ///< a square so small may as well be none
  // Both in the unit in which positions in columns are whole numbers.
  float whole_squared_radius;
  float whole_uncertain_below;
  std::array<RoundStep, 256> steps{};

  /// Where the numbers of a step are kept.
  RoundStep& slot(Point step) {
    const std::uint32_t mix =
        static_cast<std::uint32_t>(step.x) * 0x9E3779B1U + static_cast<std::uint32_t>(step.y) * 0x85EBCA6BU;
    return steps[mix >> 24U];
  }
};

}  // namespace burin::output::raster
