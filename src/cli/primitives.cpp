#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/expr/expression.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/primitives/picture.hpp>
#include <cli/command.hpp>
#include <cli/figure_library.hpp>
#include <cli/page_file.hpp>
#include <cli/sheet_layout.hpp>

namespace burin::cli {

namespace {

using primitives::Primitive;

constexpr std::array option_rows{
    OptionRow{"sheet", 0, "FILE", "where to draw them: .svg, .pdf, .png, or - for stdout"},
    OptionRow{"page", 0, "SIZE", "the sheet: a4, a3, letter ... or 30x40cm (a4)"},
    OptionRow{"landscape", 0, "", "turn the sheet on its side"},
    OptionRow{"no-labels", 0, "", "no names under the figures"},
};

constexpr std::array examples{
    Example{"burin primitives --sheet figures.pdf", "all figures that came with burin, and your own"},
    Example{"burin primitives leaves insects --sheet garden.svg --page a5", "two families"},
    Example{"burin primitives leaf star --sheet pair.png --landscape", "two figures"},
};

constexpr double pen_mm = 0.3;
constexpr double largest_cell_mm = 100.0;

Problem problem(std::string message) {
  return {{"burin primitives"}, std::move(message)};
}

/// The figures that the words name: a figure, a family, or an SVG file; all of the library without words.
Result<std::vector<Primitive>> chosen_figures(const std::vector<std::string>& words) {
  std::vector<Primitive> library;
  Problems problems;
  Problems broken;  // figures of the library, which matter when they are asked for
  for (const LibraryFigure& row : library_figures()) {
    Result<Primitive> figure = read_figure(row.name);
    if (figure) {
      library.push_back(*std::move(figure));
    } else {
      broken.insert(broken.end(), figure.problems().begin(), figure.problems().end());
    }
  }
  if (words.empty() && !broken.empty()) return broken;
  std::stable_sort(library.begin(), library.end(),
                   [](const Primitive& a, const Primitive& b) { return a.family < b.family; });
  std::vector<Primitive> chosen;
  for (const std::string& word : words) {
    const std::size_t before = chosen.size();
    std::copy_if(library.begin(), library.end(), std::back_inserter(chosen),
                 [&](const Primitive& figure) { return figure.name == word || figure.family == word; });
    if (chosen.size() > before) continue;
    Result<Primitive> file = read_figure(word);
    if (file) {
      chosen.push_back(*std::move(file));
    } else {
      problems.insert(problems.end(), file.problems().begin(), file.problems().end());
    }
  }
  if (!problems.empty()) return problems;
  return words.empty() ? library : chosen;
}

Result<SheetStyle> style_of(const Arguments& arguments) {
  SheetStyle style;
  style.gap_mm = 4.0;
  style.captions = !arguments.has("no-labels");
  preset::PageSize size;
  if (const std::optional<std::string> text = arguments.value("page")) {
    Problems problems;
    params::ReadContext context{
        .problems = problems,
        .evaluate = [](std::string_view number, const Where& at) { return expr::evaluate_constant(number, at); },
        .defined = {},
        .read_file = {}};
    const Where where{fmt::format("--page {}", *text)};
    if (!params::ValueType<preset::PageSize>::read({where, *text}, size, context)) return problems;
  }
  if (arguments.has("landscape") && size.width_mm < size.height_mm) std::swap(size.width_mm, size.height_mm);
  style.page.width_mm = size.width_mm;
  style.page.height_mm = size.height_mm;
  return style;
}

ExitCode draw_sheet(const std::vector<Primitive>& figures, const SheetStyle& style, const std::string& path,
                    const Console& console) {
  const SheetLayout layout = lay_out(figures.size(), {largest_cell_mm, largest_cell_mm}, style);
  const double cell_mm = largest_cell_mm * std::min(layout.grid.scale, 1.0);
  if (!(cell_mm > 0.0)) {
    return console.fail_usage({problem("the page has no room for them; choose a larger --page")}, "burin primitives");
  }
  std::vector<primitives::FigurePicture> pictures;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Vec2 corner = layout.grid.corner(i);
    const double size_mm = largest_cell_mm * layout.grid.scale;
    const Vec2 middle = corner + Vec2{0.5 * size_mm, 0.5 * size_mm};
    const Vec2 half{0.5 * cell_mm, 0.5 * cell_mm};
    pictures.push_back({&figures[i], {middle - half, middle + half}});
    names.push_back(figures[i].name);
  }
  const std::vector<TextLine> letters = lines_of(layout, style, names);
  PageDrawing page{primitives::picture_sheet(style.page, pen_mm), {}};
  page.sheet.made_by.title = "Primitives";
  page.sheet.pens.push_back({"letters", {90, 90, 90}, 0.18});
  page.sheet.layers.push_back({.name = "letters", .pen = page.sheet.pens.size() - 1});
  const PathHead letter_head{.layer = static_cast<LayerId>(page.sheet.layers.size() - 1)};
  page.draw = [&](PathSink& sink) {
    if (primitives::draw_pictures(pictures, 0.85 * cell_mm, sink) == Flow::stop) return Flow::stop;
    const bool drawn = std::all_of(letters.begin(), letters.end(), [&](const TextLine& line) {
      return draw_line(line, letter_head, sink) == Flow::go;
    });
    return drawn ? Flow::go : Flow::stop;
  };
  return write_page(page, path, "burin primitives", console);
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const std::optional<std::string> path = arguments.value("sheet");
  if (!path) {
    const std::string advice = "say where to draw them, --sheet FILE.pdf; 'burin list primitives' tells their names";
    return console.fail_usage({problem(advice)}, "burin primitives");
  }
  const Result<SheetStyle> style = style_of(arguments);
  if (!style) return console.fail_usage(style.problems(), "burin primitives");
  const Result<std::vector<Primitive>> figures = chosen_figures(arguments.words());
  if (!figures) return console.fail(figures.problems());
  return draw_sheet(*figures, *style, *path, console);
}

}  // namespace

Command primitives_command() {
  return {
      "primitives",
      "draw the figures that can be placed, on one page",
      "[NAME...] --sheet FILE",
      "A NAME is a figure or a family ('burin list primitives'), or an SVG file of your own. Each figure is drawn with "
      "a cross at its anchor, which comes to lie on the point where it is placed, and an arrow that shows what is "
      "up in it.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
