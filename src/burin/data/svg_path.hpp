#pragma once

#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::data {

/// One subpath of an SVG path, flattened.
struct Subpath {
  std::vector<Vec2> points;
  bool closed = false;  ///< ended by Z; the first point is not repeated
};

/// The subpaths of SVG path data (all of MmLlHhVvCcSsQqTtAaZz), curves flattened so that no chord is farther than
/// `tolerance` from its curve (see flatten.hpp for tiny ones). Coordinates as written, y down. A moveto that nothing
/// follows draws nothing. A problem gives the place in the data, added to `where`. At most 65,536 commands and 2^20
/// points, every number within 1e12.
/// Source: SVG 1.1, chapter 8 and appendix F.6.
Result<std::vector<Subpath>> parse_svg_path(std::string_view d, double tolerance, const Where& where);

}  // namespace burin::data
