#include <algorithm>
#include <cmath>

#include <burin/output/png_picture.hpp>

namespace burin::output {

PngSize png_size(const Page& page, double dots_per_mm) {
  const auto pixels = [&](double length_mm) { return std::max(1.0, std::floor(length_mm * dots_per_mm + 0.5)); };
  return {pixels(page.width_mm), pixels(page.height_mm)};
}

double png_tolerance_mm(const Sheet& sheet, const OutputOptions& options) {
  double thinnest_pixels = 1.0;
  for (const Pen& pen : sheet.pens) thinnest_pixels = std::min(thinnest_pixels, pen.width_mm * options.dots_per_mm);
  return std::max(0.02, 0.08 * thinnest_pixels) / options.dots_per_mm;
}

bool all_grey(const Sheet& sheet) {
  const auto is_grey = [](Colour c) { return c.red == c.green && c.green == c.blue; };
  return is_grey(sheet.page.paper) &&
         std::all_of(sheet.pens.begin(), sheet.pens.end(), [&](const Pen& pen) { return is_grey(pen.colour); });
}

}  // namespace burin::output
