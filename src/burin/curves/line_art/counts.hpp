#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <burin/curves/line_art/draws.hpp>
#include <burin/curves/line_art/line_art.hpp>

/// What both models count alike in the plane and in space.
namespace burin::curves::line_art {

/// The segments of polyline `line` of the first model. Source: reference curves G.1.
inline std::size_t segment_count(const CountRange& segments, std::uint64_t seed, std::uint64_t line) {
  const auto choices = static_cast<double>(segments.high - segments.low + 1);
  const double more = std::floor(uniform(seed, draws::count, line) * choices);
  return static_cast<std::size_t>(segments.low) + static_cast<std::size_t>(more);
}

/// The points of a chord refined so many times.
inline std::size_t refined_count(int levels, std::size_t markers) {
  std::size_t edges = 1;
  for (int level = 0; level < levels; ++level) edges *= markers + 1;
  return edges + 1;
}

/// How far the refinement of chords of at most this length leaves them, generously. P are a boundary model's
/// parameters.
template <class P>
double refined_reach(const P& params, double longest) {
  // An edge moves by one offset at most, and its parts are as long as itself and two offsets.
  double moved = 0.0;
  double bound = params.offset;
  for (int level = 1; level <= params.levels; ++level) {
    const double offset = params.unit == Offset::relative ? bound * longest : bound;
    moved += offset;
    longest += 2.0 * offset;
    bound *= params.decay;
  }
  return moved + longest;  // rounding stays within an edge of the polyline
}

}  // namespace burin::curves::line_art
