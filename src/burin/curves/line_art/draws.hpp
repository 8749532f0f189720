#pragma once

#include <concepts>
#include <cstdint>

#include <burin/base/random.hpp>

/// What the draws of line art are for: the second key, after the seed, then the polyline. Up to `beta` these are the
/// numbers of reference curves G.1.
namespace burin::curves::line_art::draws {

inline constexpr std::uint64_t count = 1;
inline constexpr std::uint64_t heading = 2;
inline constexpr std::uint64_t turn = 3;
inline constexpr std::uint64_t length = 4;
inline constexpr std::uint64_t start_x = 5;
inline constexpr std::uint64_t start_y = 6;
inline constexpr std::uint64_t end_x = 7;
inline constexpr std::uint64_t end_y = 8;
inline constexpr std::uint64_t beta = 9;
inline constexpr std::uint64_t target = 10;
inline constexpr std::uint64_t bundle = 11;
inline constexpr std::uint64_t density = 12;
inline constexpr std::uint64_t chance = 13;
inline constexpr std::uint64_t start_z = 14;
inline constexpr std::uint64_t end_z = 15;

/// Draws whose first keys are mixed once: uniform(s) == burin::uniform(seed, purpose, line, s).
class Keyed {
 public:
  template <std::integral... Keys>
  explicit Keyed(std::uint64_t seed, Keys... first) : mixed_(random_bits(seed, first...)) {}

  template <std::integral... Keys>
  double uniform(Keys... rest) const {
    return unit_interval(bits(rest...));
  }
  template <std::integral... Keys>
  double symmetric(Keys... rest) const {
    return symmetric_interval(bits(rest...));
  }

 private:
  template <std::integral... Keys>
  std::uint64_t bits(Keys... rest) const {
    std::uint64_t h = mixed_;
    ((h = mix(h ^ static_cast<std::uint64_t>(rest))), ...);
    return h;
  }

  std::uint64_t mixed_;
};

}  // namespace burin::curves::line_art::draws
