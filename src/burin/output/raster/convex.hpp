#pragma once

#include <array>
#include <limits>

#include <burin/output/raster/sample_grid.hpp>

namespace burin::output::raster {

/// low <= a x + b y <= high, x and y counted from the origin of the shape that it belongs to.
struct Band {
  double a = 0.0;
  double b = 0.0;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// What strokes are made of: where up to four bands meet, within a disc about the origin if there is one; borders
/// belong to it. Lengths are units.
///
/// Whether a sample belongs to it is exact: the sum a x + b y has no rounding, since directions and positions are whole
/// numbers below 2^26 on pages of up to 30,000 pixels. Where it is rounded, on larger ones and for the slanted side of
/// a bevel, one formula does it.
struct Convex {
  Point origin;
  std::array<Band, 4> bands;
  int band_count = 0;
  double radius = std::numeric_limits<double>::infinity();
  /// Samples outside these borders, in units, are not in the shape.
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  bool has_disc() const { return radius < std::numeric_limits<double>::infinity(); }
};

/// All within `half_width` of the segment a b and not beyond its ends, which may lie `before` a and `after` b, in
/// multiples of half_width. Pre: a != b.
Convex segment_body(Point a, Point b, double half_width, double before = 0.0, double after = 0.0);

/// What a square cap adds beyond b.
Convex square_cap(Point a, Point b, double half_width);

Convex disc(Point center, double radius);

/// A square with two sides of 2 * half_side along `direction`. Pre: it is not zero.
Convex square(Point center, Vec2 direction, double half_side);

/// What lies beyond the end of a stroke that comes to `corner` along `in` and before the start of one that leaves it
/// along `out`, within `radius` of the corner: a round join. Pre: neither direction is zero; the same holds below.
Convex join_sector(Point corner, Point in, Point out, double radius);

/// The same up to the line between the outer corners of both strokes. Pre: in and out are not parallel.
Convex join_bevel(Point corner, Point in, Point out, double half_width);

/// The same within both strokes drawn on and on: a miter join. Pre: in and out do not point against each other.
Convex join_miter(Point corner, Point in, Point out, double half_width);

/// The samples of pixel (i, j) in the shape: the definition that every faster way is held to.
Samples samples_in(const Convex& shape, int i, int j);

/// The pixels [first, end) of a row.
struct PixelRun {
  int first = 0;
  int end = 0;
};

/// The pixels of row j that may have samples in the shape, within clip.
PixelRun columns_of(const Convex& shape, const PixelBox& clip, int j);

/// The rows [first, end) that may have samples in the shape, within clip.
PixelRun rows_of(const Convex& shape, const PixelBox& clip);

}  // namespace burin::output::raster
