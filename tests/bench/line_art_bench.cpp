#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// What 100,000 random polylines of 20 points cost the whole tool, ours and Cairo's in turns: only ratios of one run
/// are held to bars.
namespace burin::test {
namespace {

class LineArtBench : public testing::Test {
 protected:
  LineArtBench() {
    std::ofstream(preset) << "burin = 1\n"
                             "page = { size = \"200x200mm\", margin = \"5mm\" }\n"
                             "[pens]\n"
                             "ink = { color = \"black\", width = \"0.1mm\" }\n"
                             "[slots]\n"
                             "all = { frame = [0, 0, 190, 190] }\n"
                             "[[layer]]\n"
                             "slot = \"all\"\n"
                             "curve = { family = \"line-art\", lines = 100000, segments = 19, length = [0.2, 0.6], "
                             "start = [15, 15, 175, 175] }\n";
  }

  /// Draws into a file of this kind with both back ends in turns and holds ours to `times_cheaper`.
  void compare(const std::string& suffix, double times_cheaper) const {
    const std::string picture = folder.file("lines." + suffix);
    const auto run = [&](const char* backend) {
      return measured_run(
          {BURIN_TOOL_PATH, "draw", preset, "--quiet", "--threads", "1", "--backend", backend, "-o", picture});
    };
    Cost native = unknown;
    Cost cairo = unknown;
    for (int turn = 0; turn < 3; ++turn) {
      native = cheapest(native, run("native"));
      cairo = cheapest(cairo, run("cairo"));
    }
    print_row(("line art, " + suffix + ", native").c_str(), native);
    print_row(("line art, " + suffix + ", Cairo").c_str(), cairo);
    std::printf("native / Cairo: cpu 1 / %.1f\n", cairo.cpu_s / native.cpu_s);
    EXPECT_LE(native.cpu_s * times_cheaper, cairo.cpu_s);
    EXPECT_LE(native.peak_mib, 64.0);
  }

  TemporaryFolder folder;
  std::string preset = folder.file("lines.toml");
};

TEST_F(LineArtBench, SvgCostsATenthOfCairos) {
  compare("svg", 10.0);
}

TEST_F(LineArtBench, PdfCostsASixthOfCairos) {
  compare("pdf", 6.0);
}

/// 2362 x 2362 pixels with ink almost everywhere, which are kept whole.
TEST_F(LineArtBench, PngCostsAFourthOfCairos) {
  compare("png", 4.0);
}

}  // namespace
}  // namespace burin::test
