#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <burin/base/result.hpp>
#include <burin/data/svg/drawing.hpp>
#include <burin/path/recording.hpp>

namespace burin::primitives {

/// A small figure to be put at points with a size and a turn. Its own coordinates: y up, the anchor at the origin, "up"
/// along +y, and the longer side of the box of its lines exactly 1; a single dot has no size. Paths have layer 0; each
/// keeps its own paint and whether it is closed.
struct Primitive {
  std::string name;
  std::string title;
  std::string family;   ///< "leaves"; empty for one's own without dc:subject
  std::string creator;  ///< who drew it
  std::string licence;
  std::shared_ptr<const Figure> figure = std::make_shared<const Figure>(Recording{});

  std::size_t point_count() const { return figure->drawing().all_points().size(); }
};

/// How far chords miss the curves of a figure, in its own units: 0.01 mm at a size of 40 mm.
inline constexpr double figure_tolerance = 1.0 / 4000.0;

/// What to make of what an SVG holds besides shapes.
enum class Leftovers : bool { are_errors, are_left_out };

/// A figure from an SVG. The object whose label (in Inkscape) or id is "anchor" is not drawn: its middle is the anchor,
/// and where it is a line its start, with "up" along it; without one the middle of the drawing's box is the anchor, and
/// up is up. A shape that is filled gives a filled path, one that is stroked a stroke, dashes cut; colours and widths
/// are the pen's affair. Problems carry `file` and the line: as read_svg's; text, pictures, gradients, clip paths ...
/// unless they are left out; nothing to draw.
Result<Primitive> read_primitive_svg(std::string_view text, const std::string& file,
                                     double tolerance = figure_tolerance, Leftovers leftovers = Leftovers::are_errors);

/// The same from an SVG that was read. `name` is also the title when the SVG has none. Nothing when it draws nothing.
std::optional<Primitive> primitive_of(const data::SvgDrawing& drawing, std::string name);

}  // namespace burin::primitives
