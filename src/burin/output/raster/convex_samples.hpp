#pragma once

#include <algorithm>
#include <cmath>

#include <burin/output/raster/convex.hpp>

namespace burin::output::raster {

/// The samples of a pixel beside a band: `first` is a x + b y at the one in row and column 0.
struct BandInPixel {
  double first;
  double per_column;
  double per_row;
  double low;
  double high;
};

/// The definition of samples_in(), by two loops over the samples of a pixel, which are the same in doubles to the last
/// bit however they are written: `Loops::in_band(BandInPixel)` and `Loops::in_disc(x0, y0, squared_radius)`, where
/// (x0, y0) is the sample in row and column 0 from the disc's centre.
template <class Loops>
Samples samples_in(const Convex& shape, int i, int j, const Loops& loops) {
  const double x0 = static_cast<double>(std::int64_t{i} * units_per_pixel + sample_x(0, 0) - shape.origin.x);
  const double y0 = static_cast<double>(std::int64_t{j} * units_per_pixel + sample_y(0, 0) - shape.origin.y);
  Samples inside = all_samples;
  for (int k = 0; k < shape.band_count && inside != 0; ++k) {
    const Band& band = shape.bands[static_cast<std::size_t>(k)];
    const BandInPixel here{band.a * x0 + band.b * y0, band.a * column_x + band.b * column_y,
                           band.a * row_x + band.b * row_y, band.low, band.high};
    const double lowest = here.first + 7.0 * std::min(here.per_column, 0.0) + 7.0 * std::min(here.per_row, 0.0);
    const double highest = here.first + 7.0 * std::max(here.per_column, 0.0) + 7.0 * std::max(here.per_row, 0.0);
    if (lowest >= band.low && highest <= band.high) continue;
    inside &= loops.in_band(here);
  }
  if (!shape.has_disc() || inside == 0) return inside;
  const double squared_radius = shape.radius * shape.radius;
  const double far_x = std::max(std::abs(x0), std::abs(x0 + 7.0 * (column_x + row_x)));
  const double far_y = std::max(std::abs(y0 + 7.0 * column_y), std::abs(y0 + 7.0 * row_y));
  if (far_x * far_x + far_y * far_y <= squared_radius) return inside;
  return inside & loops.in_disc(x0, y0, squared_radius);
}

}  // namespace burin::output::raster
