#include <array>

#include <burin/output/back_ends.hpp>
#include <burin/output/csv_writer.hpp>
#include <burin/output/dump_writer.hpp>
#include <burin/output/pdf/writer.hpp>
#include <burin/output/raster/png.hpp>
#include <burin/output/svg_writer.hpp>

namespace burin::output {

namespace {

double shows_everything(const Sheet&, const OutputOptions&) {
  return 0.0;
}

Result<Done> accepts_everything(const Sheet&, const OutputOptions&) {
  return Done{};
}

/// These writers stream: what they hold does not grow with the drawing.
double constant_memory(double, const Sheet&, const OutputOptions&) {
  return 2e6;
}

/// The same, but for compressing and for 8 bytes a chunk of about 20,000 points.
double pdf_memory(double points, const Sheet&, const OutputOptions&) {
  return 4e6 + 4e-4 * points;
}

}  // namespace

std::span<const BackEnd> back_ends() {
  static const std::array table{
      BackEnd{"native", "svg", "layered SVG in millimetres, for plotters and drawing programs", Space::page, false,
              svg_tolerance_mm, svg_accepts, constant_memory, open_svg},
      BackEnd{"native", "pdf", "layered PDF in true size, with bleed and printers' inks, of any length", Space::page,
              true, pdf_tolerance_mm, pdf_accepts, pdf_memory, open_pdf},
      png_back_end(),
      BackEnd{"native", "csv", "the vertices in model units, one a row", Space::model, false, shows_everything,
              accepts_everything, constant_memory, open_csv},
      BackEnd{"native", "dump", "the canonical dump in whole micrometres, to compare drawings", Space::page, false,
              shows_everything, accepts_everything, constant_memory, open_dump},
  };
  return table;
}

}  // namespace burin::output
