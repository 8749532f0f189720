#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <cairo.h>

#include <burin/burin.hpp>
#include <burin/output/raster/png.hpp>

#include "support/random_paths.hpp"

/// lines_program PRESET|polylines CHUNK|native OUT.png: draws all points of a preset, or 100,000 random polylines of 20
/// points, with Cairo alone, CHUNK segments a stroke, or through the native back end: what burin's PNG is measured by.
namespace burin::test {
namespace {

constexpr double dots_per_mm = 10.0;

/// Cairo at its best: points as they come, strokes of so many segments.
class PlainCairo final : public PathSink {
 public:
  PlainCairo(const Sheet& sheet, int chunk)
      : chunk_(chunk),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(sheet.page.width_mm * dots_per_mm),
                                            static_cast<int>(sheet.page.height_mm * dots_per_mm))),
        to_(cairo_create(surface_)) {
    cairo_set_source_rgb(to_, 1.0, 1.0, 1.0);
    cairo_paint(to_);
    cairo_set_source_rgb(to_, 0.0, 0.0, 0.0);
    cairo_set_line_width(to_, sheet.pens[0].width_mm * dots_per_mm);
    cairo_set_line_cap(to_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(to_, CAIRO_LINE_JOIN_ROUND);
  }
  ~PlainCairo() override {
    cairo_destroy(to_);
    cairo_surface_destroy(surface_);
  }

  Flow begin(const PathHead&) override { return contour(); }
  Flow contour() override {
    cairo_new_sub_path(to_);
    segments_ = 0;
    return Flow::go;
  }
  Flow points(std::span<const Vec2> points) override {
    for (const Vec2 p : points) {
      const double x = p.x * dots_per_mm;
      const double y = p.y * dots_per_mm;
      cairo_line_to(to_, x, y);
      if (++segments_ <= chunk_) continue;
      cairo_stroke(to_);
      cairo_move_to(to_, x, y);
      segments_ = 1;
    }
    return Flow::go;
  }
  Flow end() override {
    cairo_stroke(to_);
    return Flow::go;
  }
  bool write(const char* path) { return cairo_surface_write_to_png(surface_, path) == CAIRO_STATUS_SUCCESS; }

 private:
  int chunk_;
  int segments_ = 0;
  cairo_surface_t* surface_;
  cairo_t* to_;
};

Flow draw_polylines(PathSink& sink) {
  Dice dice(5);
  std::vector<Vec2> points(20);
  for (int k = 0; k < 100'000; ++k) {
    Vec2 p{dice.between(5.0, 195.0), dice.between(5.0, 195.0)};
    for (Vec2& point : points) {
      point = p;
      p = p + Vec2{dice.between(-0.6, 0.6), dice.between(-0.6, 0.6)};
    }
    if (sink.begin({}) == Flow::stop || sink.points(points) == Flow::stop || sink.end() == Flow::stop) break;
  }
  return Flow::go;
}

bool write_native(const Sheet& sheet, const char* path) {
  OutputOptions options;
  options.dots_per_mm = dots_per_mm;
  StringSink bytes;
  const auto sink = output::open_png(bytes, sheet, options, {});
  draw_polylines(*sink);
  return sink->finish().ok() && (std::ofstream(path, std::ios::binary) << bytes.text()).good();
}

int run(const std::string& what, const std::string& how, const char* path) {
  if (what == "polylines") {
    Sheet sheet;
    sheet.page = {.width_mm = 200.0, .height_mm = 200.0};
    sheet.pens = {{.name = "ink", .colour = {0, 0, 0}, .width_mm = 0.1}};
    sheet.layers = {{.name = "lines", .pen = 0}};
    if (how == "native") return write_native(sheet, path) ? 0 : 1;
    PlainCairo cairo(sheet, std::atoi(how.c_str()));
    draw_polylines(cairo);
    return cairo.write(path) ? 0 : 1;
  }
  std::ostringstream text;
  text << std::ifstream(what).rdbuf();
  const Result<preset::Plan> plan = load({what, text.str()});
  if (!plan) return 1;
  PlainCairo cairo(plan->sheet(), std::atoi(how.c_str()));
  static_cast<void>(plan->run(cairo, {}));
  return cairo.write(path) ? 0 : 1;
}

}  // namespace
}  // namespace burin::test

int main(int count, char** words) {
  return count == 4 ? burin::test::run(words[1], words[2], words[3]) : 2;
}
