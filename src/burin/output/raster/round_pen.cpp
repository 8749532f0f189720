#include <algorithm>
#include <cmath>

#include <burin/output/raster/round_pen.hpp>

namespace burin::output::raster {

namespace {

constexpr double columns_per_unit = 1.0 / 128.996;  // a little too much

/// Half the width of a body along an axis. Samples are whole units away from it and many lie on its border, which this
/// moves away from them: by so little that no row of samples meets body and disc with a sample of neither in between.
double between_units(double half_width) {
  return std::floor(half_width) + 1.0 / 32.0;
}

}  // namespace

RoundStep::RoundStep(Point step_of_segment, double half_width) : step(step_of_segment) {
  const auto dx = static_cast<double>(step.x);
  const auto dy = static_cast<double>(step.y);
  const double squared_length = dx * dx + dy * dy;
  const double length = std::sqrt(squared_length);
  // The direction, per column and per row.
  const double p = column_x * dx + column_y * dy;
  const double q = row_x * dx + row_y * dy;
  const double across_slope = p / q;
  const double along_slope = -q / p;
  // Numbers of 24 bits are exact enough within these limits: 6 roundings of at most slope * extent * 2^-24 columns,
  // which is 0.8/4096.
  const double extent = (length + half_width) * columns_per_unit + 16.0;
  constexpr double most = 512.0;
  suits = std::max(std::abs(across_slope), std::abs(along_slope)) * extent <= most;
  if (!suits) return;

  const bool is_along_axis = step.x == 0 || step.y == 0;
  const double width = is_along_axis ? between_units(half_width) : half_width;
  const double before = is_along_axis ? 0.5 * length : 0.0;
  const double start = -(squared_length + before) / p * fixed_point;
  across = static_cast<float>(across_slope);
  along = static_cast<float>(along_slope);
  side = static_cast<float>(width * length / std::abs(q) * fixed_point);
  low_end = static_cast<float>(std::min(start, 0.0));
  high_end = static_cast<float>(std::max(start, 0.0));

  // A unit or two more than needed cover all rounding.
  const int radius = static_cast<int>(half_width) + 2;
  const int side_x = static_cast<int>(std::abs(dy) * half_width / length) + 2;
  const int side_y = static_cast<int>(std::abs(dx) * half_width / length) + 2;
  left = std::min(-step.x - side_x, -radius);
  right = std::max(-step.x + side_x, radius);
  top = std::min(-step.y - side_y, -radius);
  bottom = std::max(-step.y + side_y, radius);
  if (step.y == 0) {
    half_level = 1e9F;
  } else {
    x_per_y = static_cast<float>(dx / dy);
    half_level = static_cast<float>(half_width * length / std::abs(dy) + 2.0);
  }
}

RoundPen::RoundPen(double half_width_units)
    : half_width(half_width_units), whole_radius(static_cast<int>(half_width_units)) {
  const double squared_unit = fixed_point * fixed_point;
  squared_radius = static_cast<float>(half_width * half_width / squared_step * squared_unit);
  // Rounding of the square shifts the root by less than half a step above this.
  const double radius = half_width * columns_per_unit;
  const double rounding = (8.0 * radius + 48.0) * radius * (squared_unit * 0x1p-24);
  uncertain_below = static_cast<float>(rounding * (rounding + 1.0));
  constexpr double whole_units = squared_step / fixed_point;
  whole_squared_radius = static_cast<float>(half_width * half_width * squared_step);
  whole_uncertain_below = static_cast<float>(rounding * (rounding + 1.0) * (whole_units * whole_units));
}

}  // namespace burin::output::raster
