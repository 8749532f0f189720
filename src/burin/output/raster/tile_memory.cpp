#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <burin/output/raster/tile_memory.hpp>

namespace burin::output::raster {

namespace {

/// A huge page of most processors. Memory of that size and alignment is had from Linux in one piece, not by a fault for
/// each 4 KB, of which a dragon of 2000 pixels would take 2000: a twentieth of all its time.
constexpr std::size_t huge_page_bytes = std::size_t{1} << 21U;

/// A picture whose table of tiles is a quarter of this, 1000 x 1000 pixels, may be content with it.
constexpr std::size_t first_chunk_bytes = std::size_t{1} << 18U;

void ask_for_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  // Where there are none, small ones do.
  static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
}

}  // namespace

void TileMemory::Free::operator()(Block* chunk) const {
  ::operator delete (chunk, std::align_val_t{huge_page_bytes});
}

void TileMemory::add_chunk(std::size_t least_blocks) {
  for (Block& block : fresh_) give_back(&block);
  const std::size_t least_bytes = least_blocks * sizeof(Block);
  const bool is_small = chunks_.empty() && least_bytes <= first_chunk_bytes / 4;
  const std::size_t bytes =
      is_small ? first_chunk_bytes : (least_bytes + huge_page_bytes - 1) / huge_page_bytes * huge_page_bytes;
  void* const memory = ::operator new (bytes, std::align_val_t{huge_page_bytes});
  if (!is_small) ask_for_huge_pages(memory, bytes);
  const std::size_t count = bytes / sizeof(Block);
  chunks_.emplace_back(new (memory) Block[count]);
  fresh_ = {chunks_.back().get(), count};
}

}  // namespace burin::output::raster
