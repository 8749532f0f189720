#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

#include <burin/output/raster/row_share.hpp>
#include <burin/output/raster/sample_grid.hpp>
#include <burin/output/raster/tile_memory.hpp>

namespace burin::output::raster {

/// A grid of tiles over a part of the page, of which those exist that were touched: memory follows ink, not area.
/// Tiles lie at whole multiples of their size in page coordinates.
template <class Value>
class Tiles {
 public:
  static constexpr int width = 16;
  static constexpr int height = 8;
  using Tile = std::array<Value, static_cast<std::size_t>(width) * height>;

  /// `memory` must outlive the tiles. Pre: part.left and part.top are multiples of a tile's width and height.
  Tiles(const PixelBox& part, TileMemory& memory, RowShare share = {})
      : part_(part),
        memory_(memory),
        share_(share),
        columns_((part.width() + width - 1) / width),
        rows_((part.height() + height - 1) / height),
        tiles_(table(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), memory)) {}

  const PixelBox& part() const { return part_; }
  /// The rows that are drawn here; others do not matter.
  const RowShare& share() const { return share_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// The tile in that column and row of tiles; null when it was never touched.
  Tile* tile(int column, int row) { return tiles_[index(column, row)]; }
  const Tile* tile(int column, int row) const { return tiles_[index(column, row)]; }
  /// All tiles of a row from the left.
  std::span<const Tile* const> tiles_of(int row) const {
    return tiles_.subspan(index(0, row), static_cast<std::size_t>(columns_));
  }

  /// The same, made if need be: filled with `blank`.
  Tile& touched(int column, int row, const Value& blank) {
    Tile*& tile = tiles_[index(column, row)];
    if (tile == nullptr) tile = fresh(blank);
    return *tile;
  }

  /// The value of pixel (i, j), the first of those up to end_of_tile(i). Pre: it is inside part().
  Value* at(int i, int j, const Value& blank) {
    // Without a sign a division is a shift, and this is the innermost loop's.
    const auto x = static_cast<unsigned>(i - part_.left);
    const auto y = static_cast<unsigned>(j - part_.top);
    Tile*& tile = tiles_[y / height * static_cast<std::size_t>(columns_) + x / width];
    if (tile == nullptr) tile = fresh(blank);
    return tile->data() + (y % height * width + x % width);
  }
  /// Pre: i is not negative, as no pixel of the page is.
  static constexpr int end_of_tile(int i) { return (i | (width - 1)) + 1; }
  static constexpr int end_of_tile_row(int j) { return (j | (height - 1)) + 1; }

  /// Forgets what the tile holds; its memory serves the next.
  void release(int column, int row) {
    Tile*& tile = tiles_[index(column, row)];
    if (tile == nullptr) return;
    if constexpr (tiles_per_block == 1) {
      memory_.give_back(reinterpret_cast<TileMemory::Block*>(tile));
    } else {
      spare_.push_back(tile);
    }
    tile = nullptr;
  }

 private:
  static constexpr std::size_t tiles_per_block = sizeof(TileMemory::Block) / sizeof(Tile);
  static_assert(tiles_per_block * sizeof(Tile) == sizeof(TileMemory::Block));

  static std::span<Tile*> table(std::size_t count, TileMemory& memory) {
    const std::size_t blocks = (count * sizeof(Tile*) + sizeof(TileMemory::Block) - 1) / sizeof(TileMemory::Block);
    Tile** const tiles = new (memory.take(blocks)) Tile*[count]();
    return {tiles, count};
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  __attribute__((noinline)) Tile* fresh(const Value& blank) {
    if (spare_.empty()) {
      std::byte* const bytes = memory_.take()->bytes.data();
      // Not cleared here: each tile is filled when it is touched.
      for (std::size_t k = tiles_per_block; k-- > 0;) spare_.push_back(new (bytes + k * sizeof(Tile)) Tile);
    }
    Tile* const tile = spare_.back();
    spare_.pop_back();
    tile->fill(blank);
    return tile;
  }

  PixelBox part_;
  TileMemory& memory_;
  RowShare share_;
  int columns_;
  int rows_;
  std::span<Tile*> tiles_;
  std::vector<Tile*> spare_;
};

/// The ink of one layer.
using MaskTiles = Tiles<Samples>;

}  // namespace burin::output::raster
