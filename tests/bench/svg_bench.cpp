#include <cmath>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// What SVG costs: bytes, time and memory of the whole tool. Times are compared with each other, in turns, because they
/// depend on the machine; the table on stdout has them as they are.
namespace burin::test {
namespace {

double segments(int order) {
  return std::ldexp(1.0, 2 * order);  // a Koch curve's
}

class SvgBench : public testing::Test {
 protected:
  /// Draws a Koch curve into `picture`, with every point when `all`.
  Cost draw(int order, bool all, const std::string& backend = "native") const {
    std::vector<std::string> words = {
        BURIN_TOOL_PATH, "draw",  "koch", "--quiet", "-D", "levels=" + std::to_string(order),
        "--backend",     backend, "-o",   picture};
    if (all) words.emplace_back("--all-points");
    return measured_run(words);
  }

  double bytes() const { return static_cast<double>(std::filesystem::file_size(picture)); }

  TemporaryFolder folder;
  std::string picture = folder.file("koch.svg");
};

TEST_F(SvgBench, AMillionSegmentsAreSmallAndTwentyTimesCheaperThanCairos) {
  Cost native = unknown;
  Cost cairo = unknown;
  double native_bytes = 0.0;
  double cairo_bytes = 0.0;
  for (int turn = 0; turn < 5; ++turn) {
    native = cheapest(native, draw(10, true));
    native_bytes = bytes();
    cairo = cheapest(cairo, draw(10, true, "cairo"));
    cairo_bytes = bytes();
  }
  print_row("SVG, Koch, order 10, native", native);
  print_row("SVG, Koch, order 10, Cairo", cairo);
  std::printf("native / Cairo: cpu 1 / %.1f; bytes a segment: %.3f, Cairo %.3f\n", cairo.cpu_s / native.cpu_s,
              native_bytes / segments(10), cairo_bytes / segments(10));
  EXPECT_LE(native_bytes / segments(10), 8.5);
  EXPECT_LE(native.cpu_s * 20.0, cairo.cpu_s);
}

TEST_F(SvgBench, SixteenMillionSegmentsCostSixteenTimesAsMuchAndNoMemory) {
  Cost ten = unknown;
  Cost twelve = unknown;
  for (int turn = 0; turn < 5; ++turn) {
    ten = cheapest(ten, draw(10, true));
    twelve = cheapest(twelve, draw(12, true));
  }
  print_row("SVG, Koch, order 10, native", ten);
  print_row("SVG, Koch, order 12, native", twelve);
  std::printf("order 12 / order 10: cpu x %.1f, wall x %.1f; bytes a segment: %.3f\n", twelve.cpu_s / ten.cpu_s,
              twelve.wall_s / ten.wall_s, bytes() / segments(12));
  EXPECT_LE(twelve.cpu_s, 20.0 * ten.cpu_s);
  EXPECT_LE(twelve.wall_s, 20.0 * ten.wall_s);
  EXPECT_LE(twelve.peak_mib, 24.0);
}

TEST_F(SvgBench, TwoHundredLevelsTakeABlink) {
  Cost deep = unknown;
  for (int turn = 0; turn < 3; ++turn) deep = cheapest(deep, draw(200, false));
  print_row("SVG, Koch, 200 levels", deep);
  EXPECT_LE(deep.wall_s, 1.0);
  EXPECT_LE(deep.peak_mib, 24.0);
}

TEST(ToolBench, StartsWithinTenMilliseconds) {
  Cost version = unknown;
  for (int turn = 0; turn < 20; ++turn) version = cheapest(version, measured_run({BURIN_TOOL_PATH, "--version"}));
  print_row("burin --version", version);
  EXPECT_LT(version.wall_s, 0.010);
}

}  // namespace
}  // namespace burin::test
