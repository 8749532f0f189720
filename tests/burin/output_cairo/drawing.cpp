#include "drawing.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <png.h>

#include <burin/output_cairo/back_ends.hpp>
#include <burin/path/decorators.hpp>

namespace burin::test {

const BackEnd& cairo_back_end(std::string_view format) {
  for (const BackEnd& row : output_cairo::back_ends()) {
    if (row.format == format) return row;
  }
  std::abort();
}

Sheet small_sheet() {
  Sheet sheet;
  sheet.page = {.width_mm = 20.0, .height_mm = 10.0};
  sheet.pens = {{.name = "ink", .colour = {0, 0, 0}, .width_mm = 1.0}};
  sheet.layers = {{.name = "lines"}};
  return sheet;
}

OutputOptions ten_dots() {
  OutputOptions options;
  options.dots_per_mm = 10.0;
  return options;
}

Flow draw_line(PathSink& to, const std::vector<Vec2>& points, bool closed, Paint paint, LayerId layer) {
  const PathHead head{.layer = layer, .paint = paint, .closed = closed};
  if (to.begin(head) == Flow::stop) return Flow::stop;
  if (to.points(points) == Flow::stop) return Flow::stop;
  return to.end();
}

std::string drawn(std::string_view format, const Sheet& sheet, const Draw& draw, const OutputOptions& options) {
  StringSink bytes;
  const BackEnd& row = cairo_back_end(format);
  EXPECT_TRUE(row.accepts(sheet, options).ok());
  const auto sink = row.open(bytes, sheet, options);
  Checked checked(*sink);
  EXPECT_EQ(draw(checked), Flow::go);
  const Result<Done> result = sink->finish();
  EXPECT_TRUE(result.ok()) << problems_text(result.ok() ? Problems{} : result.problems());
  return bytes.take();
}

Pixels decoded(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Pixels pixels;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) {
    ADD_FAILURE() << image.message;
    return pixels;
  }
  image.format = PNG_FORMAT_RGB;
  pixels.width = static_cast<int>(image.width);
  pixels.height = static_cast<int>(image.height);
  pixels.rgb.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr), 0) << image.message;
  return pixels;
}

Pixels pixels(const Sheet& sheet, const Draw& draw, const OutputOptions& options) {
  return decoded(drawn("png", sheet, draw, options));
}

double ink(const Pixels& pixels) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels.rgb.size(); i += 3) sum += 1.0 - pixels.rgb[i] / 255.0;
  return sum;
}

int differing(const Pixels& a, const Pixels& b, int tolerance) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  int count = 0;
  for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); i += 3) {
    count += std::abs(int{a.rgb[i]} - int{b.rgb[i]}) > tolerance ? 1 : 0;
  }
  return count;
}

}  // namespace burin::test
