#include "quality.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <burin/output/raster/png.hpp>
#include <burin/path/recording.hpp>

#include "decoded_png.hpp"
#include "support/random_paths.hpp"

namespace burin::test {
namespace {

constexpr double dots_per_mm = 10.0;

std::vector<std::uint8_t> grey_of(const std::string& png) {
  const DecodedPng picture = decoded_png(png);
  std::vector<std::uint8_t> grey;
  for (std::size_t k = 0; k < picture.rgb.size(); k += 3) grey.push_back(picture.rgb[k]);
  return grey;
}

OutputOptions ten_dots() {
  OutputOptions options;
  options.dots_per_mm = dots_per_mm;
  return options;
}

}  // namespace

double difference_of_lines(const std::vector<Line>& lines, double width_px, int side_px) {
  Sheet sheet;
  sheet.page = {.width_mm = side_px / dots_per_mm, .height_mm = side_px / dots_per_mm};
  sheet.pens = {{.name = "ink", .colour = {0, 0, 0}, .width_mm = width_px / dots_per_mm}};
  sheet.layers = {{.name = "lines", .pen = 0}};
  std::vector<DrawnPath> paths;
  for (const Line& line : lines)
    paths.push_back({{}, {{line.from * (1.0 / dots_per_mm), line.to * (1.0 / dots_per_mm)}}});
  StringSink bytes;
  const auto sink = output::open_png(bytes, sheet, ten_dots(), {});
  static_cast<void>(draw(paths, *sink));
  if (!sink->finish()) throw std::runtime_error("no picture");
  return mean_difference(grey_of(bytes.text()), supersampled(lines, width_px, side_px, side_px));
}

double difference_of_curve(const std::string& motif, int levels, double width_px, int side_px) {
  const std::string text = fmt::format(
      "burin = 1\npage = {{ size = \"{0}x{0}mm\", margin = \"{1}mm\" }}\n"
      "[pens]\nink = {{ color = \"black\", width = \"{2}mm\" }}\n"
      "[[layer]]\nname = \"curve\"\n[layer.curve]\nfamily = \"two-point\"\nmotif = \"{3}\"\nlevels = {4}\n",
      side_px / dots_per_mm, side_px / dots_per_mm / 20.0, width_px / dots_per_mm, motif, levels);
  const Result<preset::Plan> plan = load({"curve.toml", text});
  if (!plan) throw std::runtime_error(plan.problems().front().message);
  StringSink bytes;
  if (!write(*plan, output::png_back_end(), bytes, ten_dots(), 1e8)) throw std::runtime_error("no picture");
  Recorder all;
  static_cast<void>(plan->run(all, {}));
  std::vector<Line> lines;
  const Recording& recording = all.recording();
  for (const Recording::Path& path : recording.paths()) {
    for (const Recording::Contour& contour : recording.contours(path)) {
      const std::span<const Vec2> points = recording.points(contour);
      for (std::size_t k = 1; k < points.size(); ++k) {
        lines.push_back({points[k - 1] * dots_per_mm, points[k] * dots_per_mm});
      }
    }
  }
  return mean_difference(grey_of(bytes.text()), supersampled(lines, width_px, side_px, side_px));
}

}  // namespace burin::test
