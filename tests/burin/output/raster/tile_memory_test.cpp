#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <burin/output/raster/mask_tiles.hpp>
#include <burin/output/raster/tile_memory.hpp>

namespace burin::test {
namespace {

using output::raster::MaskTiles;
using output::raster::Samples;
using output::raster::TileMemory;

TEST(TileMemory, NoTwoBlocksShareAByte) {
  TileMemory memory;
  struct Part {
    TileMemory::Block* first;
    std::size_t count;
  };
  std::vector<Part> parts;
  // Small ones, some that leave a rest of their chunk, and one larger than any chunk.
  for (const std::size_t count : {1U, 3U, 250U, 1U, 100U, 2000U, 2048U, 5000U, 2U}) {
    parts.push_back({memory.take(count), count});
    for (int k = 0; k < 300; ++k) parts.push_back({memory.take(), 1});
  }
  for (const Part& part : parts) {
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(part.first) % alignof(TileMemory::Block), 0U);
    for (std::size_t k = 0; k < part.count; ++k) part.first[k].bytes.fill(std::byte{7});
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.first < b.first; });
  for (std::size_t k = 1; k < parts.size(); ++k) {
    ASSERT_LE(parts[k - 1].first + parts[k - 1].count, parts[k].first);
  }
}

TEST(TileMemory, ABlockThatIsGivenBackIsTakenNext) {
  TileMemory memory;
  TileMemory::Block* const first = memory.take();
  TileMemory::Block* const second = memory.take();
  memory.give_back(first);
  EXPECT_EQ(memory.take(), first);
  memory.give_back(second);
  EXPECT_EQ(memory.take(), second);
}

/// The table of tiles is no tile: on a page of any size all are untouched at first, and none meets another.
TEST(TileMemory, HoldsTheTablesOfPagesOfEverySize) {
  TileMemory memory;
  for (const int side : {8, 16, 1000, 2000, 20000}) {
    MaskTiles tiles({0, 0, side, side}, memory);
    ASSERT_EQ(tiles.tiles_of(tiles.rows() - 1).size(), static_cast<std::size_t>(tiles.columns()));
    for (int row = 0; row < tiles.rows(); ++row) {
      for (const MaskTiles::Tile* tile : tiles.tiles_of(row)) ASSERT_EQ(tile, nullptr);
    }
    const int last_column = tiles.columns() - 1;
    const int last_row = tiles.rows() - 1;
    tiles.touched(0, 0, 5);
    if (last_row > 0) tiles.touched(last_column, last_row, 6);
    EXPECT_EQ((*tiles.tile(0, 0))[127], Samples{5});
    EXPECT_EQ(tiles.tile(0, 0), tiles.tiles_of(0).front());
    EXPECT_EQ(tiles.tile(last_column, last_row), tiles.tiles_of(last_row).back());
  }
}

}  // namespace
}  // namespace burin::test
