#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/measure/box_dimension.hpp>
#include <burin/measure/curve_distance.hpp>
#include <burin/measure/path_figures.hpp>
#include <cli/command.hpp>
#include <cli/json_text.hpp>
#include <cli/measure_plot.hpp>
#include <cli/measured_drawing.hpp>
#include <cli/page_file.hpp>

namespace burin::cli {

namespace {

using measure::BoxDimension;
using measure::CurveDistance;
using measure::PathFigures;

constexpr std::array option_rows{
    OptionRow{"knob", 'D', "NAME=VALUE", "turn a knob of the preset", true},
    OptionRow{"set", 0, "KEY=VALUE", "set any key of the preset", true},
    OptionRow{"seed", 0, "SEED", "seed of everything random"},
    OptionRow{"only", 0, "LAYER", "measure this layer only", true},
    OptionRow{"skip", 0, "LAYER", "leave this layer out", true},
    OptionRow{"closed", 0, "", "the points of a CSV file go around: the last one is joined to the first"},
    OptionRow{"against", 0, "FILE", "how far the curve is from the one of this preset, CSV or SVG file"},
    OptionRow{"plot", 0, "FILE", "draw the box counts and the line fitted to them"},
    OptionRow{"json", 0, "", "tell the numbers as JSON"},
    OptionRow{"max-points", 0, "N", "refuse to measure more points than this (5e7)"},
};

constexpr std::array examples{
    Example{"burin measure koch", "length, dimension, ink and air of a preset"},
    Example{"burin measure koch -D levels=7 --json", "the same for programs"},
    Example{"burin draw dragon -q -o d.csv && burin measure d.csv --plot counts.svg", "a curve from a file"},
};

/// All that was found out.
struct Measured {
  MeasuredDrawing source;
  PathFigures figures;
  Result<BoxDimension> boxes = Problem{};
  std::optional<CurveDistance> distance;
};

std::string number(double value) {
  return fmt::format("{:.9g}", value);
}

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string rows_text(const Rows& rows) {
  std::string text;
  for (const auto& [name, value] : rows) text += fmt::format("  {:<22}{}\n", name, value);
  return text;
}

std::string smoothness_text(const curves::Smoothness& smoothness) {
  std::string text = smoothness.proven < 0 ? "nothing proven" : fmt::format("C{} proven", smoothness.proven);
  if (smoothness.excluded) text += fmt::format(", C{} excluded", *smoothness.excluded);
  if (smoothness.exponent_high && *smoothness.exponent_high <= 0.0) return text;
  text += fmt::format(", H\u00f6lder exponent from {:.4f}", smoothness.exponent_low);
  return smoothness.exponent_high ? fmt::format("{} to {:.4f}", text, *smoothness.exponent_high) : text;
}

std::string dimension_text(const curves::FractalDimension& dimension) {
  std::string text = fmt::format("{:.4f} to {:.4f}", dimension.bounds.lower, dimension.bounds.upper);
  if (dimension.spectral) text += fmt::format(", spectral {:.4f}", *dimension.spectral);
  if (dimension.oscillation) text += fmt::format(", oscillations {:.4f}", *dimension.oscillation);
  return dimension.certificate ? fmt::format("{}, growth certified at level {}", text, *dimension.certificate) : text;
}

Rows curve_rows(const Measured& measured) {
  const PathFigures& f = measured.figures;
  const std::string& units = measured.source.units;
  Rows rows{{"paths", count_text(static_cast<double>(f.paths))},
            {"points", count_text(static_cast<double>(f.points))},
            {"length", fmt::format("{} {}", number(f.length), units)},
            {"edges", fmt::format("{}, from {} to {}", count_text(static_cast<double>(f.edges)),
                                  number(f.shortest_edge), number(f.longest_edge))}};
  if (!f.box.empty()) {
    rows.emplace_back("bounds", fmt::format("{}, {} to {}, {}", number(f.box.low.x), number(f.box.low.y),
                                            number(f.box.high.x), number(f.box.high.y)));
  }
  if (f.area != 0.0) rows.emplace_back("area", fmt::format("{} (counter-clockwise positive)", number(f.area)));
  rows.emplace_back("turning", fmt::format("{} degrees in all, {} without regard to sides",
                                           fixed_text(f.turn_degrees, 3), fixed_text(f.bend_degrees, 3)));
  if (measured.boxes) {
    const BoxDimension& fit = *measured.boxes;
    rows.emplace_back("box dimension",
                      fmt::format("{:.4f} +- {:.4f} (r2 {:.5f}, {} sizes of {}){}", fit.dimension, fit.standard_error,
                                  fit.r_squared, fit.scales.size(), fit.is_of_graph ? "columns" : "boxes",
                                  fit.is_of_few_edges ? ", of so few edges that of the polyline itself" : ""));
  }
  for (const KnownCurve& curve : measured.source.known) {
    const auto add = [&](const char* name, const std::string& text) {
      rows.emplace_back(name, fmt::format("{} ({})", text, curve.layer));
    };
    const curves::LimitFacts& facts = curve.facts;
    if (facts.similarity_dimension) add("similarity dimension", fmt::format("{:.6f}", *facts.similarity_dimension));
    if (facts.smoothness) add("smoothness", smoothness_text(*facts.smoothness));
    if (facts.fractal_dimension) add("fractal dimension", dimension_text(*facts.fractal_dimension));
  }
  if (measured.distance) {
    const CurveDistance& d = *measured.distance;
    rows.emplace_back("distance", fmt::format("{} rms, {} at most; {:.6f} of the longer side", number(d.rmse),
                                              number(d.farthest), d.rmse / d.extent));
  }
  return rows;
}

Rows page_rows(const MeasuredPage& page) {
  const measure::PageInk& ink = page.ink;
  return {{"page", fmt::format("{} x {} mm", shortest_text(page.width_mm), shortest_text(page.height_mm))},
          {"pen down", fmt::format("{:.2f} m", page.paths.length / 1000.0)},
          {"pen up", fmt::format("{:.2f} m between {} strokes", page.paths.travel / 1000.0,
                                 count_text(static_cast<double>(page.paths.contours)))},
          {"shortest edge", fmt::format("{:.3f} mm", page.paths.shortest_edge)},
          {"margins", fmt::format("{:.1f} mm left, {:.1f} right, {:.1f} top, {:.1f} foot", ink.left_mm, ink.right_mm,
                                  ink.top_mm, ink.bottom_mm)},
          {"ink", fmt::format("{:.1f} % of the live area", 100.0 * ink.ink)},
          {"air", fmt::format("{:.1f} % of its 5 mm windows are empty, {:.1f} % denser than 60 %, the darkest {:.0f} %",
                              100.0 * ink.empty, 100.0 * ink.dense, 100.0 * ink.darkest)}};
}

std::string as_text(const Measured& measured) {
  std::string text = measured.source.name + '\n' + rows_text(curve_rows(measured));
  if (measured.source.page) text += "on the page\n" + rows_text(page_rows(*measured.source.page));
  return text;
}

std::string json_list(std::initializer_list<double> numbers) {
  std::string text;
  for (const double each : numbers) text += fmt::format("{}{}", text.empty() ? "" : ", ", shortest_text(each));
  return '[' + text + ']';
}

void add_paths(JsonObject& json, const PathFigures& f) {
  json.add("paths", f.paths);
  json.add("points", f.points);
  json.add("edges", f.edges);
  json.add("length", f.length);
  json.add("shortest_edge", f.shortest_edge);
  json.add("longest_edge", f.longest_edge);
  if (!f.box.empty()) json.add_json("bounds", json_list({f.box.low.x, f.box.low.y, f.box.high.x, f.box.high.y}));
  json.add("area", f.area);
  json.add("turn_degrees", f.turn_degrees);
  json.add("bend_degrees", f.bend_degrees);
}

template <class T>
void add_optional(JsonObject& json, const char* key, const std::optional<T>& value) {
  if (value) {
    json.add(key, *value);
  } else {
    json.add_json(key, "null");
  }
}

std::string page_json(const MeasuredPage& page) {
  JsonObject json;
  json.add("width_mm", page.width_mm);
  json.add("height_mm", page.height_mm);
  json.add("length_mm", page.paths.length);
  json.add("travel_mm", page.paths.travel);
  json.add("strokes", page.paths.contours);
  json.add("shortest_edge_mm", page.paths.shortest_edge);
  json.add_json("margins_mm", json_list({page.ink.top_mm, page.ink.right_mm, page.ink.bottom_mm, page.ink.left_mm}));
  json.add("ink", page.ink.ink);
  json.add("dense_windows", page.ink.dense);
  json.add("empty_windows", page.ink.empty);
  json.add("darkest_window", page.ink.darkest);
  return json.text();
}

std::string smoothness_json(const curves::Smoothness& smoothness) {
  JsonObject json;
  json.add("proven", smoothness.proven);
  add_optional(json, "excluded", smoothness.excluded);
  json.add("exponent_low", smoothness.exponent_low);
  add_optional(json, "exponent_high", smoothness.exponent_high);
  return json.text();
}

std::string dimension_json(const curves::FractalDimension& dimension) {
  JsonObject json;
  json.add("lower", dimension.bounds.lower);
  json.add("upper", dimension.bounds.upper);
  add_optional(json, "spectral", dimension.spectral);
  add_optional(json, "oscillation", dimension.oscillation);
  add_optional(json, "certificate", dimension.certificate);
  return json.text();
}

/// What theory knows, by layer.
void add_known(JsonObject& json, const std::vector<KnownCurve>& known) {
  JsonObject similarity;
  JsonObject smoothness;
  JsonObject dimensions;
  for (const KnownCurve& curve : known) {
    if (curve.facts.similarity_dimension) similarity.add(curve.layer, *curve.facts.similarity_dimension);
    if (curve.facts.smoothness) smoothness.add_json(curve.layer, smoothness_json(*curve.facts.smoothness));
    if (curve.facts.fractal_dimension) dimensions.add_json(curve.layer, dimension_json(*curve.facts.fractal_dimension));
  }
  json.add_json("similarity_dimension", similarity.text());
  json.add_json("smoothness", smoothness.text());
  json.add_json("fractal_dimension", dimensions.text());
}

std::string as_json(const Measured& measured) {
  JsonObject json;
  json.add("name", measured.source.name);
  json.add("units", measured.source.units);
  add_paths(json, measured.figures);
  if (measured.boxes) {
    json.add("box_dimension", measured.boxes->dimension);
    json.add("box_dimension_error", measured.boxes->standard_error);
    json.add("box_dimension_r_squared", measured.boxes->r_squared);
    json.add("box_method", measured.boxes->is_of_graph ? "columns" : "grid");
    std::string scales;
    for (const measure::BoxScale& scale : measured.boxes->scales) {
      scales +=
          fmt::format("{}[{}, {}]", scales.empty() ? "" : ", ", shortest_text(scale.side), shortest_text(scale.count));
    }
    json.add_json("boxes", '[' + scales + ']');
  } else {
    json.add_json("box_dimension", "null");
  }
  if (measured.source.page) add_known(json, measured.source.known);
  if (measured.distance) {
    json.add("rmse", measured.distance->rmse);
    json.add("farthest", measured.distance->farthest);
    json.add("rmse_of_longer_side", measured.distance->rmse / measured.distance->extent);
  }
  if (measured.source.page) json.add_json("page", page_json(*measured.source.page));
  return json.text() + '\n';
}

/// The points of the longest contour, its first repeated at the end when it is closed.
std::vector<Vec2> longest_curve(const Recording& drawing) {
  std::span<const Vec2> longest;
  bool closed = false;
  for (const Recording::Path& path : drawing.paths()) {
    for (const Recording::Contour& contour : drawing.contours(path)) {
      if (contour.point_count <= longest.size()) continue;
      longest = drawing.points(contour);
      closed = path.head.closed;
    }
  }
  std::vector<Vec2> points(longest.begin(), longest.end());
  if (closed) points.push_back(points.front());
  return points;
}

Result<Measured> measured_by(const DrawRequest& request, const Arguments& arguments) {
  const bool closed = arguments.has("closed");
  Result<MeasuredDrawing> drawing = read_measured_drawing(request, closed);
  if (!drawing) return drawing.problems();
  Measured measured;
  measured.source = *std::move(drawing);
  measure::PathFiguresSink figures;
  static_cast<void>(replay(measured.source.drawing, figures));
  measured.figures = figures.figures();
  measured.boxes = measure::box_dimension(measured.source.drawing);
  if (const std::optional<std::string> other = arguments.value("against")) {
    DrawRequest plain;
    plain.command = request.command;
    plain.preset = *other;
    plain.max_points = request.max_points;
    const Result<MeasuredDrawing> against = read_measured_drawing(plain, closed);
    if (!against) return against.problems();
    const Result<CurveDistance> distance =
        measure::curve_distance(longest_curve(measured.source.drawing), longest_curve(against->drawing));
    if (!distance) return Problem{{request.command}, "--against: " + distance.problems().front().message};
    measured.distance = *distance;
  }
  return measured;
}

ExitCode write_plot(const Measured& measured, const std::string& path, const Console& console) {
  if (!measured.boxes) return console.fail(measured.boxes.problems());
  const std::string title = "Boxes met by " + measured.source.name;
  const auto draw = [&](PathSink& sink) { return draw_box_plot(*measured.boxes, title, sink); };
  return write_page({box_plot_sheet(title), draw}, path, "burin measure", console);
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<DrawRequest> request = read_draw_request(arguments, "burin measure");
  if (!request) return console.fail_usage(request.problems(), "burin measure");
  if (!request->series.seeds.empty()) {
    return console.fail_usage({Problem{{"burin measure"}, "--seed: one seed at a time is measured"}}, "burin measure");
  }
  if (arguments.has("closed") && !is_points_file(request->preset)) {
    const std::string advice = "--closed is for files of points; a preset says itself what is closed";
    return console.fail_usage({Problem{{"burin measure"}, advice}}, "burin measure");
  }
  const Result<Measured> measured = measured_by(*request, arguments);
  if (!measured) return console.fail(measured.problems());
  if (const std::optional<std::string> path = arguments.value("plot")) {
    if (const ExitCode code = write_plot(*measured, *path, console); code != ExitCode::done) return code;
  }
  return console.print(arguments.has("json") ? as_json(*measured) : as_text(*measured));
}

}  // namespace

Command measure_command() {
  return {
      "measure",
      "length, dimension, ink and air of a drawing",
      "DRAWING [--json] [--plot FILE] [--against FILE]",
      "DRAWING is a preset, a CSV file or an SVG file. A preset is measured in model units at every point, as its CSV "
      "has them, and on its page in millimetres. A "
      "CSV file is one curve, or the paths of its columns layer and path; a path that ends where it began is closed. "
      "An "
      "SVG file is measured in its pixels, y up.\n\n"
      "The box dimension is the slope of a line fitted to the logarithms of how many boxes of a grid the drawing "
      "meets: boxes from 1/8 of its longer side down to 1/256, but not smaller than two edges, each count the mean "
      "of nine positions of the grid. The graph of a function, of 1024 edges or more, is counted in columns of boxes "
      "by "
      "its oscillations, which is exact much sooner. The error is the slope's standard error; that of the method is "
      "about 0.02.\n\n"
      "Of a preset's curves theory is told, too: the similarity dimension of two-point curves, how smooth the limit of "
      "a subdivision or interpolation is proven and excluded to be, and bounds of a fractal interpolation's "
      "dimension.\n\n"
      "Ink and air are seen on the page drawn in black at 8 dots a millimetre.\n\n"
      "--against holds every point of the longest stroke against the point of the other file's longest stroke at "
      "the same share of its length.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
