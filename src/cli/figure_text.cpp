#include <array>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/primitives/picture.hpp>
#include <cli/figure_text.hpp>
#include <cli/page_file.hpp>

namespace burin::cli {

namespace {

constexpr Page figure_page{210.0, 210.0, 0.0, {255, 255, 255}};
constexpr double margin_mm = 30.0;
constexpr double pen_mm = 0.8;

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "1 filled area, 3 closed lines, 2 open lines": those there are.
std::string paths_text(const Recording& drawing) {
  std::size_t areas = 0;
  std::size_t closed = 0;
  std::size_t open = 0;
  for (const Recording::Path& path : drawing.paths()) {
    std::size_t& kind = path.head.paint != Paint::stroke ? areas : path.head.closed ? closed : open;
    ++kind;
  }
  std::string text;
  const auto add = [&text](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, one, many);
  };
  add(areas, "filled area", "filled areas");
  add(closed, "closed line", "closed lines");
  add(open, "open line", "open lines");
  return text;
}

}  // namespace

std::string figure_text(const primitives::Primitive& figure) {
  const Recording& drawing = figure.figure->drawing();
  const Box2 box = drawing.bounds();
  std::string text = fmt::format("{}: {}\n", figure.name, figure.title);
  if (!figure.family.empty()) text += fmt::format("family: {}\n", figure.family);
  if (!figure.creator.empty()) text += fmt::format("drawn by: {}\n", figure.creator);
  if (!figure.licence.empty()) text += fmt::format("licence: {}\n", figure.licence);
  text += fmt::format("lines: {}; {}\n", paths_text(drawing), counted(figure.point_count(), "point", "points"));
  text += fmt::format("size: {} wide, {} high; from its anchor {} to {} across, {} to {} up\n",
                      fixed_text(box.width(), 3), fixed_text(box.height(), 3), fixed_text(box.low.x, 3),
                      fixed_text(box.high.x, 3), fixed_text(box.low.y, 3), fixed_text(box.high.y, 3));
  return text;
}

ExitCode write_figure_file(const primitives::Primitive& figure, const std::string& path, const Console& console) {
  const Vec2 margin{margin_mm, margin_mm};
  const Box2 area{margin, Vec2{figure_page.width_mm, figure_page.height_mm} - margin};
  const std::array<primitives::FigurePicture, 1> picture{{{&figure, area}}};
  PageDrawing page{primitives::picture_sheet(figure_page, pen_mm),
                   [&](PathSink& sink) { return primitives::draw_pictures(picture, area.width(), sink); }};
  page.sheet.made_by.title = figure.title;
  return write_page(page, path, "burin show", console);
}

}  // namespace burin::cli
