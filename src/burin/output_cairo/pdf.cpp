#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/units.hpp>
#include <burin/output/origin_text.hpp>
#include <burin/output_cairo/page_sink.hpp>
#include <burin/output_cairo/pdf.hpp>

namespace burin::output_cairo {

namespace {

constexpr double points_per_mm = 1.0 / mm_per_point;
/// 14400 points: viewers need not open longer pages (ISO 32000-1, annex C.2).
constexpr double longest_page_mm = 200.0 * mm_per_inch;
/// Cairo would write the time of the run.
constexpr const char* fixed_date = "2000-01-01T00:00:00Z";

class PdfSink final : public PageSink {
 public:
  PdfSink(std::shared_ptr<ByteStream> stream, Surface surface, const Sheet& sheet)
      : PageSink("PDF", std::move(stream), std::move(surface), sheet, {.device_per_mm = points_per_mm}) {}

 private:
  bool close_document() override {
    cairo_show_page(context());
    cairo_surface_finish(surface());
    return true;
  }
};

void set_metadata(cairo_surface_t* surface, const Origin& origin) {
  const auto set = [&](cairo_pdf_metadata_t field, const std::string& text) {
    if (!text.empty()) cairo_pdf_surface_set_metadata(surface, field, output::carried_text(text).c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, origin.title);
  set(CAIRO_PDF_METADATA_AUTHOR, origin.author);
  set(CAIRO_PDF_METADATA_SUBJECT, origin.summary);
  set(CAIRO_PDF_METADATA_KEYWORDS, origin.record);
  set(CAIRO_PDF_METADATA_CREATOR, "burin");
  set(CAIRO_PDF_METADATA_CREATE_DATE, fixed_date);
  set(CAIRO_PDF_METADATA_MOD_DATE, fixed_date);
}

double tolerance_mm(const Sheet&, const OutputOptions&) {
  return 0.5 * mm_per_point / 256.0;
}

/// Cairo knows screens' colours only, and a printer would not see what is missing.
Problems lost_inks(const Sheet& sheet) {
  Problems problems;
  for (const Pen& pen : sheet.pens) {
    if (!pen.cmyk && pen.spot.empty()) continue;
    problems.push_back(
        {{},
         fmt::format("pen '{}' has '{}', which Cairo cannot write into a PDF: draw with --backend native", pen.name,
                     pen.spot.empty() ? "cmyk" : "spot")});
  }
  return problems;
}

Result<Done> accepts(const Sheet& sheet, const OutputOptions&) {
  if (Problems lost = lost_inks(sheet); !lost.empty()) return lost;
  if (std::max(sheet.page.width_mm, sheet.page.height_mm) <= longest_page_mm) return Done{};
  return Problem{{},
                 fmt::format("a PDF page of {} x {} mm is more than viewers open; a side can have {} mm: make the page "
                             "smaller, or write SVG",
                             fixed_text(sheet.page.width_mm, 3), fixed_text(sheet.page.height_mm, 3),
                             fixed_text(longest_page_mm, 3)),
                 Trouble::limit};
}

std::unique_ptr<OutputSink> open(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  auto stream = std::make_shared<ByteStream>(bytes);
  Surface surface(cairo_pdf_surface_create_for_stream(
      write_to_stream, stream.get(), sheet.page.width_mm * points_per_mm, sheet.page.height_mm * points_per_mm));
  set_metadata(surface.get(), sheet.made_by);
  auto sink = std::make_unique<PdfSink>(std::move(stream), std::move(surface), sheet);
  if (options.paper) sink->paint_paper();
  return sink;
}

/// Cairo keeps the deflated page until it is shown: 12 bytes a segment of a fine curve, measured.
double memory_bytes(double points, const Sheet&, const OutputOptions&) {
  return 4e6 + 12.0 * points;
}

}  // namespace

BackEnd pdf_back_end() {
  return {.name = "cairo",
          .format = "pdf",
          .summary = "PDF in true size, drawn by Cairo",
          .space = Space::page,
          .binary = true,
          .tolerance_mm = tolerance_mm,
          .accepts = accepts,
          .memory_bytes = memory_bytes,
          .open = open};
}

}  // namespace burin::output_cairo
