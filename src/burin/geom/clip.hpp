#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/geom/vec2.hpp>

namespace burin {

/// `p` in device units, held below 1e300: a finite point stays finite.
inline Vec2 device_point(Vec2 p, double device_per_mm) {
  constexpr double most = 1e300;
  return {std::clamp(device_per_mm * p.x, -most, most), std::clamp(device_per_mm * p.y, -most, most)};
}

struct Segment {
  Vec2 from;
  Vec2 to;
};

/// The part of the segment a b inside `box`, cut at one border after the other; nothing when it misses the box. An end
/// that lies inside comes back unchanged. Any finite points: nothing overflows.
std::optional<Segment> clip_segment(Vec2 a, Vec2 b, const Box2& box);

/// Cuts a closed polygon down to `box` (Sutherland and Hodgman 1974): winding numbers inside the box stay as they are,
/// what lay outside runs along its border. Linear time; uses `spare` as working memory.
void clip_polygon(std::vector<Vec2>& polygon, std::vector<Vec2>& spare, const Box2& box);

}  // namespace burin
