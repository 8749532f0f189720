#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <burin/base/random.hpp>
#include <burin/expr/noise.hpp>

namespace burin::expr {

namespace {

/// Any constant would do; changing it changes every drawing that uses noise.
constexpr std::uint64_t noise_key = 0x6e6f697365;

/// The height at (dx, dy) from lattice point (i, j) of the plane through it with that point's slope: a unit vector in
/// one of 16 directions.
double slope_at(std::int64_t i, std::int64_t j, double dx, double dy) {
  constexpr std::array<double, 5> cosines{1.0, 0.9238795325112867, 0.7071067811865476, 0.3826834323650898, 0.0};
  const std::uint64_t bits = random_bits(noise_key, i, j);
  const std::uint64_t eighth = bits & 3U;  // of half a turn; then a quarter turn, then half a turn
  if ((bits & 4U) != 0) dx = std::exchange(dy, -dx);
  const double height = cosines[eighth] * dx + cosines[4 - eighth] * dy;
  return (bits & 8U) != 0 ? -height : height;
}

/// 0 at 0, 1 at 1, with two vanishing derivatives at both.
double fade(double t) {
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

double between(double a, double b, double t) {
  return a + t * (b - a);
}

}  // namespace

double noise(double x, double y) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  constexpr double lattice_only = 0x1p52;
  if (std::abs(x) >= lattice_only || std::abs(y) >= lattice_only) return 0.0;
  const double left = std::floor(x);
  const double low = std::floor(y);
  const auto i = static_cast<std::int64_t>(left);
  const auto j = static_cast<std::int64_t>(low);
  const double dx = x - left;
  const double dy = y - low;
  const double u = fade(dx);
  const double below = between(slope_at(i, j, dx, dy), slope_at(i + 1, j, dx - 1.0, dy), u);
  const double above = between(slope_at(i, j + 1, dx, dy - 1.0), slope_at(i + 1, j + 1, dx - 1.0, dy - 1.0), u);
  const double height = between(below, above, fade(dy));
  constexpr double steepest = 0.7071067811865476;  // the bound of the height between unit slopes
  return std::clamp(height / steepest, -1.0, 1.0);
}

}  // namespace burin::expr
