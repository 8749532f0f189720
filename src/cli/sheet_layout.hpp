#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/path/sheet.hpp>
#include <burin/preset/piece.hpp>
#include <cli/cell_grid.hpp>
#include <cli/text_line.hpp>

namespace burin::cli {

/// How a contact sheet looks.
struct SheetStyle {
  Page page;
  preset::Margins margin{12.0, 12.0, 12.0, 12.0};
  double gap_mm = 5.0;
  std::optional<std::size_t> columns;
  std::string title;     ///< at the top left; empty: no heading
  std::string subtitle;  ///< at the top right
  bool captions = true;  ///< keeps room for one under each cell
  bool frames = true;    ///< a thin line around each page
  bool papers = false;   ///< fills cells with the pieces' paper, where it is not that of the sheet
};

/// Where everything is on a contact sheet, in mm of its page.
struct SheetLayout {
  Vec2 item_mm;  ///< the room of a cell before it is scaled
  CellGrid grid;
  Box2 area;               ///< within the margins
  double title_mm = 0.0;   ///< height of the title's capitals
  double letter_mm = 0.0;  ///< height of the other capitals
};

/// The largest cells that leave room for heading and captions; letters are smaller under small cells.
SheetLayout lay_out(std::size_t count, Vec2 item_mm, const SheetStyle& style);

/// The heading and a caption under each cell. Pre: as many captions as cells.
std::vector<TextLine> lines_of(const SheetLayout& layout, const SheetStyle& style,
                               const std::vector<std::string>& captions);

}  // namespace burin::cli
