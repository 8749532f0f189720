#pragma once

#include <optional>
#include <string_view>

#include <burin/data/xml.hpp>
#include <burin/geom/affine2.hpp>
#include <burin/geom/box2.hpp>

namespace burin::data::svg {

/// The map that a `transform` lists: matrix, translate, scale, rotate, skewX, skewY. Nothing when it is anything else.
/// Source: SVG 1.1, 7.6.
std::optional<Affine2> parse_transform(std::string_view text);

/// The most that a map stretches a length: its larger singular value.
double largest_stretch(const Affine2& map);

/// The map from the `viewBox` and `preserveAspectRatio` of an element to a viewport of this size at the origin; the
/// identity without a viewBox. Nothing when one of them cannot be read, or the box has no area. Source: SVG 1.1, 7.7.
std::optional<Affine2> viewport_from_view_box(const XmlElement& element, Vec2 viewport_px);

}  // namespace burin::data::svg
