#pragma once

#include <cstddef>
#include <vector>

#include <burin/output/raster/mask_tiles.hpp>

namespace burin::output::raster {

/// Fills polygons, one path at a time. A sample is inside when the edges to its left wind about it (nonzero) or are odd
/// in number (evenodd); an edge that goes through it counts as left of it. Exact, in whole numbers.
///
/// Memory: the edges of the path and a row of the page.
class PolygonFill {
 public:
  /// Adds a closed contour; the last point is joined to the first. Pre: coordinates below 2^27.
  void add_contour(const std::vector<Point>& points);

  /// Adds the samples inside all contours to the tiles, in `clip` only, and forgets the contours.
  void fill(bool evenodd, const PixelBox& clip, MaskTiles& tiles);

 private:
  /// From the top down.
  struct Edge {
    Point from;
    Point to;
    int winding = 0;  ///< 1 when the contour runs down, else -1
  };
  /// Where an edge passes a line of samples: all samples from this pixel on have it on their left.
  struct Crossing {
    int line = 0;
    int pixel = 0;
    int winding = 0;
  };

  void cross_row(const Edge& edge, int j, const PixelBox& clip);
  void toggle_where_winding_starts_or_ends(const PixelBox& clip);
  void spill_row(int j, const PixelBox& clip, MaskTiles& tiles);

  std::vector<Edge> edges_;
  std::vector<Crossing> crossings_;  ///< of the row of pixels at work
  std::vector<Samples> toggles_;     ///< a sample's bit is set where inside and outside change
};

}  // namespace burin::output::raster
