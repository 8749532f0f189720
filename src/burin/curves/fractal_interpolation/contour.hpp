#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <burin/geom/vec2.hpp>

/// Plane curves as two functions of one parameter. Source: reference interpolation 7.
namespace burin::curves::fractal_interpolation {

/// The length of the chords up to each point over that of all: from 0 to 1. Pre: two points at least, no point repeats
/// its predecessor.
std::vector<double> chord_parameters(std::span<const Vec2> points);

/// The length of a polyline.
double chord_length(std::span<const Vec2> points);

/// Indices of the points nearest to equal steps of t, the first and the last among them: n + 1, or fewer where several
/// steps have the same nearest point. Pre: t increases.
std::vector<std::size_t> spread_knots(std::span<const double> t, int intervals);

/// x = (longitude - mean longitude) cos(mean latitude), y = latitude, all in degrees.
void project_from_degrees(std::vector<Vec2>& longitudes_latitudes);

}  // namespace burin::curves::fractal_interpolation
