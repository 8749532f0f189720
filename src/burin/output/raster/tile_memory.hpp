#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace burin::output::raster {

/// Blocks of memory for tiles and for the tables of where they are. What one grid of tiles gives back serves another: a
/// layer's samples become the picture's colours.
class TileMemory {
 public:
  struct alignas(64) Block {
    std::array<std::byte, 1024> bytes;
  };

  TileMemory() = default;
  TileMemory(const TileMemory&) = delete;
  TileMemory& operator=(const TileMemory&) = delete;
  ~TileMemory() = default;

  /// Its bytes are any. Valid as long as this lives.
  Block* take() {
    if (!spare_.empty()) {
      Block* const block = spare_.back();
      spare_.pop_back();
      return block;
    }
    return take(1);
  }

  /// So many in a row, which cannot be given back.
  Block* take(std::size_t count) {
    if (fresh_.size() < count) add_chunk(count);
    Block* const blocks = fresh_.data();
    fresh_ = fresh_.subspan(count);
    return blocks;
  }

  void give_back(Block* block) { spare_.push_back(block); }

 private:
  struct Free {
    void operator()(Block* chunk) const;
  };

  void add_chunk(std::size_t least_blocks);

  std::vector<std::unique_ptr<Block[], Free>> chunks_;
  std::span<Block> fresh_;  ///< of the last chunk
  std::vector<Block*> spare_;
};

}  // namespace burin::output::raster
