#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/output_cairo/page_sink.hpp>
#include <burin/output_cairo/png.hpp>
#include <burin/output_cairo/png_file.hpp>

namespace burin::output_cairo {

namespace {

/// Cairo's image surfaces end here.
constexpr double most_pixels = 32767.0;

/// Whole pixels for a length, at least one.
double pixel_count(double length_mm, const OutputOptions& options) {
  return std::max(1.0, std::floor(length_mm * options.dots_per_mm + 0.5));
}

bool all_grey(const Sheet& sheet) {
  const auto is_grey = [](Colour c) { return c.red == c.green && c.green == c.blue; };
  return is_grey(sheet.page.paper) &&
         std::all_of(sheet.pens.begin(), sheet.pens.end(), [&](const Pen& pen) { return is_grey(pen.colour); });
}

std::uint32_t dots_per_metre(const OutputOptions& options) {
  return static_cast<std::uint32_t>(std::clamp(std::floor(options.dots_per_mm * 1000.0 + 0.5), 1.0, 2147483647.0));
}

std::vector<PngText> texts(const Origin& origin) {
  std::vector<PngText> texts = {{"Title", origin.title},
                                {"Author", origin.author},
                                {"Description", origin.summary},
                                {"Software", "burin"},
                                {"burin-origin", origin.record}};
  std::erase_if(texts, [](const PngText& text) { return text.text.empty(); });
  return texts;
}

/// In pixels. Thousands of points within a pixel would be stroked in many pieces, and where these lie over each other
/// their soft edges add up: the line would come out too dark.
constexpr double grain = 1.0 / 32.0;

class PngSink final : public PageSink {
 public:
  PngSink(std::shared_ptr<ByteStream> stream, Surface surface, const Sheet& sheet, const OutputOptions& options)
      : PageSink("PNG", std::move(stream), std::move(surface), sheet, {options.dots_per_mm, grain}),
        sheet_(sheet),
        dots_per_metre_(dots_per_metre(options)) {}

 private:
  bool close_document() override {
    cairo_surface_flush(surface());
    PngPicture picture;
    picture.width = static_cast<std::uint32_t>(cairo_image_surface_get_width(surface()));
    picture.height = static_cast<std::uint32_t>(cairo_image_surface_get_height(surface()));
    picture.grey = all_grey(sheet_);
    picture.rows = cairo_image_surface_get_data(surface());
    picture.bytes_per_row = static_cast<std::size_t>(cairo_image_surface_get_stride(surface()));
    picture.dots_per_metre = dots_per_metre_;
    picture.texts = texts(sheet_.made_by);
    return write_png(picture, stream());
  }

  const Sheet& sheet_;
  std::uint32_t dots_per_metre_;
};

/// Half a pixel would hide the shapes, but a crinkled line loses two percent of its ink with them.
double tolerance_mm(const OutputOptions& options) {
  return 0.125 / options.dots_per_mm;
}

Result<Done> accepts(const Sheet& sheet, const OutputOptions& options) {
  const double width = pixel_count(sheet.page.width_mm, options);
  const double height = pixel_count(sheet.page.height_mm, options);
  if (std::max(width, height) <= most_pixels) return Done{};
  return Problem{
      {},
      fmt::format("the PNG would have {} x {} pixels, and Cairo draws at most {} a side: give a lower --dpi, "
                  "or --size {}px or less",
                  fixed_text(width, 0), fixed_text(height, 0), most_pixels, most_pixels),
      Trouble::limit};
}

std::unique_ptr<OutputSink> open(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                             static_cast<int>(pixel_count(sheet.page.width_mm, options)),
                                             static_cast<int>(pixel_count(sheet.page.height_mm, options))));
  auto sink = std::make_unique<PngSink>(std::make_shared<ByteStream>(bytes), std::move(surface), sheet, options);
  sink->paint_paper();
  return sink;
}

/// Four bytes a pixel, and as much again for the group of a layer that lets others shine through.
double memory_bytes(double, const Sheet& sheet, const OutputOptions& options) {
  const double pixels = pixel_count(sheet.page.width_mm, options) * pixel_count(sheet.page.height_mm, options);
  const bool has_group = std::any_of(sheet.layers.begin(), sheet.layers.end(),
                                     [](const SheetLayer& layer) { return layer.opacity < 1.0; });
  return 4e6 + (has_group ? 8.0 : 4.0) * pixels;
}

}  // namespace

BackEnd png_back_end() {
  return {.name = "cairo",
          .format = "png",
          .summary = "PNG with soft edges on the paper's colour, drawn by Cairo",
          .space = Space::page,
          .binary = true,
          .tolerance_mm = tolerance_mm,
          .accepts = accepts,
          .memory_bytes = memory_bytes,
          .open = open};
}

}  // namespace burin::output_cairo
