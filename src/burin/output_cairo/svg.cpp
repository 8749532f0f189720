#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <cairo-svg.h>
#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/output_cairo/page_sink.hpp>
#include <burin/output_cairo/svg.hpp>
#include <burin/output_cairo/svg_text.hpp>

namespace burin::output_cairo {

namespace {

cairo_status_t write_to_svg_text(void* text, const unsigned char* bytes, unsigned int count) {
  const std::string_view piece(reinterpret_cast<const char*>(bytes), count);
  return static_cast<SvgText*>(text)->write(piece) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

/// What Cairo writes into while its surface lives.
struct SvgStream {
  SvgStream(ByteSink& bytes, const Origin& origin) : stream(bytes), text(stream, origin) {}
  ByteStream stream;
  SvgText text;
};

class SvgSink final : public PageSink {
 public:
  SvgSink(std::shared_ptr<SvgStream> stream, Surface surface, const Sheet& sheet)
      : PageSink("SVG", {stream, &stream->stream}, std::move(surface), sheet, {.device_per_mm = 1.0}),
        text_(stream->text) {}

 private:
  bool close_document() override {
    cairo_show_page(context());
    cairo_surface_finish(surface());
    text_.finish();
    return true;
  }

  SvgText& text_;
};

double tolerance_mm(const Sheet&, const OutputOptions&) {
  return 0.5 / 256.0;
}

Result<Done> accepts(const Sheet& sheet, const OutputOptions&) {
  if (std::max(sheet.page.width_mm, sheet.page.height_mm) <= farthest) return Done{};
  return Problem{
      {},
      fmt::format("an SVG page of {} x {} mm is more than Cairo can draw; a side can have {} mm",
                  fixed_text(sheet.page.width_mm, 3), fixed_text(sheet.page.height_mm, 3), fixed_text(farthest, 0)),
      Trouble::limit};
}

std::unique_ptr<OutputSink> open(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  auto stream = std::make_shared<SvgStream>(bytes, sheet.made_by);
  Surface surface(
      cairo_svg_surface_create_for_stream(write_to_svg_text, &stream->text, sheet.page.width_mm, sheet.page.height_mm));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  auto sink = std::make_unique<SvgSink>(std::move(stream), std::move(surface), sheet);
  if (options.paper) sink->paint_paper();
  return sink;
}

/// Cairo keeps the document until it is finished: 33 bytes a segment, measured.
double memory_bytes(double points, const Sheet&, const OutputOptions&) {
  return 4e6 + 33.0 * points;
}

}  // namespace

BackEnd svg_back_end() {
  return {.name = "cairo",
          .format = "svg",
          .summary = "SVG in millimetres as Cairo writes it: no layers, coordinates snapped to 1/256 mm",
          .space = Space::page,
          .binary = false,
          .tolerance_mm = tolerance_mm,
          .accepts = accepts,
          .memory_bytes = memory_bytes,
          .open = open};
}

}  // namespace burin::output_cairo
