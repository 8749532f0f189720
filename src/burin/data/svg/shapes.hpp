#pragma once

#include <vector>

#include <burin/base/result.hpp>
#include <burin/data/svg_path.hpp>
#include <burin/data/xml.hpp>

namespace burin::data::svg {

/// Whether a tag is one of SVG's shapes: path, rect, circle, ellipse, line, polyline, polygon.
bool is_shape(std::string_view tag);

/// The outline of a shape in its own coordinates, y down; none when a size of it is 0. Lengths in percent are of
/// `viewport_px`. Curves keep to `tolerance`. A problem says what is wrong with its attributes.
/// Source: SVG 1.1, chapters 8 and 9.
Result<std::vector<Subpath>> shape_outline(const XmlElement& element, Vec2 viewport_px, double tolerance);

}  // namespace burin::data::svg
