#pragma once

#include <span>

#include <burin/geom/box2.hpp>
#include <burin/primitives/primitive.hpp>

namespace burin::primitives {

/// A figure to be shown in a part of a page.
struct FigurePicture {
  const Primitive* primitive = nullptr;  ///< not null
  Box2 area_mm;                          ///< on the page, y down; its middle shows the middle of the figure
};

/// A page for pictures, with the pens and layers that draw_pictures draws on, and `pen_mm` as the figures' pen. Layers
/// of one's own may be added behind them.
Sheet picture_sheet(const Page& page, double pen_mm);

/// Draws each figure as large as its area allows, but at most `unit_mm` for its unit, with its anchor as a small cross
/// and an arrow that points up. Pre: the sheet is a picture_sheet; the areas have a width and a height. O(points).
Flow draw_pictures(std::span<const FigurePicture> pictures, double unit_mm, PathSink& sink);

}  // namespace burin::primitives
