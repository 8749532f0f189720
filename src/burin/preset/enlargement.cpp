#include <algorithm>
#include <utility>

#include <burin/preset/enlargement.hpp>

namespace burin::preset {

namespace {

double fitting_factor(const Page& page, PageSize onto) {
  return std::min(onto.width_mm / page.width_mm, onto.height_mm / page.height_mm);
}

}  // namespace

Enlargement enlargement(const Page& page, PageSize onto) {
  constexpr double rounded_away = 0.01;
  const PageSize turned{onto.height_mm, onto.width_mm};
  if (fitting_factor(page, turned) > fitting_factor(page, onto)) onto = turned;
  const double factor = fitting_factor(page, onto);
  const double width_mm = factor * page.width_mm;
  const double height_mm = factor * page.height_mm;
  const bool is_same_shape = onto.width_mm - width_mm < rounded_away * onto.width_mm &&
                             onto.height_mm - height_mm < rounded_away * onto.height_mm;
  // The side that decides is as asked, and not a rounding error off.
  const bool width_decides = onto.width_mm / page.width_mm == factor;
  Enlargement result{page, factor, scaling(factor, factor)};
  result.page.bleed_mm = factor * page.bleed_mm;
  result.page.width_mm = is_same_shape || width_decides ? onto.width_mm : width_mm;
  result.page.height_mm = is_same_shape || !width_decides ? onto.height_mm : height_mm;
  const Vec2 middle{0.5 * (result.page.width_mm - width_mm), 0.5 * (result.page.height_mm - height_mm)};
  result.new_from_page = translation(middle) * result.new_from_page;
  return result;
}

Sheet enlarged(Sheet sheet, const Enlargement& enlargement) {
  sheet.page = enlargement.page;
  for (Pen& pen : sheet.pens) pen.width_mm *= enlargement.factor;
  for (SheetLayer& layer : sheet.layers) {
    for (double& dash : layer.dashes_mm) dash *= enlargement.factor;
    layer.dash_offset_mm *= enlargement.factor;
  }
  return sheet;
}

}  // namespace burin::preset
