#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <burin/geom/vec2.hpp>

/// Square cells of the plane, and edges as walks through them.
namespace burin::curves::line_art {

struct Cell {
  std::int32_t column = 0;
  std::int32_t row = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    const auto column = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.column));
    return static_cast<std::size_t>(((column << 32U) | static_cast<std::uint32_t>(cell.row)) * 0x9E3779B97F4A7C15U >>
                                    8U);
  }
};

/// Pre: p lies within 2^31 cells of the origin.
inline Cell cell_of(Vec2 p, double side) {
  return {static_cast<std::int32_t>(std::floor(p.x / side)), static_cast<std::int32_t>(std::floor(p.y / side))};
}

/// Calls visit(from, to) for pieces of the edge from a to b, none longer than `longest`, until it says false. False
/// when it did, or when the edge is out of all proportion: over 100,000 pieces, or 10^9 away.
template <class Visit>
bool each_piece(Vec2 a, Vec2 b, double longest, const Visit& visit) {
  constexpr double most_pieces = 1e5;
  constexpr double most_cells = 1e9;
  for (const double coordinate : {a.x, a.y, b.x, b.y}) {
    if (!(std::abs(coordinate) < most_cells * longest)) return false;
  }
  const double pieces = std::max(1.0, std::ceil(distance(a, b) / longest));
  if (pieces > most_pieces) return false;
  Vec2 from = a;
  for (int piece = 1; piece <= static_cast<int>(pieces); ++piece) {
    const Vec2 to = piece == static_cast<int>(pieces) ? b : lerp(a, b, piece / pieces);
    if (!visit(from, to)) return false;
    from = to;
  }
  return true;
}

}  // namespace burin::curves::line_art
