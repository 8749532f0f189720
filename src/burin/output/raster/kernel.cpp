#include <algorithm>
#include <bit>

#include <burin/output/raster/avx2.hpp>
#include <burin/output/raster/kernel.hpp>

namespace burin::output::raster {

namespace {

void cover_portable(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    if (!tiles.share().has(j)) continue;
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples != all_samples) *samples |= samples_in(shape, i, j);
      }
    }
  }
}

void cover_round_portable(RoundPen& pen, std::span<const Point> line, const PixelBox& clip, MaskTiles& tiles) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (line[k] == line[k - 1]) continue;
    cover_portable(segment_body(line[k - 1], line[k], pen.half_width), clip, tiles);
    cover_portable(disc(line[k - 1], pen.half_width), clip, tiles);
  }
}

void count_portable(const MaskTiles::Tile& masks, std::uint8_t* counts) {
  for (const Samples samples : masks) *counts++ = static_cast<std::uint8_t>(std::popcount(samples));
}

}  // namespace

const Kernel& portable_kernel() {
  static constexpr Kernel kernel{cover_portable, cover_round_portable, count_portable};
  return kernel;
}

const Kernel& best_kernel() {
#ifdef BURIN_AVX2
  static constexpr Kernel kernel{cover_avx2, cover_round_avx2, count_avx2};
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                               __builtin_cpu_supports("popcnt") != 0;
  if (has_avx2) return kernel;
#endif
  return portable_kernel();
}

}  // namespace burin::output::raster
