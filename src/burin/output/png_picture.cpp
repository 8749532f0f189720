#include <algorithm>
#include <cmath>

#include <burin/output/png_picture.hpp>

namespace burin::output {

namespace {

std::string palette_bytes(const std::vector<Colour>& palette) {
  std::string bytes;
  for (const Colour colour : palette) {
    bytes += static_cast<char>(colour.red);
    bytes += static_cast<char>(colour.green);
    bytes += static_cast<char>(colour.blue);
  }
  return bytes;
}

}  // namespace

std::string file_head(const PngHead& head) {
  constexpr char bits = 8;
  std::string header = big_endian(head.width) + big_endian(head.height) + bits;
  header += static_cast<char>(head.pixels == PngPixels::rgb ? 2 : head.pixels == PngPixels::palette ? 3 : 0);
  header += std::string(3, '\0');  // deflate, filters of method 0, not interlaced
  std::string bytes = "\x89PNG\r\n\x1A\n" + chunk_bytes({"IHDR", header});
  for (const PngChunk& chunk : head.chunks) bytes += chunk_bytes(chunk);
  if (head.pixels == PngPixels::palette) bytes += chunk_bytes({"PLTE", palette_bytes(head.palette)});
  return bytes;
}

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
