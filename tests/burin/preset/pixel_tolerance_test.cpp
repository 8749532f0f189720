#include <cmath>
#include <cstdlib>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/burin.hpp>
#include <burin/data/image.hpp>
#include <burin/output/back_ends.hpp>

/// What a picture loses by curves that are refined only as far as its pixels show.
namespace burin {
namespace {

constexpr int side_px = 220;
constexpr double side_mm = 200.0;

/// A page of side_px with a line one pixel wide.
std::string page_with(const std::string& motif, int levels) {
  return fmt::format(
      "burin = 1\npage = {{ size = \"{0}x{0}mm\", margin = \"10mm\" }}\npens = {{ ink = {{ width = \"{1}mm\" }} }}\n"
      "layer = [{{ curve = {{ family = \"two-point\", motif = \"{2}\", levels = {3} }} }}]\n",
      side_mm, side_mm / side_px, motif, levels);
}

data::Image picture(const std::string& preset, bool every_point) {
  const Result<preset::Plan> plan = load({"test.toml", preset});
  const OutputOptions options{.dots_per_mm = side_px / side_mm};
  StringSink bytes;
  for (BackEnd back_end : output::back_ends()) {
    if (back_end.format != "png") continue;
    if (every_point) back_end.tolerance_mm = [](const Sheet&, const OutputOptions&) { return 0.0; };
    EXPECT_TRUE(write(*plan, back_end, bytes, options));
  }
  return *data::read_png(bytes.take(), "test.png");
}

/// The mean difference of the pixels that have ink in either, of 255.
double mean_change(const data::Image& a, const data::Image& b) {
  double sum = 0.0;
  int inked = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const int in_a = a.pixel(x, y)[0];
      const int in_b = b.pixel(x, y)[0];
      if (in_a == 255 && in_b == 255) continue;
      ++inked;
      sum += std::abs(in_a - in_b);
    }
  }
  return sum / inked;
}

struct Limited {
  const char* motif;
  int levels;
  double most;  ///< of 255
};

class PixelTolerance : public testing::TestWithParam<Limited> {};

/// A one-sided crinkle of 0.08 pixels is worth one part in 255 of what is inked, one on both sides up to four.
TEST_P(PixelTolerance, ChangesLittleOfAPicture) {
  const Limited& c = GetParam();
  const std::string preset = page_with(c.motif, c.levels);
  const double change = mean_change(picture(preset, true), picture(preset, false));
  RecordProperty("mean_change", fmt::format("{:.3f}", change));
  EXPECT_GT(change, 0.0);  // else nothing was left out
  EXPECT_LE(change, c.most);
}

INSTANTIATE_TEST_SUITE_P(Curves, PixelTolerance,
                         testing::Values(Limited{"koch", 8, 1.2}, Limited{"minkowski", 6, 4.0},
                                         Limited{"quad18", 5, 4.0}),
                         [](const auto& test) { return std::string(test.param.motif); });

}  // namespace
}  // namespace burin
