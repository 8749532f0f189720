#include <algorithm>
#include <any>
#include <vector>

#include <fmt/format.h>

#include <burin/curves/two_point/motif_figure.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/preset/load.hpp>
#include <cli/file_io.hpp>
#include <cli/motif_file.hpp>
#include <cli/page_file.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

namespace two_point = curves::two_point;
using Figures = std::vector<two_point::MotifFigure>;

constexpr Page motif_page{297.0, 210.0, 0.0, {255, 255, 255}};
constexpr double margin_mm = 25.0;

Problem problem(std::string message) {
  return {{"burin show --motif"}, std::move(message)};
}

/// The distinct figures of the layers that have a motif.
Result<Figures> figures_of_preset(const std::string& name) {
  const Result<PresetText> text = read_preset(name);
  if (!text) return text.problems();
  const Result<preset::Piece> piece = preset::load(text->source, {}, data_reader(text->folder));
  if (!piece) return piece.problems();
  Figures figures;
  for (const preset::Layer& layer : piece->layers) {
    const auto* params = std::any_cast<curves::TwoPointParams>(&layer.parameters);
    if (params == nullptr) continue;
    const std::optional<Figures> made = two_point::motif_figures(params->motif, params->sign, piece->seed);
    if (!made) return problem("the motif leaves the range of numbers");
    for (const two_point::MotifFigure& figure : *made) {
      if (std::find(figures.begin(), figures.end(), figure) == figures.end()) figures.push_back(figure);
    }
  }
  if (figures.empty()) return problem(fmt::format("'{}' has no two-point curve, so it has no motif", name));
  return figures;
}

Result<Figures> figures_of(const std::string& name) {
  if (!is_preset_path(name) && !is_library_preset(name)) {
    if (const two_point::NamedMotif* row = two_point::find_motif(name)) {
      return *two_point::motif_figures(two_point::motif_from(*row), std::nullopt, 0);
    }
  }
  return figures_of_preset(name);
}

}  // namespace

ExitCode write_motif_file(const std::string& name, const std::string& path, const Console& console) {
  const Result<Figures> figures = figures_of(name);
  if (!figures) return console.fail(figures.problems());
  PageDrawing page{two_point::motif_sheet(motif_page), [&figures](PathSink& sink) {
                     const Vec2 margin{margin_mm, margin_mm};
                     const Box2 area{margin, Vec2{motif_page.width_mm, motif_page.height_mm} - margin};
                     return two_point::draw_motif_figures(*figures, area, sink);
                   }};
  page.sheet.made_by.title = "Motif of " + name;
  return write_page(page, path, "burin show", console);
}

}  // namespace burin::cli
