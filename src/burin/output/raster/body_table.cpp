#include <algorithm>
#include <cmath>

#include <burin/output/raster/body_table.hpp>
#include <burin/output/raster/convex.hpp>

namespace burin::output::raster {

bool BodyTable::suits(Point step, double half_width) {
  constexpr double most_length = 2.5 * units_per_pixel;
  constexpr double most_half_width = 1.5 * units_per_pixel;
  // Rounded up by a unit or two, and beginning anywhere in a pixel.
  static_assert(most_length + 2.0 * most_half_width + 4.0 <= (most_pixels - 1) * units_per_pixel);
  return std::abs(step.x) + std::abs(step.y) <= most_length && half_width <= most_half_width;
}

BodyTable::BodyTable(Point step, double half_width) {
  const Convex shape = segment_body(Point{} - step, {}, half_width);
  const Band& sides = shape.bands[0];
  const Band& ends = shape.bands[1];
  body = {static_cast<int>(std::floor(shape.left)), static_cast<int>(std::floor(shape.top)),
          static_cast<int>(std::ceil(shape.right)), static_cast<int>(std::ceil(shape.bottom))};
  const int radius = static_cast<int>(half_width);
  all = {std::min(body.left, -radius), std::min(body.top, -radius), std::max(body.right, radius),
         std::max(body.bottom, radius)};
  const PixelBox corners{body.left - units_per_pixel, body.top - units_per_pixel, body.right, body.bottom};
  across = BandTable({-step.y, step.x, sides.low, sides.high}, corners);
  along = BandTable({step.x, step.y, ends.low - ends.high, 0.0}, corners);
}

}  // namespace burin::output::raster
