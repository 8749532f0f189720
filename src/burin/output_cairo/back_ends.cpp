#include <array>

#include <burin/output_cairo/back_ends.hpp>
#include <burin/output_cairo/pdf.hpp>
#include <burin/output_cairo/png.hpp>
#include <burin/output_cairo/svg.hpp>

namespace burin::output_cairo {

std::span<const BackEnd> back_ends() {
  static const std::array<BackEnd, 3> rows = {pdf_back_end(), png_back_end(), svg_back_end()};
  return rows;
}

}  // namespace burin::output_cairo

void burin_cairo_back_ends(std::span<const burin::BackEnd>& rows) {
  rows = burin::output_cairo::back_ends();
}
