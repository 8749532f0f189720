#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <burin/output/raster/kernel.hpp>

#if defined(__x86_64__) && defined(__GNUC__)
#define BURIN_AVX2 __attribute__((target("avx2,popcnt")))
#include <immintrin.h>
#endif

namespace burin::output::raster {

namespace {

/// Exactly.
void add_pixel(const Convex& shape, int i, int j, Samples& samples) {
  if (samples != all_samples) samples |= samples_in(shape, i, j);
}

void cover_portable(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) add_pixel(shape, i, j, *samples);
    }
  }
}

void count_portable(const MaskTiles::Tile& masks, std::uint8_t* counts) {
  for (const Samples samples : masks) *counts++ = static_cast<std::uint8_t>(std::popcount(samples));
}

#ifdef BURIN_AVX2

// One vector has the eight rows of samples of a pixel. In each row a shape covers the columns between two bounds, which
// are linear in the row for a band and have a root in them for a disc. Bounds are computed in fixed-point numbers of
// 1/4096 column; one that is within 2/4096 of a column is not certain, and then the pixel is done exactly. Rounding
// stays below 1.7/4096: see the limits in SegmentKernel and DiscKernel.

constexpr double fixed_point = 4096.0;
/// Bounds are counted from column 4, so that -4 to 12 fit into 16 bits, and one is added: a bound's whole part is then
/// the first column that is not left of it.
constexpr double bound_offset = (1.0 - 4.0) * fixed_point;

struct Bounds {
  __m256 low;
  __m256 high;
};

/// The samples between both bounds. `certain` is cleared when they are not sure.
BURIN_AVX2 inline Samples samples_between(const Bounds& bounds, bool& certain) {
  const __m256 most = _mm256_set1_ps(1e9F);  // beyond 2^31 the conversion gives the lowest number, whatever the sign
  const __m256i low = _mm256_cvtps_epi32(_mm256_min_ps(bounds.low, most));
  const __m256i high = _mm256_cvtps_epi32(_mm256_min_ps(bounds.high, most));
  // In each half: four low bounds, four high ones. Beyond the pixel's columns all are alike, and no column is near.
  const __m256i beyond = _mm256_set1_epi16(4 * 4096 + 64);
  const __m256i both = _mm256_max_epi16(_mm256_min_epi16(_mm256_packs_epi32(low, high), beyond),
                                        _mm256_sub_epi16(_mm256_setzero_si256(), beyond));
  const __m256i near_column = _mm256_and_si256(_mm256_adds_epi16(both, _mm256_set1_epi16(2)), _mm256_set1_epi16(4095));
  certain = _mm256_testz_si256(_mm256_cmpgt_epi16(_mm256_set1_epi16(4), near_column), _mm256_set1_epi16(-1)) != 0;
  const __m256i columns = _mm256_srai_epi16(both, 12);
  const __m256i index = _mm256_and_si256(_mm256_packs_epi16(columns, columns), _mm256_set1_epi8(15));
  // All columns from number index - 12 (or index + 4, for 0 to 7) on.
  const __m256i from = _mm256_setr_epi8(-16, -32, -64, -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8, -16, -32, -64,
                                        -128, 0, 0, 0, 0, -1, -1, -1, -1, -1, -2, -4, -8);
  const __m256i masks = _mm256_shuffle_epi8(from, index);
  const __m256i between = _mm256_andnot_si256(_mm256_srli_epi64(masks, 32), masks);
  const __m128i rows = _mm_unpacklo_epi32(_mm256_castsi256_si128(between), _mm256_extracti128_si256(between, 1));
  return static_cast<Samples>(_mm_cvtsi128_si64(rows));
}

/// 0, 1 ... 7 times `step`.
BURIN_AVX2 inline __m256 ramp(double step) {
  return _mm256_mul_ps(_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_ps(static_cast<float>(step)));
}

/// A shape of two bands.
class SegmentKernel {
 public:
  BURIN_AVX2 explicit SegmentKernel(const Convex& shape) {
    const Line one = line(shape, shape.bands[0]);
    const Line other = line(shape, shape.bands[1]);
    // At a steeper one the rows' own rounding would count.
    constexpr double steepest = 256.0 * fixed_point;
    suits_ = std::abs(one.per_row) <= steepest && std::abs(other.per_row) <= steepest;
    ramp_one_ = ramp(one.per_row);
    ramp_other_ = ramp(other.per_row);
    start_ = _mm256_setr_pd(one.low, one.high, other.low, other.high);
    per_i_ = _mm256_setr_pd(one.per_i, one.per_i, other.per_i, other.per_i);
    per_j_ = _mm256_setr_pd(one.per_j, one.per_j, other.per_j, other.per_j);
  }

  bool suits() const { return suits_; }

  BURIN_AVX2 void go_to_row(int j) { row_ = _mm256_add_pd(start_, _mm256_mul_pd(per_j_, _mm256_set1_pd(j))); }

  BURIN_AVX2 Samples samples(int i, bool& certain) const {
    const __m128 bounds = _mm256_cvtpd_ps(_mm256_add_pd(row_, _mm256_mul_pd(per_i_, _mm256_set1_pd(i))));
    const __m256 twice = _mm256_set_m128(bounds, bounds);
    Bounds all;
    all.low = _mm256_max_ps(_mm256_add_ps(_mm256_permute_ps(twice, 0x00), ramp_one_),
                            _mm256_add_ps(_mm256_permute_ps(twice, 0xAA), ramp_other_));
    all.high = _mm256_min_ps(_mm256_add_ps(_mm256_permute_ps(twice, 0x55), ramp_one_),
                             _mm256_add_ps(_mm256_permute_ps(twice, 0xFF), ramp_other_));
    return samples_between(all, certain);
  }

 private:
  /// The bounds of a band in row 0 of pixel (0, 0), and how they grow.
  struct Line {
    double low;
    double high;
    double per_row;
    double per_i;
    double per_j;
  };

  static Line line(const Convex& shape, const Band& band) {
    const double per_column = band.a * 128.0 - band.b * 16.0;
    const double scale = fixed_point / per_column;
    const double at_start = band.a * (sample_x(0, 0) - shape.origin.x) + band.b * (sample_y(0, 0) - shape.origin.y);
    const double low = (band.low - at_start) * scale + bound_offset;
    const double high = (band.high - at_start) * scale + bound_offset;
    return {std::min(low, high), std::max(low, high), -(band.a * 16.0 + band.b * 128.0) * scale,
            -band.a * units_per_pixel * scale, -band.b * units_per_pixel * scale};
  }

  bool suits_;
  __m256 ramp_one_;
  __m256 ramp_other_;
  __m256d start_;
  __m256d per_i_;
  __m256d per_j_;
  __m256d row_;
};

/// A disc and nothing else.
class DiscKernel {
 public:
  BURIN_AVX2 explicit DiscKernel(const Convex& shape) {
    // In the frame of the samples a column and a row are of length 1.
    const double unit = fixed_point / (128.0 * 128.0 + 16.0 * 16.0);
    const double x = shape.origin.x - sample_x(0, 0);
    const double y = shape.origin.y - sample_y(0, 0);
    column_ = (128.0 * x - 16.0 * y) * unit + bound_offset;
    row_ = (16.0 * x + 128.0 * y) * unit;
    per_128_ = -128.0 * units_per_pixel * unit;
    per_16_ = -16.0 * units_per_pixel * unit;
    const double squared = shape.radius * shape.radius * unit * fixed_point;
    radius_squared_ = _mm256_set1_ps(static_cast<float>(squared));
    // Rounding of the square, of at most 2^-20, shifts the root by less than half a step above this.
    const double rounding = squared * 0x1p-20;
    uncertain_below_ = _mm256_set1_ps(static_cast<float>(rounding * rounding));
    suits_ = rounding * rounding <= 0.1 * squared;
  }

  bool suits() const { return suits_; }

  BURIN_AVX2 Samples samples(int i, int j, bool& certain) const {
    const double column = column_ + i * per_128_ - j * per_16_;
    const double row = row_ + i * per_16_ + j * per_128_;
    const __m256 rows = _mm256_setr_ps(0, 4096, 8192, 12288, 16384, 20480, 24576, 28672);
    const __m256 across = _mm256_sub_ps(rows, _mm256_set1_ps(static_cast<float>(row)));
    const __m256 left = _mm256_sub_ps(radius_squared_, _mm256_mul_ps(across, across));
    const __m256 size = _mm256_andnot_ps(_mm256_set1_ps(-0.0F), left);
    const int near_border = _mm256_movemask_ps(_mm256_cmp_ps(size, uncertain_below_, _CMP_LE_OQ));
    // A row outside has bounds that are equal: nothing lies between them.
    const __m256 half = _mm256_sqrt_ps(_mm256_max_ps(left, _mm256_setzero_ps()));
    const __m256 middle = _mm256_set1_ps(static_cast<float>(column));
    const Samples found = samples_between({_mm256_sub_ps(middle, half), _mm256_add_ps(middle, half)}, certain);
    certain = certain && near_border == 0;
    return found;
  }

 private:
  bool suits_;
  double column_;
  double row_;
  double per_128_;
  double per_16_;
  __m256 radius_squared_;
  __m256 uncertain_below_;
};

BURIN_AVX2 void cover_segment(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  SegmentKernel kernel(shape);
  if (!kernel.suits()) return cover_portable(shape, clip, tiles);
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    kernel.go_to_row(j);
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples == all_samples) continue;
        bool certain = true;
        const Samples found = kernel.samples(i, certain);
        *samples |= certain ? found : samples_in(shape, i, j);
      }
    }
  }
}

BURIN_AVX2 void cover_disc(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  const DiscKernel kernel(shape);
  if (!kernel.suits()) return cover_portable(shape, clip, tiles);
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples == all_samples) continue;
        bool certain = true;
        const Samples found = kernel.samples(i, j, certain);
        *samples |= certain ? found : samples_in(shape, i, j);
      }
    }
  }
}

void cover_avx2(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  if (shape.band_count == 2 && !shape.has_disc()) return cover_segment(shape, clip, tiles);
  if (shape.band_count == 0) return cover_disc(shape, clip, tiles);
  cover_portable(shape, clip, tiles);
}

BURIN_AVX2 void count_avx2(const MaskTiles::Tile& masks, std::uint8_t* counts) {
  for (const Samples samples : masks) *counts++ = static_cast<std::uint8_t>(_mm_popcnt_u64(samples));
}

#endif

}  // namespace

const Kernel& portable_kernel() {
  static constexpr Kernel kernel{cover_portable, count_portable};
  return kernel;
}

const Kernel& best_kernel() {
#ifdef BURIN_AVX2
  static constexpr Kernel kernel{cover_avx2, count_avx2};
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("popcnt") != 0;
  if (has_avx2) return kernel;
#endif
  return portable_kernel();
}

}  // namespace burin::output::raster
