#pragma once

#include <concepts>
#include <cstdint>

namespace burin {

/// One step of splitmix64 from state x. Source: reference curves A.7.
constexpr std::uint64_t mix(std::uint64_t x) {
  std::uint64_t z = x + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// Keyed randomness: 64 bits that depend on (seed, keys) alone, so neither order nor threads nor one level more can
/// change a draw. Negative keys wrap modulo 2^64.
template <std::integral... Keys>
constexpr std::uint64_t random_bits(std::uint64_t seed, Keys... keys) {
  std::uint64_t h = mix(seed);
  ((h = mix(h ^ static_cast<std::uint64_t>(keys))), ...);
  return h;
}

/// A double in [0, 1) from 64 random bits: the top 53.
constexpr double unit_interval(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// A double in the open interval (-1, 1) from 64 random bits; every step is exact.
constexpr double symmetric_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-51 - 1.0;
}

/// unit_interval of random_bits: the reference's u01(seed, keys...).
template <std::integral... Keys>
constexpr double uniform(std::uint64_t seed, Keys... keys) {
  return unit_interval(random_bits(seed, keys...));
}

/// symmetric_interval of random_bits: the reference's usym(seed, keys...).
template <std::integral... Keys>
constexpr double uniform_symmetric(std::uint64_t seed, Keys... keys) {
  return symmetric_interval(random_bits(seed, keys...));
}

}  // namespace burin
