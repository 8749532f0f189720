#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// What a million placed figures cost the whole tool, beside Cairo with one stroke for each, in turns.
namespace burin::test {
namespace {

/// A dragon's 2^20 + 1 points with a polygon of 24 sides at each.
std::string write_preset(const TemporaryFolder& folder) {
  std::string ring = "M";
  for (int i = 0; i < 24; ++i) {
    ring += fmt::format("{:.6f} {:.6f} ", 5 + 5 * std::cos(i * M_PI / 12), 5 + 5 * std::sin(i * M_PI / 12));
  }
  std::ofstream(folder.file("ring.svg"))
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\"><path fill=\"none\" stroke=\"black\" d=\""
      << ring << "z\"/></svg>";
  std::ofstream(folder.file("rings.toml"))
      << "burin = 1\npage = { size = \"a0\", margin = \"20mm\" }\npens = { ink = { width = \"0.05mm\" } }\n[[layer]]\n"
         "curve = { family = \"two-point\", motif = \"dragon\", levels = 20 }\n"
         "primitives = { use = \"ring.svg\", scale = 1.5, rotate = \"tangent\" }\n";
  return folder.file("rings.toml");
}

class PlacingBench : public testing::Test {
 protected:
  void compare(const std::string& format) {
    const std::string picture = folder.file("rings." + format);
    Cost native = unknown;
    Cost cairo = unknown;
    for (int turn = 0; turn < 3; ++turn) {
      native = cheapest(
          native, measured_run({BURIN_TOOL_PATH, "draw", preset, "--quiet", "--backend", "native", "-o", picture}));
      cairo =
          cheapest(cairo, measured_run({BURIN_STAMPS_PROGRAM_PATH, preset, format, folder.file("cairo." + format)}));
    }
    print_row(("a million figures, native " + format).c_str(), native);
    print_row(("a million figures, Cairo " + format).c_str(), cairo);
    std::printf("native / Cairo: cpu 1 / %.1f, bytes %.0f\n", cairo.cpu_s / native.cpu_s,
                static_cast<double>(std::filesystem::file_size(picture)));
    EXPECT_LE(native.cpu_s * 8.0, cairo.cpu_s);
    EXPECT_LE(native.peak_mib, 64.0);
  }

  TemporaryFolder folder;
  std::string preset = write_preset(folder);
};

TEST_F(PlacingBench, AMillionFiguresInSvgAreAnEighthOfCairos) {
  compare("svg");
}

TEST_F(PlacingBench, AMillionFiguresInPdfAreAnEighthOfCairos) {
  compare("pdf");
}

}  // namespace
}  // namespace burin::test
