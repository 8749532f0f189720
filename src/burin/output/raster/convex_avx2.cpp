#include <algorithm>
#include <cmath>

#include <burin/output/raster/avx2.hpp>
#include <burin/output/raster/convex_samples.hpp>
#include <burin/output/raster/kernel.hpp>

#ifdef BURIN_AVX2

namespace burin::output::raster {

namespace {

/// Beyond 2^31 the conversion to whole numbers gives the lowest one, whatever the sign.
BURIN_AVX2 inline Bounds within_range(const Bounds& bounds) {
  const __m256 most = _mm256_set1_ps(1e9F);
  return {_mm256_min_ps(bounds.low, most), _mm256_min_ps(bounds.high, most)};
}

/// 0, 1 ... 7 times `step`.
BURIN_AVX2 inline __m256 ramp(double step) {
  return _mm256_mul_ps(_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_ps(static_cast<float>(step)));
}

/// Four columns of a row at once.
struct FourSamples {
  BURIN_AVX2 static Samples in_band(const BandInPixel& band) {
    const __m256d per_column = _mm256_set1_pd(band.per_column);
    const __m256d left = _mm256_mul_pd(_mm256_setr_pd(0, 1, 2, 3), per_column);
    const __m256d right = _mm256_mul_pd(_mm256_setr_pd(4, 5, 6, 7), per_column);
    const auto is_in = [&](__m256d value) BURIN_AVX2 {
      return _mm256_and_pd(_mm256_cmp_pd(value, _mm256_set1_pd(band.low), _CMP_GE_OQ),
                           _mm256_cmp_pd(value, _mm256_set1_pd(band.high), _CMP_LE_OQ));
    };
    Samples within = 0;
    for (unsigned row = 0; row < 8; ++row) {
      const __m256d start = _mm256_set1_pd(band.first + row * band.per_row);
      within |= row_of(is_in(_mm256_add_pd(start, left)), is_in(_mm256_add_pd(start, right))) << (8 * row);
    }
    return within;
  }

  BURIN_AVX2 static Samples in_disc(double x0, double y0, double squared_radius) {
    const __m256d columns = _mm256_setr_pd(0, 1, 2, 3);
    const __m256d x = _mm256_add_pd(_mm256_set1_pd(x0), _mm256_mul_pd(columns, _mm256_set1_pd(column_x)));
    const __m256d y = _mm256_add_pd(_mm256_set1_pd(y0), _mm256_mul_pd(columns, _mm256_set1_pd(column_y)));
    // All are whole numbers without rounding, in whatever order they are added.
    const auto is_in = [&](unsigned row, unsigned column) BURIN_AVX2 {
      const __m256d u = _mm256_add_pd(x, _mm256_set1_pd(column * column_x + row * row_x));
      const __m256d v =
          _mm256_add_pd(y, _mm256_set1_pd(static_cast<int>(column) * column_y + static_cast<int>(row) * row_y));
      return _mm256_cmp_pd(_mm256_add_pd(_mm256_mul_pd(u, u), _mm256_mul_pd(v, v)), _mm256_set1_pd(squared_radius),
                           _CMP_LE_OQ);
    };
    Samples within = 0;
    for (unsigned row = 0; row < 8; ++row) within |= row_of(is_in(row, 0), is_in(row, 4)) << (8 * row);
    return within;
  }

 private:
  BURIN_AVX2 static Samples row_of(__m256d left, __m256d right) {
    return static_cast<Samples>(_mm256_movemask_pd(left) | _mm256_movemask_pd(right) << 4);
  }
};

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
    return samples_between(within_range(all), sample_words, _mm256_setzero_si256(), certain);
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
    const __m256i uncertain = _mm256_castps_si256(_mm256_cmp_ps(size, uncertain_below_, _CMP_LE_OQ));
    // A row outside has bounds that are equal: nothing lies between them.
    const __m256 half = _mm256_sqrt_ps(_mm256_max_ps(left, _mm256_setzero_ps()));
    const __m256 middle = _mm256_set1_ps(static_cast<float>(column));
    return samples_between(within_range({_mm256_sub_ps(middle, half), _mm256_add_ps(middle, half)}), sample_words,
                           uncertain, certain);
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
  if (!kernel.suits()) return portable_kernel().cover(shape, clip, tiles);
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    if (!tiles.share().has(j)) continue;
    kernel.go_to_row(j);
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples == all_samples) continue;
        bool certain = true;
        const Samples found = kernel.samples(i, certain);
        *samples |= certain ? found : exact_samples_avx2(shape, i, j);
      }
    }
  }
}

BURIN_AVX2 void cover_disc(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  const DiscKernel kernel(shape);
  if (!kernel.suits()) return portable_kernel().cover(shape, clip, tiles);
  const PixelRun rows = rows_of(shape, clip);
  for (int j = rows.first; j < rows.end; ++j) {
    if (!tiles.share().has(j)) continue;
    const PixelRun columns = columns_of(shape, clip, j);
    for (int i = columns.first; i < columns.end;) {
      const int end = std::min(columns.end, MaskTiles::end_of_tile(i));
      for (Samples* samples = tiles.at(i, j, 0); i < end; ++i, ++samples) {
        if (*samples == all_samples) continue;
        bool certain = true;
        const Samples found = kernel.samples(i, j, certain);
        *samples |= certain ? found : exact_samples_avx2(shape, i, j);
      }
    }
  }
}

}  // namespace

Samples exact_samples_avx2(const Convex& shape, int i, int j) {
  return samples_in(shape, i, j, FourSamples{});
}

BURIN_AVX2 void cover_avx2(const Convex& shape, const PixelBox& clip, MaskTiles& tiles) {
  if (shape.band_count == 2 && !shape.has_disc()) return cover_segment(shape, clip, tiles);
  if (shape.band_count == 0) return cover_disc(shape, clip, tiles);
  portable_kernel().cover(shape, clip, tiles);
}

BURIN_AVX2 void count_avx2(const MaskTiles::Tile& masks, std::uint8_t* counts) {
  for (const Samples samples : masks) *counts++ = static_cast<std::uint8_t>(_mm_popcnt_u64(samples));
}

}  // namespace burin::output::raster

#endif
