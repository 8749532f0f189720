#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <burin/output/pdf/colour_operators.hpp>
#include <burin/output/pdf/layer_style.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

double dash_sum_mm(const SheetLayer& layer) {
  return std::accumulate(layer.dashes_mm.begin(), layer.dashes_mm.end(), 0.0);
}

int cap_number(Cap cap) {
  return cap == Cap::butt ? 0 : cap == Cap::round ? 1 : 2;
}

int join_number(Join join) {
  return join == Join::miter ? 0 : join == Join::round ? 1 : 2;
}

/// A pattern begins at no negative length: an odd one repeats after two rounds.
std::string dashes_text(const SheetLayer& layer, double unit_mm) {
  if (!is_dashed(layer)) return {};
  const double period_mm = 2.0 * dash_sum_mm(layer);
  double offset_mm = std::fmod(layer.dash_offset_mm, period_mm);
  if (offset_mm < 0.0) offset_mm += period_mm;
  std::string text = "[";
  for (std::size_t i = 0; i < layer.dashes_mm.size(); ++i) {
    text += (i > 0 ? " " : "") + number_text(layer.dashes_mm[i] / unit_mm);
  }
  return text + fmt::format("] {} d ", number_text(offset_mm / unit_mm));
}

}  // namespace

bool is_dashed(const SheetLayer& layer) {
  return dash_sum_mm(layer) > 0.0;
}

std::string stroke_lengths(const Sheet& sheet, std::size_t layer, double unit_mm) {
  const SheetLayer& style = sheet.layers[layer];
  return number_text(sheet.pens[style.pen].width_mm / unit_mm) + " w " + dashes_text(style, unit_mm);
}

std::string layer_style(const Sheet& sheet, std::size_t layer, double unit_mm) {
  const SheetLayer& style = sheet.layers[layer];
  std::string text =
      stroke_lengths(sheet, layer, unit_mm) + fmt::format("{} J {} j ", cap_number(style.cap), join_number(style.join));
  if (style.join == Join::miter) text += number_text(style.miter_limit) + " M ";
  return text + pen_colour_operators(sheet.pens[style.pen], style.pen) + '\n';
}

}  // namespace burin::output::pdf
