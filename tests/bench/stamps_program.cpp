#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <burin/burin.hpp>
#include <burin/path/recording.hpp>

/// stamps_program PRESET svg|pdf OUT: draws a preset's figures with Cairo alone, one stroke a figure: what burin's
/// placements are measured by.
namespace burin::test {
namespace {

constexpr double points_per_mm = 72.0 / 25.4;

class OneStrokeEach final : public PathSink {
 public:
  OneStrokeEach(const Sheet& sheet, const std::string& format, const char* path)
      : surface_((format == "svg" ? cairo_svg_surface_create : cairo_pdf_surface_create)(
            path, sheet.page.width_mm * points_per_mm, sheet.page.height_mm * points_per_mm)),
        to_(cairo_create(surface_)) {
    cairo_scale(to_, points_per_mm, points_per_mm);
    cairo_set_line_width(to_, sheet.pens[0].width_mm);
    cairo_set_line_cap(to_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(to_, CAIRO_LINE_JOIN_ROUND);
  }

  Flow begin(const PathHead&) override { return Flow::stop; }
  Flow points(std::span<const Vec2>) override { return Flow::stop; }
  Flow contour() override { return Flow::stop; }
  Flow end() override { return Flow::stop; }
  Flow place(const PathHead&, const Figure& figure, const Affine2& at) override {
    const Recording& drawing = figure.drawing();
    for (const Recording::Path& path : drawing.paths()) {
      for (const Recording::Contour& contour : drawing.contours(path)) {
        cairo_new_sub_path(to_);
        for (const Vec2 point : drawing.points(contour)) {
          const Vec2 p = at(point);
          cairo_line_to(to_, p.x, p.y);
        }
        if (path.head.closed) cairo_close_path(to_);
      }
    }
    cairo_stroke(to_);
    return Flow::go;
  }

  bool finish() {
    cairo_destroy(to_);
    cairo_surface_finish(surface_);
    const bool good = cairo_surface_status(surface_) == CAIRO_STATUS_SUCCESS;
    cairo_surface_destroy(surface_);
    return good;
  }

 private:
  cairo_surface_t* surface_;
  cairo_t* to_;
};

int run(const std::string& preset, const std::string& format, const char* path) {
  std::ostringstream text;
  text << std::ifstream(preset).rdbuf();
  const ReadFile beside = [&](std::string_view name) -> Result<std::string> {
    std::ostringstream bytes;
    bytes << std::ifstream(preset.substr(0, preset.rfind('/') + 1) + std::string(name)).rdbuf();
    return bytes.str();
  };
  const Result<preset::Plan> plan = load({preset, text.str()}, {}, beside);
  if (!plan) return 1;
  OneStrokeEach cairo(plan->sheet(), format, path);
  return plan->run(cairo, {}) == Flow::go && cairo.finish() ? 0 : 1;
}

}  // namespace
}  // namespace burin::test

int main(int count, char** words) {
  return count == 4 ? burin::test::run(words[1], words[2], words[3]) : 2;
}
