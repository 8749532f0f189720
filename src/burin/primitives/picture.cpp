#include <algorithm>
#include <array>

#include <burin/base/check.hpp>
#include <burin/path/draw_path.hpp>
#include <burin/primitives/picture.hpp>

namespace burin::primitives {

namespace {

constexpr LayerId anchor_layer = 0;
constexpr LayerId figure_layer = 1;

/// Arms of the cross at the anchor and the arrow on it, in shares of the unit.
constexpr double arm = 0.035;
constexpr double arrow = 0.11;
constexpr double barb = 0.025;

/// The box of a figure in its own units, never without an extent.
Box2 box_of(const Primitive& primitive) {
  const Box2 box = primitive.figure->drawing().bounds();
  return box.width() > 0.0 || box.height() > 0.0 ? box : box.grown(0.5);
}

Affine2 page_from_figure(const FigurePicture& picture, double unit_mm) {
  const Box2 box = box_of(*picture.primitive);
  double scale = unit_mm;
  if (box.width() > 0.0) scale = std::min(scale, picture.area_mm.width() / box.width());
  if (box.height() > 0.0) scale = std::min(scale, picture.area_mm.height() / box.height());
  return translation(picture.area_mm.center()) * scaling(scale, -scale) * translation(-box.center());
}

Flow draw_anchor(const Affine2& page_from_unit, PathSink& sink) {
  const std::array<std::vector<Vec2>, 3> strokes{
      {{{-arm, 0.0}, {arm, 0.0}},
       {{0.0, -arm}, {0.0, arrow}},
       {{-barb, arrow - 1.4 * barb}, {0.0, arrow}, {barb, arrow - 1.4 * barb}}}};
  for (std::vector<Vec2> stroke : strokes) {
    for (Vec2& p : stroke) p = page_from_unit(p);
    if (draw_path(sink, {.layer = anchor_layer}, {&stroke, 1}) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

}  // namespace

Sheet picture_sheet(const Page& page, double pen_mm) {
  Sheet sheet{page, {{"anchor", {200, 60, 35}, 0.6 * pen_mm}, {"figure", {25, 25, 25}, pen_mm}}, {}, {}};
  sheet.layers = {{.name = "anchor", .pen = 0}, {.name = "figure", .pen = 1}};
  return sheet;
}

Flow draw_pictures(std::span<const FigurePicture> pictures, double unit_mm, PathSink& sink) {
  for (const FigurePicture& picture : pictures) {
    BURIN_EXPECT(picture.primitive != nullptr && picture.area_mm.width() > 0.0 && picture.area_mm.height() > 0.0);
    if (draw_anchor(page_from_figure(picture, unit_mm), sink) == Flow::stop) return Flow::stop;
  }
  for (const FigurePicture& picture : pictures) {
    const Affine2 at = page_from_figure(picture, unit_mm);
    if (sink.place({.layer = figure_layer}, *picture.primitive->figure, at) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

}  // namespace burin::primitives
