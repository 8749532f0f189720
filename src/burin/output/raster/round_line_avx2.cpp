#include <algorithm>
#include <array>

#include <burin/output/raster/avx2.hpp>
#include <burin/output/raster/kernel.hpp>

#ifdef BURIN_AVX2

namespace burin::output::raster {

namespace {

/// Pixels of one tile.
struct OfOneTile {
  Samples* first;  ///< of pixel (left, top)
  int left;
  int top;
  static int first_row(int row) { return row; }
  static int end_row(int row) { return row; }
  Samples& at(int i, int j) const { return first[(j - top) * MaskTiles::width + (i - left)]; }
};

/// Pixels of two by two tiles, in the rows [first, end) that are drawn.
static_assert(BodyTable::most_pixels <= MaskTiles::width && BodyTable::most_pixels <= MaskTiles::height);
static_assert((1 << RowShare::stripe_bits) % MaskTiles::height == 0);
struct OfFourTiles {
  std::array<Samples*, 4> tiles;
  int split_i;  ///< the first column and row of the last tile
  int split_j;
  int first;
  int end;
  int first_row(int row) const { return std::max(row, first); }
  int end_row(int row) const { return std::min(row, end); }
  Samples& at(int i, int j) const {
    return tiles[2 * static_cast<std::size_t>(j >= split_j) + static_cast<std::size_t>(i >= split_i)]
                [static_cast<unsigned>(j) % MaskTiles::height * MaskTiles::width +
                 static_cast<unsigned>(i) % MaskTiles::width];
  }
};

constexpr auto rows_apart = static_cast<float>(squared_step);
struct DiscNumbers {
  Floats rows{
      {0, rows_apart, 2 * rows_apart, 3 * rows_apart, 4 * rows_apart, 5 * rows_apart, 6 * rows_apart, 7 * rows_apart}};
  Floats sign = all<Floats>(-0.0F);
  Floats unit = all<Floats>(static_cast<float>(fixed_point / squared_step));
  Floats down_per_pixel = all<Floats>(row_x * units_per_pixel);
  Floats down_per_row = all<Floats>(row_y * units_per_pixel);
  Floats middle_per_pixel = all<Floats>(static_cast<float>(column_x * units_per_pixel * (fixed_point / squared_step)));
  Floats middle_per_row = all<Floats>(static_cast<float>(column_y * units_per_pixel * (fixed_point / squared_step)));
  SampleWords words;
};
constexpr DiscNumbers disc_numbers;

/// The disc of a pen about `centre`. Rows of samples are counted in steps of which squared_step make one: there all
/// positions are whole numbers, and floats have them exactly.
template <class Pixels>
BURIN_AVX2 inline void add_disc(const RoundPen& pen, Point centre, const Pixels& pixels) {
  const DiscNumbers& numbers = unknown(disc_numbers);
  const __m256 squared_radius = _mm256_set1_ps(pen.whole_squared_radius);
  const __m256 uncertain_below = _mm256_set1_ps(pen.whole_uncertain_below);
  const int left = pixel_of(centre.x - pen.whole_radius);
  const int right = pixel_of(centre.x + pen.whole_radius);
  const int top = pixels.first_row(pixel_of(centre.y - pen.whole_radius));
  const int end = pixels.end_row(pixel_of(centre.y + pen.whole_radius) + 1);
  // From a pixel's first sample, times the square of a grid's step.
  const int x = centre.x - left * units_per_pixel - sample_x(0, 0);
  const int y = centre.y - top * units_per_pixel - sample_y(0, 0);
  __m256 down_of_row = _mm256_sub_ps(load(numbers.rows), _mm256_set1_ps(static_cast<float>(row_x * x + row_y * y)));
  __m256 middle_of_row = _mm256_fmadd_ps(_mm256_set1_ps(static_cast<float>(column_x * x + column_y * y)),
                                         load(numbers.unit), _mm256_set1_ps(static_cast<float>(bound_offset)));
  for (int j = top; j < end; ++j) {
    __m256 down = down_of_row;
    __m256 middle = middle_of_row;
    for (int i = left; i <= right; ++i) {
      const __m256 squared_half = _mm256_fnmadd_ps(down, down, squared_radius);
      const __m256 uncertain =
          _mm256_cmp_ps(_mm256_andnot_ps(load(numbers.sign), squared_half), uncertain_below, _CMP_LE_OQ);
      // A row outside has bounds that are equal: nothing lies between them.
      const __m256 half = _mm256_sqrt_ps(_mm256_max_ps(squared_half, _mm256_setzero_ps()));
      const Bounds bounds{_mm256_fnmadd_ps(half, load(numbers.unit), middle),
                          _mm256_fmadd_ps(half, load(numbers.unit), middle)};
      bool certain = true;
      const Samples found = samples_between(bounds, numbers.words, _mm256_castps_si256(uncertain), certain);
      pixels.at(i, j) |= certain ? found : exact_samples_avx2(disc(centre, pen.half_width), i, j);
      down = _mm256_add_ps(down, load(numbers.down_per_pixel));
      middle = _mm256_sub_ps(middle, load(numbers.middle_per_pixel));
    }
    down_of_row = _mm256_add_ps(down_of_row, load(numbers.down_per_row));
    middle_of_row = _mm256_sub_ps(middle_of_row, load(numbers.middle_per_row));
  }
}

/// The body of a segment that ends at `to`.
template <class Pixels>
BURIN_AVX2 inline void add_body(const BodyTable& table, Point to, const Pixels& pixels) {
  const int left = pixel_of(to.x + table.body.left);
  const int right = pixel_of(to.x + table.body.right);
  const int top = pixels.first_row(pixel_of(to.y + table.body.top));
  const int end = pixels.end_row(pixel_of(to.y + table.body.bottom) + 1);
  const Point corner{left * units_per_pixel - to.x, top * units_per_pixel - to.y};
  std::uint32_t across_of_row = table.across.place(corner.x, corner.y);
  std::uint32_t along_of_row = table.along.place(corner.x, corner.y);
  for (int j = top; j < end; ++j) {
    std::uint32_t across = across_of_row;
    std::uint32_t along = along_of_row;
    for (int i = left; i <= right; ++i) {
      pixels.at(i, j) |= table.across.samples(across) & table.along.samples(along);
      across += table.across.place_per_pixel();
      along += table.along.place_per_pixel();
    }
    across_of_row += table.across.place_per_row();
    along_of_row += table.along.place_per_row();
  }
}

/// False, and nothing, near the borders of `clip`.
BURIN_AVX2 __attribute__((always_inline)) inline bool cover_by_table(const RoundPen& pen, const BodyTable& body,
                                                                     Point to, const PixelBox& clip, MaskTiles& tiles) {
  const int left = pixel_of(to.x + body.all.left);
  const int right = pixel_of(to.x + body.all.right);
  const int top = pixel_of(to.y + body.all.top);
  const int bottom = pixel_of(to.y + body.all.bottom);
  if (left < clip.left || top < clip.top || right >= clip.right || bottom >= clip.bottom) return false;
  if (!tiles.share().has_any(top, bottom + 1)) return true;
  const int split_i = MaskTiles::end_of_tile(left);
  const int split_j = MaskTiles::end_of_tile_row(top);
  if (right < split_i && bottom < split_j) {
    const OfOneTile pixels{tiles.at(left, top, 0), left, top};
    add_body(body, to, pixels);
    add_disc(pen, to, pixels);
    return true;
  }
  const int last_i = right < split_i ? split_i - MaskTiles::width : split_i;
  const int last_j = bottom < split_j ? split_j - MaskTiles::height : split_j;
  const bool has_top = tiles.share().has(top);
  const bool has_bottom = tiles.share().has(bottom);
  // Tiles that another painter draws are not made.
  const int upper_j = has_top ? split_j - MaskTiles::height : last_j;
  const int lower_j = has_bottom ? last_j : upper_j;
  const auto tile = [&](int i, int j) { return tiles.at(i, j, 0); };
  const OfFourTiles pixels{{tile(split_i - MaskTiles::width, upper_j), tile(last_i, upper_j),
                            tile(split_i - MaskTiles::width, lower_j), tile(last_i, lower_j)},
                           split_i,
                           split_j,
                           has_top ? top : split_j,
                           has_bottom ? bottom + 1 : split_j};
  add_body(body, to, pixels);
  add_disc(pen, to, pixels);
  return true;
}

/// Kept in the place of another one.
__attribute__((noinline)) void enter_step(const RoundPen& pen, RoundStep& place, Point step) {
  place = RoundStep(step, pen.half_width);
}

__attribute__((noinline)) void make_table(const RoundPen& pen, RoundStep& step) {
  if (BodyTable::suits(step.step, pen.half_width)) {
    step.table = std::make_unique<BodyTable>(step.step, pen.half_width);
  }
}

}  // namespace

BURIN_AVX2 void cover_round_avx2(RoundPen& pen, std::span<const Point> line, const PixelBox& clip, MaskTiles& tiles) {
  const int reach = pen.whole_radius + 2;  // all around a disc
  const auto is_drawn_here = [&](int low_y, int high_y) {
    const int top = std::max(clip.top, pixel_of(low_y - reach));
    const int end = std::min(clip.bottom, pixel_of(high_y + reach) + 1);
    return top < end && tiles.share().has_any(top, end);
  };
  // Most points are in rows of one painter only, with those about them.
  constexpr std::size_t most_at_once = 16;
  while (line.size() > 1) {
    const std::span<const Point> some = line.first(std::min(line.size(), most_at_once + 1));
    line = line.subspan(some.size() - 1);
    int low = some.front().y;
    int high = low;
    for (const Point p : some) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    if (!is_drawn_here(low, high)) continue;
    for (std::size_t k = 1; k < some.size(); ++k) {
      const Point from = some[k];
      const Point to = some[k - 1];
      if (from == to || !is_drawn_here(std::min(from.y, to.y), std::max(from.y, to.y))) continue;
      RoundStep& step = pen.slot(to - from);
      if (!(step.step == to - from)) enter_step(pen, step, to - from);
      if (step.table != nullptr && cover_by_table(pen, *step.table, to, clip, tiles)) continue;
      if (++step.uses == RoundStep::uses_for_table) make_table(pen, step);
      cover_segment_avx2(pen, step, {from, to}, clip, tiles);
    }
  }
}

}  // namespace burin::output::raster

#endif
