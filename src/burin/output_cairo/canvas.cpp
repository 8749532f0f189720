#include <algorithm>
#include <cmath>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/geom/clip.hpp>
#include <burin/output_cairo/canvas.hpp>

namespace burin::output_cairo {

namespace {

StrokeStyle device_style(const SheetLayer& layer, const Pen& pen, double device_per_mm) {
  StrokeStyle style{pen.width_mm * device_per_mm,        layer.cap, layer.join, layer.miter_limit, layer.dashes_mm,
                    layer.dash_offset_mm * device_per_mm};
  for (double& dash : style.dashes) dash *= device_per_mm;
  return style;
}

Box2 device_page(const Page& page, double device_per_mm) {
  return {{0.0, 0.0}, {page.width_mm * device_per_mm, page.height_mm * device_per_mm}};
}

/// A colour's part from 0 to 1. Cairo writes six decimals and some readers of PDF cut off instead of rounding: rounded
/// up here, it comes back as the same of 255 steps in both.
double intensity(std::uint8_t of_255) {
  return std::ceil(of_255 / 255.0 * 1e6) / 1e6;
}

}  // namespace

Canvas::Canvas(cairo_t* to, const Sheet& sheet, Resolution resolution)
    : to_(to),
      sheet_(sheet),
      device_per_mm_(resolution.device_per_mm),
      fill_box_(device_page(sheet.page, device_per_mm_).grown(2.0)),
      stroker_(to, device_page(sheet.page, device_per_mm_), resolution.grain) {
  BURIN_EXPECT(fill_box_.width() <= farthest + 4.0 && fill_box_.height() <= farthest + 4.0);
}

void Canvas::paint_paper() {
  set_colour(sheet_.page.paper);
  cairo_paint(to_);
}

void Canvas::set_colour(Colour colour) {
  cairo_set_source_rgb(to_, intensity(colour.red), intensity(colour.green), intensity(colour.blue));
}

void Canvas::begin(const PathHead& head) {
  head_ = head;
  if (head.role == Role::mask) return;
  if (layer_ != head.layer) enter_layer(head.layer);
  begin_contour();
}

void Canvas::points(std::span<const Vec2> points) {
  if (head_.role == Role::mask) return;
  if (head_.paint == Paint::stroke) {
    stroker_.add(points, device_per_mm_);
  } else {
    for (const Vec2 p : points) polygon_.push_back(device_point(p, device_per_mm_));
  }
}

void Canvas::contour() {
  if (head_.role == Role::mask) return;
  end_contour();
  begin_contour();
}

void Canvas::end() {
  if (head_.role == Role::mask) return;
  end_contour();
  if (head_.paint == Paint::stroke) return;
  cairo_set_fill_rule(to_, head_.paint == Paint::fill_evenodd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  cairo_fill(to_);
}

void Canvas::finish() {
  if (layer_) leave_layer();
  layer_.reset();
}

void Canvas::enter_layer(LayerId layer) {
  BURIN_EXPECT(layer < sheet_.layers.size());
  if (layer_) leave_layer();
  layer_ = layer;
  const SheetLayer& style = sheet_.layers[layer];
  const Pen& pen = sheet_.pens[style.pen];
  if (style.opacity < 1.0) cairo_push_group(to_);
  set_colour(pen.colour);
  stroker_.set_style(device_style(style, pen, device_per_mm_));
}

void Canvas::leave_layer() {
  stroker_.flush();
  const double opacity = sheet_.layers[*layer_].opacity;
  if (opacity >= 1.0) return;
  cairo_pop_group_to_source(to_);
  cairo_paint_with_alpha(to_, opacity);
}

void Canvas::begin_contour() {
  if (head_.paint == Paint::stroke) {
    stroker_.begin_contour(head_.closed);
  } else {
    stroker_.flush();
  }
}

void Canvas::end_contour() {
  if (head_.paint == Paint::stroke) {
    stroker_.end_contour();
  } else {
    fill_contour();
  }
}

void Canvas::fill_contour() {
  if (!std::all_of(polygon_.begin(), polygon_.end(), [&](Vec2 p) { return fill_box_.contains(p); })) {
    clip_polygon(polygon_, spare_, fill_box_);
  }
  if (!polygon_.empty()) {
    cairo_move_to(to_, polygon_.front().x, polygon_.front().y);
    for (const Vec2 p : std::span(polygon_).subspan(1)) cairo_line_to(to_, p.x, p.y);
    cairo_close_path(to_);
  }
  polygon_.clear();
}

}  // namespace burin::output_cairo
