#include <algorithm>

#include <cli/cell_grid.hpp>

namespace burin::cli {

namespace {

/// The largest scale at which so many columns fit; not positive when none does.
double scale_of(const GridSpec& spec, std::size_t columns, std::size_t rows) {
  const auto across = static_cast<double>(columns);
  const auto down = static_cast<double>(rows);
  const double width = spec.area.width() - (across - 1.0) * spec.gap_mm;
  const double height = spec.area.height() - (down - 1.0) * spec.gap_mm - down * spec.caption_mm;
  return std::min(width / (across * spec.item_mm.x), height / (down * spec.item_mm.y));
}

}  // namespace

CellGrid make_grid(const GridSpec& spec) {
  CellGrid grid;
  grid.scale = 0.0;
  const std::size_t least = spec.columns.value_or(1);
  const std::size_t most = spec.columns.value_or(spec.count);
  for (std::size_t columns = least; columns <= most; ++columns) {
    const std::size_t rows = (spec.count + columns - 1) / columns;
    const double scale = scale_of(spec, columns, rows);
    const bool better = scale > grid.scale || (scale == grid.scale && columns * rows < grid.columns * grid.rows);
    if (!better || !(scale > 0.0)) continue;
    grid.columns = columns;
    grid.rows = rows;
    grid.scale = scale;
  }
  grid.step = {grid.scale * spec.item_mm.x + spec.gap_mm, grid.scale * spec.item_mm.y + spec.caption_mm + spec.gap_mm};
  const double width = static_cast<double>(grid.columns) * grid.step.x - spec.gap_mm;
  grid.first = {spec.area.low.x + (spec.area.width() - width) / 2.0, spec.area.low.y};
  return grid;
}

}  // namespace burin::cli
