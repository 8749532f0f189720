#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <burin/curves/text/font.hpp>
#include <burin/geom/box2.hpp>

namespace burin::curves::lettering {

/// An open polyline of one point or more.
using Stroke = std::vector<Vec2>;

/// A letter in units of its font: the baseline is y = 0, capitals reach units_per_cap, y up; the pen starts at x = 0
/// and goes on at x = advance.
struct Glyph {
  double advance = 0.0;
  std::vector<Stroke> strokes;

  Box2 box() const;
  std::size_t point_count() const;
};

inline constexpr double units_per_cap = 21.0;

/// The glyph of a character; nothing for those that the fonts have not. All fonts have the same: printable ASCII,
/// Latin-1, the accented letters of Latin Extended-A and common marks. Letters of ASCII are Hershey's, others are put
/// together from them and from strokes of ours (recipes.hpp). O(points of the glyph).
std::optional<Glyph> glyph_of(Font font, char32_t character);

}  // namespace burin::curves::lettering
