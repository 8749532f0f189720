#include <algorithm>
#include <cmath>

#include <burin/output/raster/convex.hpp>
#include <burin/output/raster/convex_samples.hpp>

namespace burin::output::raster {

namespace {

struct Direction {
  double x;
  double y;
  double length;
};

Direction direction_of(Point p) {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return {x, y, std::sqrt(x * x + y * y)};
}

/// How far to the side of a segment, and how far along it, both times its length.
Band across(const Direction& d, double low, double high) {
  return {-d.y, d.x, low, high};
}
Band along(const Direction& d, double low, double high) {
  return {d.x, d.y, low, high};
}

/// The part of a band of a segment's width from `low` to `high`, measured along the segment in units.
Convex strip(Point a, const Direction& d, double half_width, double low, double high) {
  Convex shape;
  shape.origin = a;
  shape.bands[0] = across(d, -half_width * d.length, half_width * d.length);
  shape.bands[1] = along(d, low * d.length, high * d.length);
  shape.band_count = 2;
  const double ux = d.x / d.length;
  const double uy = d.y / d.length;
  const double side_x = half_width * std::abs(uy) + 1.0;  // one unit covers all rounding
  const double side_y = half_width * std::abs(ux) + 1.0;
  shape.left = a.x + std::min(low * ux, high * ux) - side_x;
  shape.right = a.x + std::max(low * ux, high * ux) + side_x;
  shape.top = a.y + std::min(low * uy, high * uy) - side_y;
  shape.bottom = a.y + std::max(low * uy, high * uy) + side_y;
  return shape;
}

void set_borders_around_origin(Convex& shape, double reach) {
  shape.left = shape.origin.x - reach - 1.0;
  shape.right = shape.origin.x + reach + 1.0;
  shape.top = shape.origin.y - reach - 1.0;
  shape.bottom = shape.origin.y + reach + 1.0;
}

/// The wedge between the end of one stroke and the start of the next: on the outer side of the corner only.
Convex wedge(Point corner, const Direction& in, const Direction& out) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Convex shape;
  shape.origin = corner;
  shape.bands[0] = along(in, 0.0, infinity);
  shape.bands[1] = along(out, -infinity, 0.0);
  shape.band_count = 2;
  return shape;
}

/// One sample after the other.
struct EachSample {
  static Samples in_band(const BandInPixel& band) {
    Samples within = 0;
    for (int row = 0; row < 8; ++row) {
      const double start = band.first + row * band.per_row;
      for (int column = 0; column < 8; ++column) {
        const double value = start + column * band.per_column;
        const bool in = (value >= band.low) & (value <= band.high);
        within |= Samples{in} << static_cast<unsigned>(8 * row + column);
      }
    }
    return within;
  }

  static Samples in_disc(double x0, double y0, double squared_radius) {
    Samples within = 0;
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 8; ++column) {
        const double x = x0 + column * column_x + row * row_x;
        const double y = y0 + column * column_y + row * row_y;
        const bool in = x * x + y * y <= squared_radius;
        within |= Samples{in} << static_cast<unsigned>(8 * row + column);
      }
    }
    return within;
  }
};

int pixel_of(double units, int low, int high) {
  return static_cast<int>(
      std::floor(std::clamp(units * (1.0 / units_per_pixel), static_cast<double>(low), static_cast<double>(high))));
}

}  // namespace

Convex segment_body(Point a, Point b, double half_width, double before, double after) {
  const Direction d = direction_of(b - a);
  Convex shape = strip(a, d, half_width, -before * half_width, d.length + after * half_width);
  // Exactly, where no cap is asked for.
  if (after == 0.0) shape.bands[1].high = d.x * d.x + d.y * d.y;
  return shape;
}

Convex square_cap(Point a, Point b, double half_width) {
  return strip(b, direction_of(b - a), half_width, 0.0, half_width);
}

Convex disc(Point center, double radius) {
  Convex shape;
  shape.origin = center;
  shape.radius = radius;
  set_borders_around_origin(shape, radius);
  return shape;
}

Convex square(Point center, Vec2 direction, double half_side) {
  return strip(center, {direction.x, direction.y, length(direction)}, half_side, -half_side, half_side);
}

Convex join_sector(Point corner, Point in, Point out, double radius) {
  Convex shape = wedge(corner, direction_of(in), direction_of(out));
  shape.radius = radius;
  set_borders_around_origin(shape, radius);
  return shape;
}

Convex join_bevel(Point corner, Point in, Point out, double half_width) {
  const Direction d = direction_of(in);
  const Direction e = direction_of(out);
  Convex shape = wedge(corner, d, e);
  const double side = d.x * e.y - d.y * e.x > 0.0 ? 1.0 : -1.0;  // the outer one
  const double x = side * (d.y / d.length + e.y / e.length);
  const double y = -side * (d.x / d.length + e.x / e.length);
  const double cosine = (d.x * e.x + d.y * e.y) / (d.length * e.length);
  shape.bands[2] = {x, y, -std::numeric_limits<double>::infinity(), half_width * (1.0 + cosine)};
  shape.band_count = 3;
  set_borders_around_origin(shape, half_width);
  return shape;
}

Convex join_miter(Point corner, Point in, Point out, double half_width) {
  const Direction d = direction_of(in);
  const Direction e = direction_of(out);
  Convex shape = wedge(corner, d, e);
  shape.bands[2] = across(d, -half_width * d.length, half_width * d.length);
  shape.bands[3] = across(e, -half_width * e.length, half_width * e.length);
  shape.band_count = 4;
  const double cosine = (d.x * e.x + d.y * e.y) / (d.length * e.length);
  set_borders_around_origin(shape, half_width * std::sqrt(2.0 / (1.0 + cosine)));
  return shape;
}

Samples samples_in(const Convex& shape, int i, int j) {
  return samples_in(shape, i, j, EachSample{});
}

PixelRun rows_of(const Convex& shape, const PixelBox& clip) {
  if (shape.bottom < 0.0 || shape.right < 0.0) return {};
  const int first = std::max(clip.top, pixel_of(shape.top, clip.top, clip.bottom));
  const int end = pixel_of(shape.bottom, clip.top - 1, clip.bottom - 1) + 1;
  return {first, end};
}

PixelRun columns_of(const Convex& shape, const PixelBox& clip, int j) {
  double left = shape.left;
  double right = shape.right;
  constexpr double worth_it = 3.0 * units_per_pixel;
  if (right - left > worth_it) {
    const double y = static_cast<double>(std::int64_t{j} * units_per_pixel - shape.origin.y);
    for (int k = 0; k < shape.band_count; ++k) {
      const Band& band = shape.bands[static_cast<std::size_t>(k)];
      if (band.a == 0.0) continue;
      // x = (value - b y) / a for values in the band and y in the row.
      const double at_top = band.b * y;
      const double at_bottom = band.b * (y + units_per_pixel);
      const double one = (band.low - std::max(at_top, at_bottom)) / band.a;
      const double other = (band.high - std::min(at_top, at_bottom)) / band.a;
      left = std::max(left, shape.origin.x + std::min(one, other) - 1.0);
      right = std::min(right, shape.origin.x + std::max(one, other) + 1.0);
    }
  }
  if (right < left) return {};
  return {pixel_of(left, clip.left, clip.right), pixel_of(right, clip.left - 1, clip.right - 1) + 1};
}

}  // namespace burin::output::raster
