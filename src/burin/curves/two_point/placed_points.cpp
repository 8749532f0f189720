#include <cstddef>

#include <burin/curves/two_point/placed_points.hpp>

#if defined(__x86_64__) && defined(__GNUC__)
#define BURIN_AVX2 __attribute__((target("avx2")))
#include <immintrin.h>
#endif

namespace burin::curves::two_point {

namespace {

void place_portable(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2* room) {
  for (const Vec2 v : table) *room++ = p + complex_product(v, d);
}

#ifdef BURIN_AVX2

BURIN_AVX2 void place_avx2(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2* room) {
  const __m256d start = _mm256_setr_pd(p.x, p.y, p.x, p.y);
  const __m256d along = _mm256_set1_pd(d.x);
  const __m256d across = _mm256_set1_pd(d.y);
  const std::size_t pairs = table.size() / 2;
  for (std::size_t k = 0; k < 2 * pairs; k += 2) {
    const __m256d xy = _mm256_loadu_pd(&table[k].x);
    const __m256d yx = _mm256_permute_pd(xy, 0b0101);
    // x is a difference, y a sum.
    const __m256d product = _mm256_addsub_pd(_mm256_mul_pd(xy, along), _mm256_mul_pd(yx, across));
    _mm256_storeu_pd(&room[k].x, _mm256_add_pd(start, product));
  }
  place_portable(table.subspan(2 * pairs), p, d, room + 2 * pairs);
}

#endif

using Place = void (*)(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2* room);

Place fastest() {
#ifdef BURIN_AVX2
  if (__builtin_cpu_supports("avx2") != 0) return place_avx2;
#endif
  return place_portable;
}

}  // namespace

void place_points(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2* room) {
  static const Place place = fastest();
  place(table, p, d, room);
}

}  // namespace burin::curves::two_point
