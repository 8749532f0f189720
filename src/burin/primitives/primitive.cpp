#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <burin/data/svg/paths.hpp>
#include <burin/geom/affine2.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_path.hpp>
#include <burin/primitives/primitive.hpp>

namespace burin::primitives {

namespace {

/// "leaf" of "figures/leaf.svg".
std::string stem(const std::string& file) {
  const std::size_t slash = file.find_last_of('/');
  std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  if (dot != std::string::npos && dot > 0) name.resize(dot);
  return name;
}

/// Turns y up and the anchor's direction with it.
Affine2 upright_from_px(const data::SvgDrawing& drawing) {
  const Vec2 at = drawing.anchor ? drawing.anchor->at : drawing.box().center();
  const Affine2 about_anchor = scaling(1.0, -1.0) * translation(-at);
  if (!drawing.anchor || !drawing.anchor->up) return about_anchor;
  const Vec2 up = about_anchor.linear(*drawing.anchor->up);
  const Vec2 turn = (1.0 / length(up)) * Vec2{up.y, up.x};  // as complex numbers: i / up
  return Affine2{turn.x, turn.y, -turn.y, turn.x, 0.0, 0.0} * about_anchor;
}

constexpr std::array paints{Paint::stroke, Paint::fill_nonzero, Paint::fill_evenodd};  // as SvgPath::Paint

/// A sink that records or measures never stops.
void draw(const std::vector<data::SvgPath>& paths, PathSink& sink) {
  for (const data::SvgPath& path : paths) {
    const PathHead head{.paint = paints[static_cast<std::size_t>(path.paint)], .closed = path.closed};
    static_cast<void>(draw_path(sink, head, path.contours));
  }
}

}  // namespace

std::optional<Primitive> primitive_of(const data::SvgDrawing& drawing, std::string name) {
  const Affine2 upright = upright_from_px(drawing);
  BoundsSink bounds;
  Mapped measured(bounds, upright);
  const std::vector<data::SvgPath> paths = data::svg_paths(drawing, data::SvgParts::all);
  draw(paths, measured);
  if (bounds.box().empty()) return std::nullopt;
  const double side = std::max(bounds.box().width(), bounds.box().height());
  const double unit = side > 0.0 ? 1.0 / side : 1.0;
  Recorder recorder;
  Mapped mapped(recorder, scaling(unit, unit) * upright);
  draw(paths, mapped);
  const data::SvgAbout& about = drawing.about;
  return Primitive{name,          about.title.empty() ? name : about.title,       about.subject, about.creator,
                   about.licence, std::make_shared<const Figure>(recorder.take())};
}

Result<Primitive> read_primitive_svg(std::string_view text, const std::string& file, double tolerance,
                                     Leftovers leftovers) {
  Result<data::SvgDrawing> drawing = data::read_svg(text, file, tolerance);
  if (!drawing) return drawing.problems();
  if (leftovers == Leftovers::are_errors && !drawing->not_drawn.empty()) return std::move(drawing->not_drawn);
  std::optional<Primitive> primitive = primitive_of(*drawing, stem(file));
  if (!primitive) return Problem{{file}, "draws nothing: no shape in it has a stroke or a fill that can be seen"};
  return *std::move(primitive);
}

}  // namespace burin::primitives
