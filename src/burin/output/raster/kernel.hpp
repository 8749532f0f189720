#pragma once

#include <cstdint>
#include <span>

#include <burin/output/raster/convex.hpp>
#include <burin/output/raster/mask_tiles.hpp>
#include <burin/output/raster/round_pen.hpp>

namespace burin::output::raster {

/// The inner loops of the rasterizer. All kernels give the same bits: what is not certain in a faster way, they ask
/// samples_in() for.
struct Kernel {
  /// Adds the samples of `shape` in the part that the tiles cover and in `clip` to the tiles.
  void (*cover)(const Convex& shape, const PixelBox& clip, MaskTiles& tiles);
  /// Adds a line with round joins, as wide as `pen`: the body of each segment and the discs about all points but the
  /// last. What the disc about that one has besides, it may add or not. Points may fall together.
  void (*cover_round)(RoundPen& pen, std::span<const Point> line, const PixelBox& clip, MaskTiles& tiles);
  /// How many samples each pixel of a tile has, 0 to 64.
  void (*count)(const MaskTiles::Tile& masks, std::uint8_t* counts);
};

/// For every machine.
const Kernel& portable_kernel();

/// The fastest for the machine that the program runs on.
const Kernel& best_kernel();

}  // namespace burin::output::raster
