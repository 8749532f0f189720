#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <burin/base/angle_reduction.hpp>

namespace burin::math {

namespace {

/// Up to here a quotient by pi/2 has at most 20 bits, and its products with the parts below are exact.
constexpr double largest_small_angle = 0x1p20;

/// pi/2 in three parts of 33 bits and a rest: 152 bits.
constexpr std::array<double, 4> half_pi_parts{0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                              0x1.b839a252049c1p-104};
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

/// Cody and Waite: subtracts a multiple of pi/2, part by part, each product exact.
ReducedAngle reduce_small(double radians) {
  const double multiple = nearest_integer(radians * two_over_pi);
  const double first = radians - multiple * half_pi_parts[0];
  const DoubleDouble second = two_sum(first, -multiple * half_pi_parts[1]);
  const DoubleDouble third = two_sum(second.lo, -multiple * half_pi_parts[2]);
  const DoubleDouble rest = two_sum(second.hi, third.hi);
  const double tail = rest.lo + (third.lo - multiple * half_pi_parts[3]);
  return {static_cast<int>(static_cast<std::int64_t>(multiple) & 3), two_sum(rest.hi, tail)};
}

/// The bits of 2/pi behind the binary point, in words of 32, after 64 zero bits.
constexpr int leading_zero_bits = 64;
constexpr std::array<std::uint32_t, 42> two_over_pi_words{
    0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab,
    0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f, 0xef2f118b,
    0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea,
    0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d};

using Words = std::array<std::uint32_t, 8>;  ///< 256 bits, the least significant word first

/// The 256 bits of two_over_pi_words from bit `begin` on.
Words window(int begin) {
  const auto word = static_cast<std::size_t>(begin / 32);
  const int shift = begin % 32;
  Words bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::uint64_t high = two_over_pi_words[word + i];
    const std::uint64_t low = two_over_pi_words[word + i + 1];
    bits[bits.size() - 1 - i] = static_cast<std::uint32_t>((high << 32U | low) >> (32 - shift));
  }
  return bits;
}

/// a * b modulo 2^256, b shifted up by `word` words, added to `sum`.
void add_product(Words& sum, const Words& a, std::uint32_t b, std::size_t word) {
  std::uint64_t carry = 0;
  for (std::size_t i = word; i < sum.size(); ++i) {
    carry += std::uint64_t{a[i - word]} * b + sum[i];
    sum[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
}

void negate(Words& a) {
  std::uint64_t carry = 1;
  for (std::uint32_t& word : a) {
    carry += static_cast<std::uint32_t>(~word);
    word = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
}

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// Payne and Hanek: |radians| = m 2^e; only those bits of 2/pi matter whose product with m 2^e is below 4, and 254 bits
/// behind the binary point leave more than 130 correct ones even for the double closest to a multiple of pi/2.
/// Pre: |radians| >= 2^20.
ReducedAngle reduce_large(double radians) {
  const auto bits = std::bit_cast<std::uint64_t>(radians);
  const int e = static_cast<int>(bits >> 52U & 0x7FFU) - 1075;
  const std::uint64_t m = (bits & 0xFFFFFFFFFFFFFU) | 0x10000000000000U;

  // Bit i (1, 2 ...) behind the binary point of 2/pi weighs 2^(e - i) in the quotient; the first one kept weighs 2.
  const Words two_over_pi_bits = window(leading_zero_bits + e - 2);
  Words quotient{};  // modulo 4, in units of 2^-254
  add_product(quotient, two_over_pi_bits, static_cast<std::uint32_t>(m), 0);
  add_product(quotient, two_over_pi_bits, static_cast<std::uint32_t>(m >> 32U), 1);

  int quadrant = static_cast<int>(quotient.back() >> 30U);
  const bool upper_half = (quotient.back() & 0x20000000U) != 0;
  quotient.back() &= 0x3FFFFFFFU;
  if (upper_half) {  // the next multiple of pi/2 is nearer: count back from it
    negate(quotient);
    quotient.back() &= 0x3FFFFFFFU;
    ++quadrant;
  }
  DoubleDouble fraction;
  for (std::size_t i = quotient.size(); i-- > 0;) {
    fraction = fraction + quotient[i] * power_of_two(32 * static_cast<int>(i) - 254);
  }
  DoubleDouble rest = fraction * half_pi_pair;
  if (upper_half) rest = -rest;
  if (radians < 0.0) {
    rest = -rest;
    quadrant = -quadrant;
  }
  return {quadrant & 3, rest};
}

}  // namespace

ReducedAngle reduce_radians(double radians) {
  constexpr double quarter_pi = 0.5 * half_pi_pair.hi;
  if (std::abs(radians) <= quarter_pi) return {0, {radians, 0.0}};
  return std::abs(radians) < largest_small_angle ? reduce_small(radians) : reduce_large(radians);
}

ReducedAngle reduce_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);  // exact, as IEEE's remainder is
  const double multiple = nearest_integer(turn / 90.0);
  const double rest = turn - 90.0 * multiple;
  return {static_cast<int>(multiple) & 3, radians_per_degree_pair * rest};
}

}  // namespace burin::math
