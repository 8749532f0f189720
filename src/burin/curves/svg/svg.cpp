#include <utility>
#include <vector>

#include <burin/curves/svg/svg.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_path.hpp>

namespace burin::curves {

namespace {

/// How far chords miss the curves, in shares of the drawing's longer side: 0.01 mm on A4's.
constexpr double svg_tolerance = 1.0 / 30000.0;
constexpr double mm_per_px = 25.4 / 96.0;

/// Draws every path under its own paint.
Flow draw_paths(const SvgParams& params, const Affine2& sink_from_model, PathSink& sink) {
  constexpr std::array paints{Paint::stroke, Paint::fill_nonzero, Paint::fill_evenodd};  // as SvgPath::Paint
  const double height_mm = params.file.drawing->size_px.y * mm_per_px;
  Mapped mapped(sink, sink_from_model * translation({0.0, height_mm}) * scaling(mm_per_px, -mm_per_px));
  for (const data::SvgPath& path : data::svg_paths(*params.file.drawing, params.parts)) {
    const PathHead head{.paint = paints[static_cast<std::size_t>(path.paint)], .closed = path.closed};
    if (draw_path(mapped, head, path.contours) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

struct SvgFamily {
  using Params = SvgParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    const params::Value* file = table.find("file");
    const params::Value* family = table.find("family");
    if (file == nullptr) {
      context.report(family == nullptr ? Where{} : family->where, "an svg needs 'file': the name of the SVG");
      return false;
    }
    const data::SvgDrawing& drawing = *params.file.drawing;
    if (!params.partial && !drawing.not_drawn.empty()) {
      context.problems.insert(context.problems.end(), drawing.not_drawn.begin(), drawing.not_drawn.end());
      context.report(file->where,
                     "not all of the SVG can be drawn; change it as said, or write partial = true to draw the "
                     "rest");
      return false;
    }
    if (!data::svg_paths(drawing, params.parts).empty()) return true;
    context.report(file->where, drawing.shapes.empty() ? "the SVG draws nothing: no shape in it can be seen"
                                                       : "the SVG has none of these 'parts'");
    return false;
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext&, const Affine2& frame) {
    BoundsSink bounds;
    static_cast<void>(draw_paths(params, frame, bounds));
    return bounds.box();
  }

  static Forecast forecast(const Params& params, const DrawContext&, double) {
    double points = 0.0;
    for (const data::SvgPath& path : data::svg_paths(*params.file.drawing, params.parts)) {
      for (const std::vector<Vec2>& contour : path.contours) points += static_cast<double>(contour.size());
    }
    return {points, points, true};
  }

  /// As a figure, whose paths keep their own paint; outlines as lines that the layer may fill.
  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    const Affine2 moved = translation(-context.origin);
    if (params.parts == data::SvgParts::outlines) return draw_paths(params, moved, sink);
    Recorder recorder;
    static_cast<void>(draw_paths(params, moved, recorder));
    return sink.place({}, Figure(recorder.take()), {});
  }

  static bool uses_seed(const Params&) { return false; }
};

}  // namespace

Family svg_family() {
  return make_family<SvgFamily>("svg", "the lines and areas of an SVG file, drawn with the layer's pen",
                                "Scalable Vector Graphics 1.1 (W3C, 2011)", "file");
}

}  // namespace burin::curves

namespace burin::params {

bool ValueType<curves::SvgFile>::read(const Value& value, curves::SvgFile& file, ReadContext& context) {
  const std::string* name = value.text();
  if (name == nullptr) return report_kind(value, "the name of an SVG file", context);
  const Result<std::string> text = context.read_file(*name);
  if (!text) {
    const Problem& problem = text.problems().front();
    context.report(value.where,
                   problem.where.file.empty() ? problem.message : "'" + problem.where.file + "' " + problem.message);
    return false;
  }
  Result<data::SvgDrawing> drawing = data::read_svg(*text, *name, curves::svg_tolerance);
  if (!drawing) {
    context.problems.insert(context.problems.end(), drawing.problems().begin(), drawing.problems().end());
    return false;
  }
  file = {*name, std::make_shared<const data::SvgDrawing>(*std::move(drawing))};
  return true;
}

}  // namespace burin::params
