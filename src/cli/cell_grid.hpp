#pragma once

#include <cstddef>
#include <optional>

#include <burin/geom/box2.hpp>

namespace burin::cli {

/// What is put into a grid.
struct GridSpec {
  std::size_t count = 1;
  Vec2 item_mm{210.0, 297.0};  ///< width and height of an item before it is scaled
  Box2 area;                   ///< where the grid may be, in mm, y down
  double gap_mm = 5.0;         ///< between cells
  double caption_mm = 0.0;     ///< kept free under each item
  std::optional<std::size_t> columns{};
};

/// Cells in rows from the top left, all of one size: the items as large as they can be.
struct CellGrid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  double scale = 1.0;  ///< of the items
  Vec2 first;          ///< top left corner of the first item
  Vec2 step;           ///< from one item to the next, across and down

  Vec2 corner(std::size_t index) const {
    return {first.x + static_cast<double>(index % columns) * step.x,
            first.y + static_cast<double>(index / columns) * step.y};
  }
};

/// The grid with the largest items; of equals the one with fewest empty cells. It is centred across and begins at the
/// top. The scale is 0 where gaps and captions leave no room. O(count).
CellGrid make_grid(const GridSpec& spec);

}  // namespace burin::cli
