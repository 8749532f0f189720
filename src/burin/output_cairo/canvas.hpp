#pragma once

#include <optional>
#include <span>
#include <vector>

#include <cairo.h>

#include <burin/output_cairo/stroker.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output_cairo {

/// How fine a surface is.
struct Resolution {
  double device_per_mm = 1.0;
  double grain = 0.0;  ///< device units; a stroke may leave out points that are no farther than this from the last one
};

/// Draws the layers of a sheet with Cairo, whatever the surface: all that PDF, PNG and SVG share.
///
/// Cairo's matrix stays the identity, since its vector surfaces write another one with every path; millimetres become
/// device units here. A layer with opacity is drawn as a group. Memory: one piece of a stroke, one whole filled path.
class Canvas {
 public:
  /// `to` and `sheet` must outlive the canvas. Pre: the page is at most `farthest` device units wide and high.
  Canvas(cairo_t* to, const Sheet& sheet, Resolution resolution);

  void paint_paper();

  /// The calls of PathSink, in its order.
  void begin(const PathHead& head);
  void points(std::span<const Vec2> points);
  void contour();
  void end();

  /// Completes the last layer.
  void finish();

 private:
  void set_colour(Colour colour);
  void enter_layer(LayerId layer);
  void leave_layer();
  void begin_contour();
  void end_contour();
  void fill_contour();

  cairo_t* to_;
  const Sheet& sheet_;
  double device_per_mm_;
  Box2 fill_box_;  ///< the page and a margin that hides the edges along which fills are cut off
  Stroker stroker_;
  std::optional<LayerId> layer_;
  PathHead head_;
  std::vector<Vec2> polygon_;  ///< the contour of a fill, in device units
  std::vector<Vec2> spare_;
};

}  // namespace burin::output_cairo
