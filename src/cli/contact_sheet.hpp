#pragma once

#include <string>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/preset/plan.hpp>
#include <cli/sheet_layout.hpp>

namespace burin::cli {

/// A piece on a contact sheet.
struct SheetCell {
  preset::Plan plan;
  std::string caption;  ///< under it
  std::string label;    ///< what messages call it
};

/// Scaled pages of many pieces in a grid on one page. Pens are scaled along, so that each cell looks as its picture.
/// Layers that are the same in several pieces are one layer of the sheet, as far as the order of drawing in each cell
/// allows: a plotter needs no more pens than for one piece, two for frames and letters added. Nothing is stored but the
/// plans, which are replayed layer by layer.
class ContactSheet {
 public:
  /// Problems: no room. Pre: at least one cell.
  static Result<ContactSheet> make(std::vector<SheetCell> cells, const SheetStyle& style);

  /// Layers "paper", those of the pieces, "frames", "letters".
  const Sheet& sheet() const { return sheet_; }
  const CellGrid& grid() const { return layout_.grid; }

  /// As Plan::check_size.
  Result<Forecast> check_size(const preset::RunOptions& options, double max_points) const;
  /// As Plan::run, in the space of the page.
  Flow run(PathSink& sink, const preset::RunOptions& options) const;

 private:
  struct Cell {
    SheetCell content;
    Affine2 sheet_from_page;
    std::vector<LayerId> layers;  ///< of the sheet, for each layer of the piece
  };
  enum class Part : std::uint8_t { paper, piece, frames, letters };

  void add_paper_layers();
  void merge_layers(Cell& cell);
  void add_own_layers(const SheetStyle& style);
  bool is_wanted(std::size_t layer, const preset::RunOptions& options) const;
  Forecast own_points(const preset::RunOptions& options) const;
  Flow draw_own_layer(LayerId layer, PathSink& sink, const preset::RunOptions& options) const;
  preset::RunOptions cell_options(const preset::RunOptions& options) const;
  Flow draw_piece_layer(LayerId layer, PathSink& sink, const preset::RunOptions& options) const;
  Flow draw_rectangles(LayerId layer, PathSink& sink, const preset::RunOptions& options) const;
  Flow draw_letters(LayerId layer, PathSink& sink, const preset::RunOptions& options) const;

  Sheet sheet_;
  SheetLayout layout_;
  std::vector<TextLine> lines_;
  std::vector<Cell> cells_;
  std::vector<Part> parts_;  ///< what each layer of the sheet holds
};

}  // namespace burin::cli
