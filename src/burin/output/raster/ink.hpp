#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <burin/output/raster/kernel.hpp>
#include <burin/output/raster/polygon_fill.hpp>

namespace burin::output::raster {

/// The ink of one layer on a part of the page. The order of what is added does not matter, nor does how the page is cut
/// into parts.
class Ink {
 public:
  /// Pre: part begins at whole tiles.
  explicit Ink(const PixelBox& part, const Kernel& kernel = best_kernel(), RowShare share = {})
      : kernel_(&kernel), tiles_(part, memory_, share) {}

  void add(const Convex& shape) { kernel_->cover(shape, tiles_.part(), tiles_); }
  /// As Kernel::cover_round.
  void add(RoundPen& pen, std::span<const Point> line) { kernel_->cover_round(pen, line, tiles_.part(), tiles_); }
  void add(PolygonFill& polygon, bool evenodd) { polygon.fill(evenodd, tiles_.part(), tiles_); }

  /// Whether what lies between these heights, in pixels, is drawn here.
  bool shows(double top, double bottom) const {
    const int first = std::max(tiles_.part().top, static_cast<int>(std::floor(top)));
    const int end = std::min(tiles_.part().bottom, static_cast<int>(std::floor(bottom)) + 1);
    return first < end && tiles_.share().has_any(first, end);
  }

  const Kernel& kernel() const { return *kernel_; }
  MaskTiles& tiles() { return tiles_; }
  TileMemory& memory() { return memory_; }

 private:
  const Kernel* kernel_;
  TileMemory memory_;
  MaskTiles tiles_;
};

}  // namespace burin::output::raster
