#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/geom/vec2.hpp>
#include <burin/params/read_value.hpp>

namespace burin::curves {

/// How an open polyline is rounded; its ends stay where they are.
enum class Smoothing : std::uint8_t {
  none,
  corners,    ///< corner cutting at 1/4 and 3/4 of every edge (Chaikin): a quadratic spline, within the polyline's hull
  four_point  ///< through the given points (Dyn, Gregory and Levin, w = 1/16), ends reflected
};

constexpr auto words(Smoothing) {
  return std::array<params::Word<Smoothing>, 3>{
      {{"none", Smoothing::none}, {"corners", Smoothing::corners}, {"four-point", Smoothing::four_point}}};
}

/// Refines the polyline so many times. Fewer than three points are left alone. `spare` is working memory.
void smooth(std::vector<Vec2>& points, Smoothing smoothing, int levels, std::vector<Vec2>& spare);

/// How many points smooth() makes of so many.
double smoothed_count(std::size_t points, Smoothing smoothing, int levels);

}  // namespace burin::curves
