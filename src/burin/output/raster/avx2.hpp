#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

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
BURIN_AVX2 void cover_round_avx2(RoundPen& pen, std::span<const Point> line, const PixelBox& clip, MaskTiles& tiles);
/// One segment of such a line. Pre: `step` is its step.
BURIN_AVX2 void cover_segment_avx2(const RoundPen& pen, const RoundStep& step, const RoundSegment& segment,
                                   const PixelBox& clip, MaskTiles& tiles);
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

/// A vector in memory, where an instruction takes it for nothing. What the compiler knows it makes anew for every
/// pixel, by one to three instructions.
template <class Value, std::size_t count>
struct alignas(32) InMemory {
  std::array<Value, count> values;
};
using Floats = InMemory<float, 8>;
using Words = InMemory<std::int16_t, 16>;

template <class Vector>
constexpr Vector all(typename decltype(Vector::values)::value_type value) {
  Vector vector{};
  for (auto& each : vector.values) each = value;
  return vector;
}

BURIN_AVX2 inline __m256 load(const Floats& floats) {
  return _mm256_load_ps(floats.values.data());
}
template <class Integer, std::size_t count>
BURIN_AVX2 inline __m256i load(const InMemory<Integer, count>& integers) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(integers.values.data()));
}

/// The same object, but the compiler cannot know what is in it.
template <class T>
const T& unknown(const T& known) {
  const T* same = &known;
  asm("" : "+r"(same) : : "memory");
  return *same;
}

/// What samples_between() computes with.
struct SampleWords {
  // Beyond the pixel's columns all bounds are alike, and no column is near.
  Words most = all<Words>(4 * 4096 + 64);
  Words least = all<Words>(-4 * 4096 - 64);
  Words two = all<Words>(2);
  Words four = all<Words>(4);
  Words fraction = all<Words>(4095);
  Words low_bits = all<Words>(0x0F0F);
  /// Bytes with all columns from number index - 12 (or index + 4, for 0 to 7) on.
  InMemory<std::int8_t, 32> from{{-16, -32, -64, -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8,
                                  -16, -32, -64, -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8}};
};

inline constexpr SampleWords sample_words;

/// The samples between both bounds. `certain` is set to whether they are sure: no bound is near a column, and
/// `uncertain` is zero. Pre: the bounds are within 2^31.
BURIN_AVX2 inline Samples samples_between(const Bounds& bounds, const SampleWords& words, __m256i uncertain,
                                          bool& certain) {
  const __m256i low = _mm256_cvtps_epi32(bounds.low);
  const __m256i high = _mm256_cvtps_epi32(bounds.high);
  // In each half: four low bounds, four high ones.
  const __m256i both =
      _mm256_max_epi16(_mm256_min_epi16(_mm256_packs_epi32(low, high), load(words.most)), load(words.least));
  const __m256i past_column = _mm256_and_si256(_mm256_add_epi16(both, load(words.two)), load(words.fraction));
  const __m256i is_near = _mm256_or_si256(_mm256_cmpgt_epi16(load(words.four), past_column), uncertain);
  certain = _mm256_testz_si256(is_near, is_near) != 0;
  const __m256i columns = _mm256_srai_epi16(both, 12);
  const __m256i index = _mm256_and_si256(_mm256_packs_epi16(columns, columns), load(words.low_bits));
  const __m256i masks = _mm256_shuffle_epi8(load(words.from), index);
  const __m256i between = _mm256_andnot_si256(_mm256_srli_epi64(masks, 32), masks);
  const __m128i rows = _mm_unpacklo_epi32(_mm256_castsi256_si128(between), _mm256_extracti128_si256(between, 1));
  return static_cast<Samples>(_mm_cvtsi128_si64(rows));
}

}  // namespace burin::output::raster

#endif
