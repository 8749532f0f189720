#include <algorithm>
#include <array>
#include <cmath>

#include <burin/output/raster/avx2.hpp>
#include <burin/output/raster/kernel.hpp>

#ifdef BURIN_AVX2

namespace burin::output::raster {

namespace {

// A row of samples meets the body between two bounds, the disc about the segment's end between two others. What lies
// between the least and the greatest of them is covered by both, or by the disc about its start: all three together are
// convex.

/// Of every pixel.
struct PixelNumbers {
  Floats rows{{0, 4096, 8192, 12288, 16384, 20480, 24576, 28672}};
  Floats sign = all<Floats>(-0.0F);
  Floats far = all<Floats>(1e9F);
  Floats before_all = all<Floats>(-1e9F);
  Floats near = all<Floats>(4.0F);
  Floats unit = all<Floats>(static_cast<float>(fixed_point / squared_step));
  Floats offset = all<Floats>(static_cast<float>(bound_offset));
  SampleWords words;
};
constexpr PixelNumbers pixel_numbers;

/// Of a step and the pen.
struct StepLanes {
  BURIN_AVX2 StepLanes(const RoundPen& pen, const RoundStep& step) {
    const auto set = [](Floats& floats, float value)
                         BURIN_AVX2 { _mm256_store_ps(floats.values.data(), _mm256_set1_ps(value)); };
    set(squared_radius, pen.squared_radius);
    set(uncertain_below, pen.uncertain_below);
    set(across, step.across);
    set(along, step.along);
    set(side, step.side);
    set(low_end, step.low_end);
    set(high_end, step.high_end);
  }

  Floats squared_radius;
  Floats uncertain_below;
  Floats across;
  Floats along;
  Floats side;
  Floats low_end;
  Floats high_end;
};

/// `column` and `row`: where the segment's end is from the pixel's first sample, times the square of a grid's step.
BURIN_AVX2 inline Samples samples_of(const PixelNumbers& numbers, const StepLanes& step, int column, int row,
                                     bool& certain) {
  const __m256 unit = load(numbers.unit);
  const __m256 down = _mm256_fnmadd_ps(_mm256_set1_ps(static_cast<float>(row)), unit, load(numbers.rows));
  const __m256 middle = _mm256_fmadd_ps(_mm256_set1_ps(static_cast<float>(column)), unit, load(numbers.offset));
  const __m256 axis = _mm256_mul_ps(down, load(step.across));
  const __m256 end = _mm256_mul_ps(down, load(step.along));
  const __m256 low_body = _mm256_max_ps(_mm256_sub_ps(axis, load(step.side)), _mm256_add_ps(end, load(step.low_end)));
  const __m256 high_body = _mm256_min_ps(_mm256_add_ps(axis, load(step.side)), _mm256_add_ps(end, load(step.high_end)));
  const __m256 body = _mm256_sub_ps(high_body, low_body);
  const __m256 disc = _mm256_fnmadd_ps(down, down, load(step.squared_radius));
  // Whether a row meets the body, and the disc, must be sure too.
  const __m256 sign = load(numbers.sign);
  const __m256 is_near =
      _mm256_or_ps(_mm256_cmp_ps(_mm256_andnot_ps(sign, body), load(numbers.near), _CMP_LT_OQ),
                   _mm256_cmp_ps(_mm256_andnot_ps(sign, disc), load(step.uncertain_below), _CMP_LE_OQ));
  // Where there is no root, it is no number, and the lesser or greater of it and another is the other.
  const __m256 half = _mm256_sqrt_ps(disc);
  const __m256 low = _mm256_min_ps(_mm256_xor_ps(half, sign), _mm256_blendv_ps(low_body, load(numbers.far), body));
  const __m256 high = _mm256_max_ps(half, _mm256_blendv_ps(high_body, load(numbers.before_all), body));
  return samples_between({_mm256_add_ps(low, middle), _mm256_add_ps(high, middle)}, numbers.words,
                         _mm256_castps_si256(is_near), certain);
}

/// What a segment may reach of some rows of pixels: the columns [begin, end).
struct RowSpans {
  static constexpr std::size_t count = 8;
  alignas(32) std::array<int, count> begin;
  alignas(32) std::array<int, count> end;
};

/// Of the rows from `top` on. All at once, for a branch that waits for one row's numbers is expensive.
BURIN_AVX2 inline RowSpans spans_from(int top, const RoundStep& step, Point to, int left, int right) {
  const __m256 rows = _mm256_setr_ps(0, 1024, 2048, 3072, 4096, 5120, 6144, 7168);
  const __m256 x_per_y = _mm256_set1_ps(step.x_per_y);
  const __m256 half_level = _mm256_set1_ps(step.half_level);
  const __m256 y = _mm256_add_ps(_mm256_set1_ps(static_cast<float>(top * units_per_pixel - to.y)), rows);
  const __m256 at_top = _mm256_mul_ps(y, x_per_y);
  const __m256 at_bottom = _mm256_mul_ps(_mm256_add_ps(y, _mm256_set1_ps(units_per_pixel)), x_per_y);
  const __m256 low = _mm256_sub_ps(_mm256_min_ps(at_top, at_bottom), half_level);
  const __m256 high = _mm256_add_ps(_mm256_max_ps(at_top, at_bottom), half_level);
  const auto columns = [&](__m256 x) BURIN_AVX2 {
    const __m256 near = _mm256_min_ps(_mm256_max_ps(x, _mm256_set1_ps(-1e9F)), _mm256_set1_ps(1e9F));
    return _mm256_srai_epi32(_mm256_add_epi32(_mm256_cvttps_epi32(near), _mm256_set1_epi32(to.x)), 10);
  };
  RowSpans spans;
  _mm256_store_si256(reinterpret_cast<__m256i*>(spans.begin.data()),
                     _mm256_max_epi32(columns(low), _mm256_set1_epi32(left)));
  _mm256_store_si256(reinterpret_cast<__m256i*>(spans.end.data()),
                     _mm256_min_epi32(_mm256_add_epi32(columns(high), _mm256_set1_epi32(1)), _mm256_set1_epi32(right)));
  return spans;
}

__attribute__((noinline)) Samples exact_samples(const RoundSegment& segment, double half_width, int i, int j) {
  return exact_samples_avx2(segment_body(segment.from, segment.to, half_width), i, j) |
         exact_samples_avx2(disc(segment.to, half_width), i, j);
}

}  // namespace

BURIN_AVX2 void cover_segment_avx2(const RoundPen& pen, const RoundStep& step, const RoundSegment& segment,
                                   const PixelBox& clip, MaskTiles& tiles) {
  const Point to = segment.to;
  if (!step.suits) {
    cover_avx2(segment_body(segment.from, segment.to, pen.half_width), clip, tiles);
    return cover_avx2(disc(segment.to, pen.half_width), clip, tiles);
  }
  const int top = std::max(clip.top, pixel_of(to.y + step.top));
  const int bottom = std::min(clip.bottom, pixel_of(to.y + step.bottom) + 1);
  const int left = std::max(clip.left, pixel_of(to.x + step.left));
  const int right = std::min(clip.right, pixel_of(to.x + step.right) + 1);
  const PixelNumbers& numbers = unknown(pixel_numbers);
  const StepLanes own_lanes(pen, step);
  const StepLanes& lanes = unknown(own_lanes);
  RowSpans spans;
  for (int j = top; j < bottom; ++j) {
    const auto row = static_cast<std::size_t>(j - top) % RowSpans::count;
    if (row == 0) spans = spans_from(j, step, to, left, right);
    if (!tiles.share().has(j)) continue;
    const int y = to.y - j * units_per_pixel - sample_y(0, 0);
    int i = spans.begin[row];
    const int row_end = spans.end[row];
    while (i < row_end) {
      const int end = std::min(row_end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples == all_samples) continue;
        const int x = to.x - i * units_per_pixel - sample_x(0, 0);
        bool certain = true;
        const Samples found = samples_of(numbers, lanes, column_x * x + column_y * y, row_x * x + row_y * y, certain);
        *samples |= certain ? found : exact_samples(segment, pen.half_width, i, j);
      }
    }
  }
}

}  // namespace burin::output::raster

#endif
