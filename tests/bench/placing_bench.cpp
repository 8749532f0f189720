#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// What placed figures cost the whole tool: a million of them, and fewer beside Cairo with one stroke for each, in
/// turns. Cairo takes ten minutes and more for a million, and more than its share for each.
namespace burin::test {
namespace {

/// A dragon's 2^levels + 1 points with a polygon of 24 sides at each.
std::string write_preset(const TemporaryFolder& folder, int levels) {
  std::string ring = "M";
  for (int i = 0; i < 24; ++i) {
    ring += fmt::format("{:.6f} {:.6f} ", 5 + 5 * std::cos(i * M_PI / 12), 5 + 5 * std::sin(i * M_PI / 12));
  }
  std::ofstream(folder.file("ring.svg"))
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\"><path fill=\"none\" stroke=\"black\" d=\""
      << ring << "z\"/></svg>";
  const std::string preset = folder.file(fmt::format("rings{}.toml", levels));
  std::ofstream(preset)
      << "burin = 1\npage = { size = \"a0\", margin = \"20mm\" }\npens = { ink = { width = \"0.05mm\" } }\n[[layer]]\n"
         "curve = { family = \"two-point\", motif = \"dragon\", levels = "
      << levels
      << " }\n"
         "primitives = { use = \"ring.svg\", scale = 1.5, rotate = \"tangent\" }\n";
  return preset;
}

class PlacingBench : public testing::Test {
 protected:
  void compare(const std::string& format) {
    const std::string picture = folder.file("rings." + format);
    const auto native = [&](const std::string& preset) {
      return measured_run({BURIN_TOOL_PATH, "draw", preset, "--quiet", "--backend", "native", "-o", picture});
    };
    const std::string some = write_preset(folder, 14);
    const Ratio ratio = times_theirs(
        3, [&] { return native(some).cpu_s; },
        [&] {
          return measured_run({BURIN_STAMPS_PROGRAM_PATH, some, format, folder.file("cairo." + format)}).cpu_s;
        });
    print_ratio(("16,385 figures, " + format + ": Cairo / native").c_str(), ratio);
    const Cost million = native(write_preset(folder, 20));
    print_row(("a million figures, native " + format).c_str(), million);
    EXPECT_GE(ratio.median, 8.0);
    EXPECT_LE(million.peak_mib, 64.0);
  }

  TemporaryFolder folder;
};

TEST_F(PlacingBench, FiguresInSvgAreAnEighthOfCairos) {
  compare("svg");
}

TEST_F(PlacingBench, FiguresInPdfAreAnEighthOfCairos) {
  compare("pdf");
}

}  // namespace
}  // namespace burin::test
