#include <algorithm>
#include <memory>
#include <utility>

#include <burin/burin.hpp>
#include <burin/data/csv.hpp>
#include <burin/data/image.hpp>
#include <burin/data/svg/drawing.hpp>
#include <burin/path/decorators.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/formats.hpp>
#include <cli/measured_drawing.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

/// How fine the page is drawn to see its ink, and how large at most.
constexpr double ink_dots_per_mm = 8.0;
constexpr double most_dots = 6000.0;

bool ends_with(std::string_view word, std::string_view suffix) {
  if (word.size() < suffix.size()) return false;
  return std::equal(suffix.begin(), suffix.end(), word.end() - static_cast<std::ptrdiff_t>(suffix.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

/// Adds one path to a recording. A Recorder never says stop.
void record_path(Recorder& recorder, std::span<const Vec2> points, bool closed) {
  if (points.empty()) return;
  static_cast<void>(recorder.begin({.closed = closed}));
  static_cast<void>(recorder.points(points));
  static_cast<void>(recorder.end());
}

Result<MeasuredDrawing> read_csv_file(const std::string& path, bool closed) {
  const Result<std::string> text = read_file(path, path, data_limit_bytes);
  if (!text) return text.problems();
  Result<std::vector<std::vector<Vec2>>> paths = data::read_csv_paths(*text, path);
  if (!paths) return paths.problems();
  Recorder recorder;
  for (std::vector<Vec2>& points : *paths) {
    // As burin writes closed paths.
    const bool repeats_first = points.size() > 3 && points.front() == points.back();
    if (repeats_first) points.pop_back();
    record_path(recorder, points, closed || repeats_first);
  }
  return MeasuredDrawing{path, "units", recorder.take(), {}, {}};
}

Result<MeasuredDrawing> read_svg_file(const std::string& path) {
  constexpr double tolerance = 1e-5;  // of the drawing's longer side
  const Result<std::string> text = read_file(path, path, data_limit_bytes);
  if (!text) return text.problems();
  const Result<data::SvgDrawing> svg = data::read_svg(*text, path, tolerance);
  if (!svg) return svg.problems();
  Recorder recorder;
  for (const data::SvgShape& shape : svg->shapes) {
    for (const data::Subpath& subpath : shape.subpaths) {
      // y up, as in a preset: then turns and areas have the sign they are known by.
      std::vector<Vec2> points = subpath.points;
      for (Vec2& p : points) p.y = -p.y;
      record_path(recorder, points, subpath.closed);
    }
  }
  return MeasuredDrawing{path, "px", recorder.take(), {}, {}};
}

bool is_asked_for(const std::string& layer, const DrawRequest& request) {
  const auto names_it = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), layer) != names.end();
  };
  return (request.only.empty() || names_it(request.only)) && !names_it(request.skip);
}

/// Whether the layer shows the lines of what is asked for, each line once: a stroke, or a fill where there is none.
bool shows_lines(const SheetLayer& layer, const Sheet& sheet, const DrawRequest& request) {
  if (!is_asked_for(layer.name, request)) return false;
  return layer.paint == Paint::stroke ||
         std::none_of(sheet.layers.begin(), sheet.layers.end(), [&](const SheetLayer& other) {
           return other.name == layer.name && other.paint == Paint::stroke;
         });
}

/// The page as black ink on white paper.
Result<data::Image> black_and_white(const preset::Plan& plan, const preset::RunOptions& options, double dots_per_mm) {
  Sheet sheet = plan.sheet();
  sheet.page.paper = {255, 255, 255};
  for (Pen& pen : sheet.pens) pen.colour = {0, 0, 0};
  for (SheetLayer& layer : sheet.layers) layer.opacity = 1.0;
  const Result<const BackEnd*> png = choose_back_end("png", "native");
  if (!png) return png.problems();
  OutputOptions output;
  output.dots_per_mm = dots_per_mm;
  if (const Result<Done> accepted = (*png)->accepts(sheet, output); !accepted) return accepted.problems();
  StringSink bytes;
  const std::unique_ptr<OutputSink> sink = (*png)->open(bytes, sheet, output);
  preset::RunOptions run = options;
  run.tolerance_mm = (*png)->tolerance_mm(sheet, output);
  static_cast<void>(preset::run_for(
      *sink, [&](const preset::RunOptions& part) { return plan.run(*sink, part); }, run));
  if (const Result<Done> finished = sink->finish(); !finished) return finished.problems();
  return data::read_png(bytes.take(), "the page");
}

Result<MeasuredPage> measure_page(const preset::Plan& plan, const preset::PageSpec& page,
                                  const preset::RunOptions& lines, const DrawRequest& request) {
  MeasuredPage measured;
  measured.width_mm = page.size.width_mm;
  measured.height_mm = page.size.height_mm;
  measure::PathFiguresSink figures;
  preset::RunOptions on_page = lines;
  on_page.space = Space::page;
  static_cast<void>(plan.run(figures, on_page));
  measured.paths = figures.figures();

  preset::RunOptions everything;
  everything.wanted = [&request](const SheetLayer& layer) { return is_asked_for(layer.name, request); };
  const double dots_per_mm = std::min(ink_dots_per_mm, most_dots / std::max(measured.width_mm, measured.height_mm));
  const Result<data::Image> picture = black_and_white(plan, everything, dots_per_mm);
  if (!picture) return picture.problems();
  const Box2 live{{page.margin.left_mm, page.margin.top_mm},
                  {measured.width_mm - page.margin.right_mm, measured.height_mm - page.margin.bottom_mm}};
  measured.ink = measure::page_ink(*picture, dots_per_mm, live);
  return measured;
}

Result<MeasuredDrawing> measure_preset(const DrawRequest& request) {
  const Result<PresetText> text = read_preset(request.preset);
  if (!text) return text.problems();
  const Result<preset::Piece> piece = preset::load(text->source, request.overrides, data_reader(text->folder));
  if (!piece) return piece.problems();
  const Result<preset::Plan> plan = preset::Plan::make(*piece);
  if (!plan) return with_source(plan.problems(), *text);

  MeasuredDrawing measured;
  measured.name = text->stem;
  measured.units = "model units";
  preset::RunOptions lines;
  lines.space = Space::model;
  lines.wanted = [&](const SheetLayer& layer) { return shows_lines(layer, plan->sheet(), request); };
  if (const Result<Forecast> forecast = plan->check_size(lines, request.max_points); !forecast) {
    return with_source(forecast.problems(), *text);
  }
  Recorder recorder;
  static_cast<void>(plan->run(recorder, lines));
  measured.drawing = recorder.take();
  for (const preset::Layer& layer : piece->layers) {
    if (layer.family->limit_facts == nullptr || !is_asked_for(layer.style.name, request)) continue;
    measured.known.push_back({layer.style.name, layer.family->limit_facts(layer.parameters)});
  }
  Result<MeasuredPage> page = measure_page(*plan, piece->page, lines, request);
  if (!page) return page.problems();
  measured.page = *std::move(page);
  return measured;
}

}  // namespace

bool is_points_file(std::string_view word) {
  return ends_with(word, ".csv") || ends_with(word, ".svg");
}

Result<MeasuredDrawing> read_measured_drawing(const DrawRequest& request, bool closed) {
  if (ends_with(request.preset, ".csv")) return read_csv_file(request.preset, closed);
  if (ends_with(request.preset, ".svg")) return read_svg_file(request.preset);
  return measure_preset(request);
}

}  // namespace burin::cli
