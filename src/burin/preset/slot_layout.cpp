#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/preset/slot_layout.hpp>
#include <burin/preset/symmetry.hpp>

namespace burin::preset {

namespace {

double millimetres(const Extent& extent, double whole_mm) {
  return extent.percent ? extent.value / 100.0 * whole_mm : extent.value;
}

/// The rectangles of a grid in slot space, row by row from the top left.
struct GridCell {
  Box2 box;
  int column;
  int row;
};

std::vector<GridCell> grid_cells(const SlotSpec& slot, const SlotFrame& frame) {
  const double width = (frame.width_mm - slot.gap.mm * (slot.grid.columns - 1)) / slot.grid.columns;
  const double height = (frame.height_mm - slot.gap.mm * (slot.grid.rows - 1)) / slot.grid.rows;
  std::vector<GridCell> cells;
  for (int row = 0; row < slot.grid.rows; ++row) {
    for (int column = 0; column < slot.grid.columns; ++column) {
      const double left = -0.5 * frame.width_mm + column * (width + slot.gap.mm);
      const double top = 0.5 * frame.height_mm - row * (height + slot.gap.mm);
      cells.push_back({{{left, top - height}, {left + width, top}}, column, row});
    }
  }
  return cells;
}

/// The flip of every picture, before it is fitted: a slot without a grid.
Affine2 mirror_before_fit(const SlotSpec& slot) {
  if (slot.grid.columns * slot.grid.rows > 1) return {};
  return scaling(slot.mirror == Mirror::x || slot.mirror == Mirror::xy ? -1.0 : 1.0,
                 slot.mirror == Mirror::y || slot.mirror == Mirror::xy ? -1.0 : 1.0);
}

/// The flip of a whole cell with what lies in it: every other column or row of a grid.
Affine2 mirror_of_cell(const SlotSpec& slot, const GridCell& cell) {
  const bool x = slot.mirror == Mirror::x || slot.mirror == Mirror::xy;
  const bool y = slot.mirror == Mirror::y || slot.mirror == Mirror::xy;
  return scaling(x && cell.column % 2 == 1 ? -1.0 : 1.0, y && cell.row % 2 == 1 ? -1.0 : 1.0);
}

/// Millimetres in one model unit so that a box of this size fits a place of that size; 1 for a single point.
double fitting_scale(const Box2& content, double width_mm, double height_mm) {
  const double across = content.width() > 0.0 ? width_mm / content.width() : INFINITY;
  const double along = content.height() > 0.0 ? height_mm / content.height() : INFINITY;
  const double scale = std::min(across, along);
  return std::isfinite(scale) ? scale : 1.0;
}

/// Puts the content's box into the place: scaled about its centre, then pushed to the side `align` names.
Affine2 place_from_content(const Box2& content, const Box2& place, const Align& align, double scale) {
  const double free_x = 0.5 * (place.width() - scale * content.width());
  const double free_y = 0.5 * (place.height() - scale * content.height());
  const Vec2 to = place.center() + Vec2{align.x * free_x, -align.y * free_y};
  return translation(to) * scaling(scale, scale) * translation(-content.center());
}

Problem no_box() {
  return {{}, "its curve cannot be fitted to the page", Trouble::input, {}};
}

/// Scales beyond these come from mistaken numbers; within them no map over- or underflows.
constexpr double smallest_scale = 1e-100;
constexpr double largest_scale = 1e100;

Problem mad_scale(const Box2& content, double scale) {
  return {{},
          fmt::format("{:.3g} mm for a model unit are outside [{:g}, {:g}] mm (the model is {:.3g} x {:.3g} units "
                      "large); check its coordinates and the slot's 'frame' and 'scale'",
                      scale, smallest_scale, largest_scale, content.width(), content.height()),
          Trouble::input,
          {}};
}

constexpr std::size_t most_copies = 1'000'000;

Problem too_many_copies() {
  return {{}, "its slot would hold too many copies; use a larger 'cell' or a smaller 'grid'", Trouble::limit, {}};
}

}  // namespace

SlotFrame slot_frame(const PageSpec& page, const SlotSpec& slot) {
  const double live_width = page.size.width_mm - page.margin.left_mm - page.margin.right_mm;
  const double live_height = page.size.height_mm - page.margin.top_mm - page.margin.bottom_mm;
  const double width = millimetres(slot.at.width, live_width);
  const double height = millimetres(slot.at.height, live_height);
  const Vec2 corner{page.margin.left_mm + millimetres(slot.at.x, live_width),
                    page.margin.top_mm + millimetres(slot.at.y, live_height)};
  return {corner + Vec2{0.5 * width, 0.5 * height}, width, height};
}

Result<std::vector<Copy>> lay_out(const SlotSpec& slot, const SlotFrame& frame, double inset_mm,
                                  const ContentBox& content_box) {
  const std::vector<GridCell> cells = grid_cells(slot, frame);
  const double cell_width = cells.front().box.width();
  const double cell_height = cells.front().box.height();
  const double cell_mm = slot.cell ? slot.cell->mm : 0.25 * std::min(cell_width, cell_height);
  const bool tiled = is_symmetry(slot.symmetry.name) && !rosette(slot.symmetry.name);
  if (tiled && cell_width / cell_mm * std::max(1.0, cell_height / cell_mm) > most_cells) return too_many_copies();
  const std::optional<Tiling> tiling = tile(slot.symmetry.name, cell_width, cell_height, cell_mm);
  const std::vector<Affine2> turned = rosette(slot.symmetry.name).value_or(std::vector{Affine2{}});
  const Affine2 upright = mirror_before_fit(slot) * rotation_degrees(slot.rotate);

  // The box of everything that shares the place, mirrored and turned but not yet scaled.
  Box2 content;
  if (slot.frame) {
    content.add(Vec2{(*slot.frame)[0], (*slot.frame)[1]});
    content.add(Vec2{(*slot.frame)[2], (*slot.frame)[3]});
  } else {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      for (const Affine2& turn : turned) {
        const std::optional<Box2> box = content_box(upright * turn, static_cast<int>(cell));
        if (!box) return no_box();
        content.add(*box);
      }
    }
  }
  const Box2 whole_place =
      tiling ? tiling->domain : Box2{{-0.5 * cell_width, -0.5 * cell_height}, {0.5 * cell_width, 0.5 * cell_height}};
  const Box2 place = whole_place.grown(-inset_mm);
  if (content.empty() || place.empty() || (tiling && tiling->copies.empty())) {
    return Problem{{},
                   fmt::format("its slot ({:.4g} x {:.4g} mm) is too small to draw in with a pen of {:.4g} mm",
                               cell_width, cell_height, 2.0 * inset_mm),
                   Trouble::input,
                   {}};
  }
  const std::vector<Affine2> tiles = tiling ? tiling->copies : std::vector{Affine2{}};
  if (cells.size() * tiles.size() * turned.size() > most_copies) return too_many_copies();

  const double scale = slot.scale ? slot.scale->mm : fitting_scale(content, place.width(), place.height());
  if (!(scale >= smallest_scale && scale <= largest_scale)) return mad_scale(content, scale);
  const Affine2 place_from_model = place_from_content(content, place, slot.align, scale);
  std::vector<Copy> copies;
  copies.reserve(cells.size() * tiles.size() * turned.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const Affine2 mirror = mirror_of_cell(slot, cells[cell]);
    const Affine2 slot_from_cell = translation(cells[cell].box.center()) * mirror;
    for (const Affine2& tile_map : tiles) {
      for (const Affine2& turn : turned) {
        copies.push_back({slot_from_cell * tile_map * place_from_model * upright * turn, mirror * upright * turn,
                          upright * turn, cells[cell].column, cells[cell].row, static_cast<int>(copies.size()),
                          static_cast<int>(cell)});
      }
    }
  }
  return copies;
}

}  // namespace burin::preset
