#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <burin/expr/expression.hpp>
#include <burin/geom/affine2.hpp>
#include <burin/geom/vec2.hpp>

/// Position control: what an expression Z = f(x, y) over a drawing knows of the place it is asked about.
namespace burin::primitives {

/// The variables, in this order: x y r phi (model units, degrees), px py pr (mm from the slot's centre, y up), u v
/// (0..1 in the slot), level, index (of the point or edge in its path, from 0), angle (of the edge), i j copy (of the
/// copy), rand (uniform in [0, 1)), edge tangent normal (directions in degrees: of the edge that leaves, of the
/// bisector of both edges, and 90 degrees to its right), length (mean of both edges, in mm), random (a direction at
/// random). Chances hang on the seed, the level, the path and the index, so that symmetric copies are alike.
inline constexpr std::array<std::string_view, 21> position_variables{
    "x",     "y", "r", "phi",  "px",   "py",   "pr",      "u",      "v",      "level", "index",
    "angle", "i", "j", "copy", "rand", "edge", "tangent", "normal", "length", "random"};

/// The place of a variable in that list. Pre: it is there.
consteval std::size_t position_variable(std::string_view name) {
  std::size_t at = 0;
  while (position_variables[at] != name) ++at;
  return at;
}

using PositionValues = std::array<double, position_variables.size()>;
using PositionUse = std::bitset<position_variables.size()>;

/// Which variables an expression over position_variables needs.
PositionUse used_by(const expr::Expression& expression);

/// Where one copy of a drawing lies.
struct Setting {
  Affine2 slot_from_model{};  ///< to mm from the slot's centre, y up; a similarity
  double slot_width_mm = 1.0;
  double slot_height_mm = 1.0;
  int column = 0;  ///< of the grid
  int row = 0;
  int copy = 0;            ///< over all copies
  std::uint64_t seed = 0;  ///< shared by symmetric copies
  Vec2 origin{};           ///< of the points that come, in model units
};

/// A place on a path. At an open end, and inside an edge, `in` and `out` are the same.
struct Frame {
  Vec2 point;               ///< in model units, from the setting's origin
  Vec2 in;                  ///< the edge that arrives
  Vec2 out;                 ///< the edge that leaves
  std::uint64_t index = 0;  ///< of the point or the edge in its path
};

/// unit(in) + unit(out), or `out` where they cancel out. Source: reference curves H.
Vec2 tangent_of(const Frame& frame);

/// Which path a frame belongs to, for expressions and chances.
struct PathPlace {
  std::uint16_t level = 0;
  std::uint64_t path = 0;  ///< contours of the level before this one
};

/// The values of the variables that are used; the others are 0.
PositionValues position_values(const Setting& setting, const PathPlace& place, const Frame& frame,
                               const PositionUse& used);

}  // namespace burin::primitives
