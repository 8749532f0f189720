#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/path/back_end.hpp>

/// Drawing small sheets with Cairo's back ends and looking at what came out.
namespace burin::test {

const BackEnd& cairo_back_end(std::string_view format);

/// 20 x 10 mm of white paper, one black pen of 1 mm in one layer.
Sheet small_sheet();

/// 10 pixels to the millimetre.
OutputOptions ten_dots();

using Draw = std::function<Flow(PathSink& to)>;

/// One path of one contour.
Flow draw_line(PathSink& to, const std::vector<Vec2>& points, bool closed = false, Paint paint = Paint::stroke,
               LayerId layer = 0);

/// The bytes of a drawing that must succeed.
std::string drawn(std::string_view format, const Sheet& sheet, const Draw& draw,
                  const OutputOptions& options = ten_dots());

/// A decoded PNG, 8-bit RGB.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  int red(int x, int y) const { return rgb[static_cast<std::size_t>(3 * (y * width + x))]; }
  int green(int x, int y) const { return rgb[static_cast<std::size_t>(3 * (y * width + x) + 1)]; }
};
Pixels decoded(const std::string& png);
Pixels pixels(const Sheet& sheet, const Draw& draw, const OutputOptions& options = ten_dots());

/// What black on white covers, in pixels.
double ink(const Pixels& pixels);

/// How many pixels differ by more than `tolerance` of 255.
int differing(const Pixels& a, const Pixels& b, int tolerance);

}  // namespace burin::test
