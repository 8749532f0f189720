#pragma once

#include <bit>
#include <cstdint>

#include <burin/output/raster/convex.hpp>
#include <burin/output/raster/mask_tiles.hpp>
#include <burin/output/raster/round_pen.hpp>

#if defined(__x86_64__) && defined(__GNUC__)
#define BURIN_AVX2 __attribute__((target("avx2,fma,popcnt")))
#include <immintrin.h>

/// The kernels for processors with AVX2: see Kernel for what each does.
namespace burin::output::raster {

/// samples_in(), faster.
Samples exact_samples_avx2(const Convex& shape, int i, int j);

BURIN_AVX2 void cover_avx2(const Convex& shape, const PixelBox& clip, MaskTiles& tiles);
BURIN_AVX2 void cover_round_avx2(RoundPen& pen, const RoundSegment& segment, const PixelBox& clip, MaskTiles& tiles);
BURIN_AVX2 void count_avx2(const MaskTiles::Tile& masks, std::uint8_t* counts);

// One vector has the eight rows of samples of a pixel. In each row a shape covers the columns between two bounds, which
// are linear in the row for a band and have a root in them for a disc. Bounds are computed in fixed-point numbers of
// 1/4096 column; one that is within 2/4096 of a column is not certain, and then the pixel is done exactly. Rounding
// stays below 1.5/4096: see the limits in the kernels.

/// Bounds are counted from column 4, so that -4 to 12 fit into 16 bits, and one is added: a bound's whole part is then
/// the first column that is not left of it.
inline constexpr double bound_offset = (1.0 - 4.0) * fixed_point;

struct Bounds {
  __m256 low;
  __m256 high;
};

/// 16 times the same 16 bits. As a float of the same bits it is one load; as a number it would go through a register.
BURIN_AVX2 inline __m256i words(std::int16_t word) {
  const auto bits = static_cast<std::uint16_t>(word);
  return _mm256_castps_si256(_mm256_set1_ps(std::bit_cast<float>(bits * 0x10001U)));
}

/// The samples between both bounds. `certain` is set to whether they are sure. Pre: the bounds are within 2^31.
BURIN_AVX2 inline Samples samples_between(const Bounds& bounds, bool& certain) {
  const __m256i low = _mm256_cvtps_epi32(bounds.low);
  const __m256i high = _mm256_cvtps_epi32(bounds.high);
  // In each half: four low bounds, four high ones. Beyond the pixel's columns all are alike, and no column is near.
  constexpr std::int16_t beyond = 4 * 4096 + 64;
  const __m256i both = _mm256_max_epi16(_mm256_min_epi16(_mm256_packs_epi32(low, high), words(beyond)), words(-beyond));
  const __m256i past_column = _mm256_and_si256(_mm256_add_epi16(both, words(2)), words(4095));
  const __m256i is_near = _mm256_cmpgt_epi16(words(4), past_column);
  certain = _mm256_testz_si256(is_near, is_near) != 0;
  const __m256i columns = _mm256_srai_epi16(both, 12);
  const __m256i index = _mm256_and_si256(_mm256_packs_epi16(columns, columns), words(0x0F0F));
  // All columns from number index - 12 (or index + 4, for 0 to 7) on.
  const __m256i from = _mm256_setr_epi8(-16, -32, -64, -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8, -16, -32, -64,
                                        -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8);
  const __m256i masks = _mm256_shuffle_epi8(from, index);
  const __m256i between = _mm256_andnot_si256(_mm256_srli_epi64(masks, 32), masks);
  const __m128i rows = _mm_unpacklo_epi32(_mm256_castsi256_si128(between), _mm256_extracti128_si256(between, 1));
  return static_cast<Samples>(_mm_cvtsi128_si64(rows));
}

}  // namespace burin::output::raster

#endif
