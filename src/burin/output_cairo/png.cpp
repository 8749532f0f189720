#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/output/png_picture.hpp>
#include <burin/output/png_rows.hpp>
#include <burin/output_cairo/page_sink.hpp>
#include <burin/output_cairo/png.hpp>

namespace burin::output_cairo {

namespace {

/// Cairo's image surfaces end here.
constexpr double most_pixels = 32767.0;

/// Red, green and blue, or the grey they share, of one row of CAIRO_FORMAT_RGB24: a native 0xXXRRGGBB each.
void pack_row(const unsigned char* pixels, const output::PngHead& head, std::uint8_t* byte) {
  const auto* pixel = reinterpret_cast<const std::uint32_t*>(pixels);
  for (std::uint32_t x = 0; x < head.width; ++x, ++pixel) {
    if (head.pixels == output::PngPixels::rgb) {
      *byte++ = static_cast<std::uint8_t>(*pixel >> 16U & 0xFFU);
      *byte++ = static_cast<std::uint8_t>(*pixel >> 8U & 0xFFU);
    }
    *byte++ = static_cast<std::uint8_t>(*pixel & 0xFFU);
  }
}

/// In pixels. Thousands of points within a pixel would be stroked in many pieces, and where these lie over each other
/// their soft edges add up: the line would come out too dark.
constexpr double grain = 1.0 / 32.0;

class PngSink final : public PageSink {
 public:
  PngSink(std::shared_ptr<ByteStream> stream, Surface surface, const Sheet& sheet, const OutputOptions& options)
      : PageSink("PNG", std::move(stream), std::move(surface), sheet, {options.dots_per_mm, grain}),
        sheet_(sheet),
        dots_per_mm_(options.dots_per_mm) {}

 private:
  bool close_document() override {
    cairo_surface_flush(surface());
    output::PngHead head;
    head.width = static_cast<std::uint32_t>(cairo_image_surface_get_width(surface()));
    head.height = static_cast<std::uint32_t>(cairo_image_surface_get_height(surface()));
    head.pixels = output::all_grey(sheet_) ? output::PngPixels::grey : output::PngPixels::rgb;
    head.chunks = output::png_chunks(sheet_.made_by, dots_per_mm_);
    output::PngRows rows(head, [this](std::string_view bytes) { return stream().write(bytes); });
    std::vector<std::uint8_t> row(head.bytes_per_row());
    const unsigned char* pixels = cairo_image_surface_get_data(surface());
    for (std::uint32_t y = 0; y < head.height; ++y) {
      pack_row(pixels, head, row.data());
      rows.add(row.data());
      pixels += cairo_image_surface_get_stride(surface());
    }
    return rows.finish();
  }

  const Sheet& sheet_;
  double dots_per_mm_;
};

Result<Done> accepts(const Sheet& sheet, const OutputOptions& options) {
  const auto [width, height] = output::png_size(sheet.page, options.dots_per_mm);
  if (std::max(width, height) <= most_pixels) return Done{};
  return Problem{
      {},
      fmt::format("the PNG would have {} x {} pixels, and Cairo draws at most {} a side: give a lower --dpi, "
                  "or --size {}px or less",
                  fixed_text(width, 0), fixed_text(height, 0), most_pixels, most_pixels),
      Trouble::limit};
}

std::unique_ptr<OutputSink> open(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  const auto [width, height] = output::png_size(sheet.page, options.dots_per_mm);
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  auto sink = std::make_unique<PngSink>(std::make_shared<ByteStream>(bytes), std::move(surface), sheet, options);
  sink->paint_paper();
  return sink;
}

/// Four bytes a pixel, and as much again for the group of a layer that lets others shine through.
double memory_bytes(double, const Sheet& sheet, const OutputOptions& options) {
  const auto [width, height] = output::png_size(sheet.page, options.dots_per_mm);
  const bool has_group = std::any_of(sheet.layers.begin(), sheet.layers.end(),
                                     [](const SheetLayer& layer) { return layer.opacity < 1.0; });
  return 4e6 + (has_group ? 8.0 : 4.0) * width * height;
}

}  // namespace

BackEnd png_back_end() {
  return {.name = "cairo",
          .format = "png",
          .summary = "PNG with soft edges on the paper's colour, drawn by Cairo",
          .space = Space::page,
          .binary = true,
          .tolerance_mm = output::png_tolerance_mm,
          .accepts = accepts,
          .memory_bytes = memory_bytes,
          .open = open};
}

}  // namespace burin::output_cairo
