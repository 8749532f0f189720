#include <algorithm>
#include <any>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include <burin/curves/two_point/motif_figure.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/preset/load.hpp>
#include <cli/atomic_file.hpp>
#include <cli/file_io.hpp>
#include <cli/formats.hpp>
#include <cli/interrupt.hpp>
#include <cli/motif_file.hpp>
#include <cli/preset_library.hpp>
#include <cli/temporaries.hpp>

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

Result<const BackEnd*> page_back_end(const std::string& path) {
  const Result<std::string> format = path == "-" ? Result<std::string>("svg") : format_of_suffix(path);
  if (!format) return format.problems();
  const Result<const BackEnd*> back_end = choose_back_end(*format, std::nullopt);
  if (back_end && (*back_end)->space != Space::page) {
    return problem(fmt::format("{} holds a curve's own points; draw the motif as svg, pdf or png", *format));
  }
  return back_end;
}

Result<Done> write_figures(const Figures& figures, const std::string& title, const BackEnd& back_end,
                           AtomicFile& file) {
  Sheet sheet = two_point::motif_sheet(motif_page);
  sheet.made_by.title = title;
  const std::unique_ptr<OutputSink> sink = back_end.open(file, sheet, {});
  const Box2 area{{margin_mm, margin_mm}, {motif_page.width_mm - margin_mm, motif_page.height_mm - margin_mm}};
  // A sink that cannot write ends the drawing too; finish() or commit() tells why.
  static_cast<void>(two_point::draw_motif_figures(figures, area, *sink));
  if (const Result<Done> finished = sink->finish(); !finished && !file.failed()) return finished.problems();
  return file.commit();
}

}  // namespace

ExitCode write_motif_file(const std::string& name, const std::string& path, const Console& console) {
  const Result<const BackEnd*> back_end = page_back_end(path);
  if (!back_end) return console.fail_usage(back_end.problems(), "burin show");
  const Result<Figures> figures = figures_of(name);
  if (!figures) return console.fail(figures.problems());
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(path, temporaries, interrupt.stop());
  if (!file) return console.fail(file.problems());
  if ((*back_end)->binary && (*file)->is_terminal()) {
    return console.fail_usage({problem("write a file (-o NAME.png) or a pipe, not a terminal")}, "burin show");
  }
  const Result<Done> written = write_figures(*figures, "Motif of " + name, **back_end, **file);
  if (interrupt.signal() != 0) return interrupt.exit_code();
  if (!written) return console.fail(written.problems());
  return ExitCode::done;
}

}  // namespace burin::cli
