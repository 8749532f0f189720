#pragma once

#include <cstdint>
#include <vector>

#include <burin/data/svg/drawing.hpp>

namespace burin::data {

/// What a pen can draw of an SVG.
struct SvgPath {
  enum class Paint : std::uint8_t { stroke, fill_nonzero, fill_evenodd };
  Paint paint = Paint::stroke;
  bool closed = false;
  std::vector<std::vector<Vec2>> contours;  ///< at least one, none empty; pixels, y down
};

/// Which paths are made of a shape.
enum class SvgParts : std::uint8_t {
  all,      ///< as the SVG paints: an area where it fills, lines where it strokes
  fills,    ///< its areas only
  strokes,  ///< its lines only
  outlines  ///< every contour once as a line, whatever the SVG does with it
};

/// The paths of a drawing, in the order in which the SVG draws them: of a shape first its area, then its strokes, one
/// path each, cut into dashes where they are dashed. The closed contours of an outline are one path together.
std::vector<SvgPath> svg_paths(const SvgDrawing& drawing, SvgParts parts);

}  // namespace burin::data
