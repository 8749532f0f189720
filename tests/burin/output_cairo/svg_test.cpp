#include <gtest/gtest.h>

#include "drawing.hpp"

namespace burin::test {
namespace {

Flow draw_cross(PathSink& to) {
  if (draw_line(to, {{1.0, 1.0}, {19.0, 9.0}}) == Flow::stop) return Flow::stop;
  return draw_line(to, {{1.0, 9.0}, {19.0, 1.0}});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CairoSvg, IsInMillimetres) {
  const std::string svg = drawn("svg", small_sheet(), draw_cross);
  EXPECT_TRUE(has(svg, "width=\"20mm\" height=\"10mm\" viewBox=\"0 0 20 10\"")) << svg;
  EXPECT_TRUE(has(svg, "d=\"M 1 1 L 19 9 M 1 9 L 19 1 \"")) << svg;
  EXPECT_TRUE(has(svg, "stroke-width:1;")) << svg;
  EXPECT_FALSE(has(svg, "transform")) << svg;
}

TEST(CairoSvg, CountsItsSurfacesFromOne) {
  Sheet sheet = small_sheet();
  sheet.layers[0].opacity = 0.5;
  const std::string svg = drawn("svg", sheet, draw_cross);
  EXPECT_TRUE(has(svg, "<g id=\"surface1\"")) << svg;
  EXPECT_TRUE(has(svg, "<g id=\"surface2\"")) << svg;
  EXPECT_TRUE(has(svg, "href=\"#surface1\"")) << svg;
  EXPECT_FALSE(has(svg, "surface3")) << svg;
}

TEST(CairoSvg, CarriesTheOrigin) {
  Sheet sheet = small_sheet();
  sheet.made_by = {
      .title = "A & B", .author = "Ren\xC3\xA9", .summary = "x < y", .record = "a = \"\\n\"\r\nsurface9 = 1\n"};
  const std::string svg = drawn("svg", sheet, draw_cross);
  EXPECT_TRUE(has(svg, "<title>A &amp; B</title>\n<desc>x &lt; y</desc>\n<metadata ")) << svg;
  EXPECT_TRUE(has(svg, "<dc:creator>Ren\xC3\xA9</dc:creator>")) << svg;
  EXPECT_TRUE(has(svg, "preserve\">a = &quot;\\\\n&quot;&#13;\nsurface9 = 1\n</burin:origin>")) << svg;
  EXPECT_LT(svg.find("<svg"), svg.find("<title>"));
  EXPECT_LT(svg.find("</metadata>"), svg.find("<g id"));
}

TEST(CairoSvg, ShowsThePaperOnRequestOnly) {
  OutputOptions options;
  EXPECT_FALSE(has(drawn("svg", small_sheet(), draw_cross, options), "<rect"));
  options.paper = true;
  EXPECT_TRUE(has(drawn("svg", small_sheet(), draw_cross, options), "<rect"));
}

TEST(CairoSvg, RefusesPagesBeyondCairosNumbers) {
  Sheet sheet = small_sheet();
  sheet.page.width_mm = 2e6;
  EXPECT_FALSE(cairo_back_end("svg").accepts(sheet, {}).ok());
}

// Cairo numbers its surfaces over the whole process and would write the time into a PDF.
TEST(Determinism, TheSameBytesWhateverWasDrawnBefore) {
  Sheet sheet = small_sheet();
  sheet.layers[0].opacity = 0.5;
  sheet.layers.push_back({.name = "second"});
  sheet.made_by.title = "Twice";
  const Draw draw = [](PathSink& to) {
    if (draw_cross(to) == Flow::stop) return Flow::stop;
    return draw_line(to, {{3.0, 3.0}, {4.0, 4.0}}, true, Paint::fill_nonzero, 1);
  };
  for (const char* format : {"svg", "pdf", "png"}) {
    const std::string first = drawn(format, sheet, draw);
    for (const char* other : {"svg", "pdf", "png"}) drawn(other, small_sheet(), draw_cross);
    EXPECT_EQ(first, drawn(format, sheet, draw)) << format;
  }
}

}  // namespace
}  // namespace burin::test
