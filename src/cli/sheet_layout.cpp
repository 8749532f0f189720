#include <algorithm>

#include <cli/sheet_layout.hpp>

namespace burin::cli {

namespace {

/// Height of the captions' capitals, as a share of the page's shorter side, and its limits in mm.
constexpr double letter_share = 0.011;
constexpr double largest_letter_mm = 6.0;
constexpr double smallest_letter_mm = 0.8;

// In heights of these capitals.
constexpr double title_height = 1.8;
constexpr double under_title = 2.6;
constexpr double caption_room = 2.5;
constexpr double caption_baseline = 2.0;
constexpr double narrowest_cell = 12.0;

}  // namespace

SheetLayout lay_out(std::size_t count, Vec2 item_mm, const SheetStyle& style) {
  SheetLayout layout;
  layout.item_mm = item_mm;
  layout.area = {{style.margin.left_mm, style.margin.top_mm},
                 {style.page.width_mm - style.margin.right_mm, style.page.height_mm - style.margin.bottom_mm}};
  layout.letter_mm = std::clamp(letter_share * std::min(style.page.width_mm, style.page.height_mm), smallest_letter_mm,
                                largest_letter_mm);
  layout.title_mm = title_height * layout.letter_mm;
  GridSpec spec{.count = count,
                .item_mm = item_mm,
                .area = layout.area,
                .gap_mm = style.gap_mm,
                .caption_mm = style.captions ? caption_room * layout.letter_mm : 0.0,
                .columns = style.columns};
  if (!style.title.empty()) spec.area.low.y += layout.title_mm + under_title * layout.letter_mm;
  layout.grid = make_grid(spec);
  const double suits = std::max(layout.grid.scale * item_mm.x / narrowest_cell, smallest_letter_mm);
  if (style.captions && suits < layout.letter_mm) {
    layout.letter_mm = suits;
    spec.caption_mm = caption_room * suits;
    layout.grid = make_grid(spec);
  }
  return layout;
}

std::vector<TextLine> lines_of(const SheetLayout& layout, const SheetStyle& style,
                               const std::vector<std::string>& captions) {
  std::vector<TextLine> lines;
  const CellGrid& grid = layout.grid;
  const double cell_mm = grid.scale * layout.item_mm.x;
  if (!style.title.empty()) {
    const double baseline = layout.area.low.y + layout.title_mm;
    const double right = grid.first.x + static_cast<double>(grid.columns - 1) * grid.step.x + cell_mm;
    const double whole = std::max(right, layout.area.high.x) - grid.first.x;
    lines.push_back({style.title, {grid.first.x, baseline}, TextLine::From::left, layout.title_mm, whole});
    const double rest = right - grid.first.x - width_mm(lines.back()) - 2.0 * layout.title_mm;
    const bool room = rest > 0.0 && !style.subtitle.empty();
    if (room) lines.push_back({style.subtitle, {right, baseline}, TextLine::From::right, layout.letter_mm, rest});
  }
  for (std::size_t i = 0; style.captions && i < captions.size(); ++i) {
    const Vec2 corner = grid.corner(i);
    const Vec2 at{corner.x + cell_mm / 2.0,
                  corner.y + grid.scale * layout.item_mm.y + caption_baseline * layout.letter_mm};
    lines.push_back({captions[i], at, TextLine::From::middle, layout.letter_mm, cell_mm});
  }
  return lines;
}

}  // namespace burin::cli
