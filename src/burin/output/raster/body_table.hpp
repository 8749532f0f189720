#pragma once

#include <burin/output/raster/band_table.hpp>

namespace burin::output::raster {

/// What the bodies of all segments with one step cover: curves draw a few short steps thousands of times. Places are
/// counted from the segment's end.
struct BodyTable {
  /// Whether a segment with its end's disc is within a few pixels, so that it covers most of those about it.
  static bool suits(Point step, double half_width);
  /// It is then never wider or higher.
  static constexpr int most_pixels = 7;
  /// Pre: suits(step, half_width), and the step is not zero.
  BodyTable(Point step, double half_width);

  // What it may reach of the page, in units: the body, and the disc about the end, too.
  PixelBox body;
  PixelBox all;
  BandTable across;
  BandTable along;
};

}  // namespace burin::output::raster
