#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace burin::output::raster {

/// Blocks of memory for tiles. What one grid of tiles gives back serves another: a layer's samples become the picture's
/// colours.
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
    if (used_of_chunk_ == blocks_per_chunk) {
      chunks_.emplace_back(new Block[blocks_per_chunk]);
      used_of_chunk_ = 0;
    }
    return &chunks_.back()[used_of_chunk_++];
  }

  void give_back(Block* block) { spare_.push_back(block); }

 private:
  static constexpr std::size_t blocks_per_chunk = 256;

  std::vector<std::unique_ptr<Block[]>> chunks_;
  std::size_t used_of_chunk_ = blocks_per_chunk;
  std::vector<Block*> spare_;
};

}  // namespace burin::output::raster
