#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/path/decorators.hpp>
#include <cli/contact_sheet.hpp>

namespace burin::cli {

namespace {

/// Smaller pictures tell nothing.
constexpr double least_side_mm = 4.0;

const Colour letter_colour{51, 51, 51};
/// Width of the letters' pen in heights of a capital.
constexpr double letter_weight = 0.1;
const Pen frame_pen{"frame", {176, 176, 176}, 0.12};

/// The room that any of the pieces needs.
Vec2 item_size(const std::vector<SheetCell>& cells) {
  Vec2 size{0.0, 0.0};
  for (const SheetCell& cell : cells) {
    const Page& page = cell.plan.sheet().page;
    size = {std::max(size.x, page.width_mm), std::max(size.y, page.height_mm)};
  }
  return size;
}

Pen scaled(Pen pen, double scale) {
  pen.width_mm *= scale;
  return pen;
}

SheetLayer scaled(SheetLayer layer, double scale) {
  for (double& dash : layer.dashes_mm) dash *= scale;
  layer.dash_offset_mm *= scale;
  return layer;
}

bool same(const Pen& a, const Pen& b) {
  return a.name == b.name && a.colour == b.colour && a.width_mm == b.width_mm;
}

/// Whether two layers look the same, their pens being the same.
bool same(const SheetLayer& a, const SheetLayer& b) {
  return a.name == b.name && a.pen == b.pen && a.paint == b.paint && a.cap == b.cap && a.join == b.join &&
         a.miter_limit == b.miter_limit && a.dashes_mm == b.dashes_mm && a.dash_offset_mm == b.dash_offset_mm &&
         a.opacity == b.opacity;
}

std::size_t add_pen(Sheet& sheet, const Pen& pen) {
  const auto found = std::find_if(sheet.pens.begin(), sheet.pens.end(), [&](const Pen& p) { return same(p, pen); });
  if (found != sheet.pens.end()) return static_cast<std::size_t>(found - sheet.pens.begin());
  sheet.pens.push_back(pen);
  return sheet.pens.size() - 1;
}

Flow draw_rectangle(const Box2& box, const PathHead& head, PathSink& sink) {
  const std::array corners{box.low, Vec2{box.high.x, box.low.y}, box.high, Vec2{box.low.x, box.high.y}};
  if (sink.begin(head) == Flow::stop || sink.points(corners) == Flow::stop) return Flow::stop;
  return sink.end();
}

}  // namespace

Result<ContactSheet> ContactSheet::make(std::vector<SheetCell> cells, const SheetStyle& style) {
  ContactSheet made;
  made.layout_ = lay_out(cells.size(), item_size(cells), style);
  const Vec2 item_mm = made.layout_.item_mm;
  const double scale = made.layout_.grid.scale;
  if (const double side = scale * std::min(item_mm.x, item_mm.y); side < least_side_mm) {
    return Problem{
        {"burin sheet"},
        fmt::format("{} results on a page of {} x {} mm leave {} mm for each; take a larger --page, a smaller "
                    "--gap or --margin, or fewer results",
                    cells.size(), fixed_text(style.page.width_mm, 1), fixed_text(style.page.height_mm, 1),
                    fixed_text(std::max(side, 0.0), 1)),
        Trouble::limit,
        {}};
  }
  std::vector<std::string> captions;
  for (const SheetCell& cell : cells) captions.push_back(cell.caption);
  made.lines_ = lines_of(made.layout_, style, captions);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Page& page = cells[i].plan.sheet().page;
    const Vec2 free{item_mm.x - page.width_mm, item_mm.y - page.height_mm};
    const Vec2 corner = made.layout_.grid.corner(i) + 0.5 * scale * free;
    made.cells_.push_back({std::move(cells[i]), translation(corner) * scaling(scale, scale), {}});
  }
  made.sheet_.page = style.page;
  // The pens of the pieces get the first numbers.
  for (const Cell& cell : made.cells_) {
    for (const Pen& pen : cell.content.plan.sheet().pens) add_pen(made.sheet_, scaled(pen, scale));
  }
  if (style.papers) made.add_paper_layers();
  for (Cell& cell : made.cells_) made.merge_layers(cell);
  made.add_own_layers(style);
  return made;
}

void ContactSheet::add_paper_layers() {
  for (const Cell& cell : cells_) {
    const Colour paper = cell.content.plan.sheet().page.paper;
    if (paper == sheet_.page.paper) continue;
    SheetLayer layer;
    layer.name = "paper";
    layer.pen = add_pen(sheet_, {"paper", paper, frame_pen.width_mm});
    layer.paint = Paint::fill_nonzero;
    if (std::any_of(sheet_.layers.begin(), sheet_.layers.end(), [&](const auto& l) { return l.pen == layer.pen; }))
      continue;
    sheet_.layers.push_back(std::move(layer));
    parts_.push_back(Part::paper);
  }
}

/// Finds for each layer of the piece one of the sheet, after that of the layer before, or adds it.
void ContactSheet::merge_layers(Cell& cell) {
  const Sheet& piece = cell.content.plan.sheet();
  std::size_t next = 0;
  for (const SheetLayer& own : piece.layers) {
    SheetLayer layer = scaled(own, layout_.grid.scale);
    layer.pen = add_pen(sheet_, scaled(piece.pens[own.pen], layout_.grid.scale));
    while (next < sheet_.layers.size() && !(parts_[next] == Part::piece && same(sheet_.layers[next], layer))) ++next;
    if (next == sheet_.layers.size()) {
      sheet_.layers.push_back(std::move(layer));
      parts_.push_back(Part::piece);
    }
    cell.layers.push_back(static_cast<LayerId>(next++));
  }
}

void ContactSheet::add_own_layers(const SheetStyle& style) {
  if (style.frames) {
    SheetLayer layer;
    layer.name = "frames";
    layer.pen = add_pen(sheet_, frame_pen);
    layer.join = Join::miter;
    sheet_.layers.push_back(std::move(layer));
    parts_.push_back(Part::frames);
  }
  if (!lines_.empty()) {
    SheetLayer layer;
    layer.name = "letters";
    layer.pen = add_pen(sheet_, {"letters", letter_colour, letter_weight * layout_.letter_mm});
    sheet_.layers.push_back(std::move(layer));
    parts_.push_back(Part::letters);
  }
}

preset::RunOptions ContactSheet::cell_options(const preset::RunOptions& options) const {
  preset::RunOptions of_cell = options;
  of_cell.space = Space::page;
  of_cell.tolerance_mm = options.tolerance_mm / layout_.grid.scale;
  of_cell.part_mm = Box2::everything();  // that of the whole sheet says nothing about a cell
  return of_cell;
}

bool ContactSheet::is_wanted(std::size_t layer, const preset::RunOptions& options) const {
  return !options.wanted || options.wanted(sheet_.layers[layer]);
}

/// The points of frames, papers and letters, by drawing them.
Forecast ContactSheet::own_points(const preset::RunOptions& options) const {
  BoundsSink nowhere;
  Counted counted(nowhere);
  for (std::size_t i = 0; i < sheet_.layers.size(); ++i) {
    if (parts_[i] == Part::piece || !is_wanted(i, options)) continue;
    if (draw_own_layer(static_cast<LayerId>(i), counted, options) == Flow::stop) break;
  }
  const auto points = static_cast<double>(counted.point_count());
  return {points, points, true};
}

Result<Forecast> ContactSheet::check_size(const preset::RunOptions& options, double max_points) const {
  Forecast total = own_points(options);
  for (const Cell& cell : cells_) {
    preset::RunOptions of_cell = cell_options(options);
    const Sheet& piece = cell.content.plan.sheet();
    of_cell.wanted = [&](const SheetLayer& own) {
      const auto at = static_cast<std::size_t>(&own - piece.layers.data());
      return is_wanted(cell.layers[at], options);
    };
    const Result<Forecast> part = cell.content.plan.check_size(of_cell, max_points - total.points);
    if (!part) {
      Problem problem = part.problems().front();
      problem.message =
          fmt::format("with the {} points of the cells before it, {}{}", count_text(total.points), problem.message,
                      cell.content.label.empty() ? "" : fmt::format(" [{}]", cell.content.label));
      return problem;
    }
    total.points += part->points;
    total.asked_points += part->asked_points;
    total.exact = total.exact && part->exact;
  }
  return total;
}

Flow ContactSheet::draw_piece_layer(LayerId layer, PathSink& sink, const preset::RunOptions& options) const {
  for (const Cell& cell : cells_) {
    const auto at = std::find(cell.layers.begin(), cell.layers.end(), layer);
    if (at == cell.layers.end()) continue;
    preset::RunOptions of_cell = cell_options(options);
    const SheetLayer* own = &cell.content.plan.sheet().layers[static_cast<std::size_t>(at - cell.layers.begin())];
    of_cell.wanted = [own](const SheetLayer& any) { return &any == own; };
    Painted painted(sink, layer, own->paint);
    Mapped mapped(painted, cell.sheet_from_page);
    if (cell.content.plan.run(mapped, of_cell) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow ContactSheet::draw_rectangles(LayerId layer, PathSink& sink, const preset::RunOptions& options) const {
  const SheetLayer& drawn = sheet_.layers[layer];
  const PathHead head{.layer = layer, .paint = drawn.paint, .closed = true};
  Stoppable stoppable(sink, options.stop);
  for (const Cell& cell : cells_) {
    const Page& page = cell.content.plan.sheet().page;
    if (parts_[layer] == Part::paper && !(page.paper == sheet_.pens[drawn.pen].colour)) continue;
    const Box2 trimmed = image_box(cell.sheet_from_page, {{0.0, 0.0}, {page.width_mm, page.height_mm}});
    if (draw_rectangle(trimmed, head, stoppable) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow ContactSheet::draw_letters(LayerId layer, PathSink& sink, const preset::RunOptions& options) const {
  Stoppable stoppable(sink, options.stop);
  for (const TextLine& line : lines_) {
    if (draw_line(line, {.layer = layer}, stoppable) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow ContactSheet::draw_own_layer(LayerId layer, PathSink& sink, const preset::RunOptions& options) const {
  return parts_[layer] == Part::letters ? draw_letters(layer, sink, options) : draw_rectangles(layer, sink, options);
}

Flow ContactSheet::run(PathSink& sink, const preset::RunOptions& options) const {
  for (std::size_t i = 0; i < sheet_.layers.size(); ++i) {
    if (!is_wanted(i, options)) continue;
    const auto layer = static_cast<LayerId>(i);
    const Flow flow =
        parts_[i] == Part::piece ? draw_piece_layer(layer, sink, options) : draw_own_layer(layer, sink, options);
    if (flow == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

}  // namespace burin::cli
