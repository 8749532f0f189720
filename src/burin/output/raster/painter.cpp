#include <algorithm>

#include <burin/base/check.hpp>
#include <burin/geom/clip.hpp>
#include <burin/output/raster/painter.hpp>

namespace burin::output::raster {

namespace {

Box2 page_in_pixels(const Page& page, double dots_per_mm) {
  return {{0.0, 0.0}, {page.width_mm * dots_per_mm, page.height_mm * dots_per_mm}};
}

}  // namespace

Painter::Painter(const Sheet& sheet, double dots_per_mm, const PixelBox& part, const Kernel& kernel, RowShare share)
    : sheet_(sheet),
      dots_per_mm_(dots_per_mm),
      page_(page_in_pixels(sheet.page, dots_per_mm).grown(1.0)),  // the last pixel may lie half outside
      ink_(part, kernel, share),
      picture_(part, sheet.page.paper, ink_.memory()),
      stroker_(ink_, page_),
      dashes_(stroker_) {}

Flow Painter::begin(const PathHead& head) {
  head_ = head;
  if (head.role == Role::mask) return Flow::go;
  if (layer_ != head.layer) enter_layer(head.layer);
  begin_contour();
  return Flow::go;
}

Flow Painter::points(std::span<const Vec2> points) {
  if (head_.role == Role::mask) return Flow::go;
  if (!strokes()) {
    for (const Vec2 p : points) polygon_.push_back(device_point(p, dots_per_mm_));
  } else {
    dashes_.to(points, dots_per_mm_);
  }
  return Flow::go;
}

Flow Painter::contour() {
  if (head_.role == Role::mask) return Flow::go;
  end_contour();
  begin_contour();
  return Flow::go;
}

Flow Painter::end() {
  if (head_.role == Role::mask) return Flow::go;
  end_contour();
  if (!strokes()) ink_.add(fill_, head_.paint == Paint::fill_evenodd);
  return Flow::go;
}

void Painter::finish() {
  if (layer_) leave_layer();
  layer_.reset();
}

void Painter::enter_layer(LayerId layer) {
  BURIN_EXPECT(layer < sheet_.layers.size());
  if (layer_) leave_layer();
  layer_ = layer;
  const SheetLayer& style = sheet_.layers[layer];
  stroker_.set_style({sheet_.pens[style.pen].width_mm * dots_per_mm_, style.cap, style.join, style.miter_limit});
  std::vector<double> lengths = style.dashes_mm;
  for (double& length : lengths) length *= dots_per_mm_;
  dashes_.set_pattern(lengths, style.dash_offset_mm * dots_per_mm_);
}

void Painter::leave_layer() {
  const SheetLayer& style = sheet_.layers[*layer_];
  picture_.lay_over(ink_.tiles(), ink_.kernel(), sheet_.pens[style.pen].colour, style.opacity);
}

void Painter::begin_contour() {
  if (strokes()) dashes_.begin(head_.closed);
}

void Painter::end_contour() {
  if (strokes()) return dashes_.end();
  // Two pixels hide the edges along which a polygon is cut off.
  const Box2 box = page_.grown(2.0);
  if (!std::all_of(polygon_.begin(), polygon_.end(), [&](Vec2 p) { return box.contains(p); })) {
    clip_polygon(polygon_, spare_, box);
  }
  rounded_.clear();
  for (const Vec2 p : polygon_) rounded_.push_back(nearest_point(p));
  fill_.add_contour(rounded_);
  polygon_.clear();
}

}  // namespace burin::output::raster
