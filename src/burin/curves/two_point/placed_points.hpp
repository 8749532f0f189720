#pragma once

#include <span>

#include <burin/geom/vec2.hpp>

namespace burin::curves::two_point {

/// Places points of the unit edge on the edge from p along d: room[k] = p + table[k] * d, as complex numbers. Room for
/// as many must be at `room`. The same bits on every machine, two at once where it has AVX2.
void place_points(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2* room);

}  // namespace burin::curves::two_point
