#pragma once

#include <burin/data/image.hpp>
#include <burin/geom/box2.hpp>

/// How ink lies on a page: what makes a picture airy or a blot.
namespace burin::measure {

/// Shares of the live area, in [0, 1], and margins.
struct PageInk {
  double ink = 0.0;      ///< what is covered
  double dense = 0.0;    ///< of the windows, those that are more than 60 % ink
  double empty = 0.0;    ///< of the windows, those without ink
  double darkest = 0.0;  ///< ink of the darkest window
  double left_mm = 0.0;  ///< from the edge of the page to the first ink; the whole width when there is none
  double right_mm = 0.0;
  double top_mm = 0.0;
  double bottom_mm = 0.0;
};

/// The side of the windows, in millimetres.
inline constexpr double window_mm = 5.0;

/// `page` is a picture of the whole page, its ink black on white: how dark a pixel is says how much of it is covered.
/// Windows are whole ones in `live_mm`, millimetres from the top left corner. A window without ink, and an edge of the
/// ink, have less than 2 % of a pixel. O(pixels). Pre: pixels_per_mm > 0.
PageInk page_ink(const data::Image& page, double pixels_per_mm, const Box2& live_mm);

}  // namespace burin::measure
