#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// What PDF costs the whole tool, ours and Cairo's in turns: only ratios of one run are held to bars.
namespace burin::test {
namespace {

class PdfBench : public testing::Test {
 protected:
  struct Row {
    Cost cost = unknown;
    double bytes = 0.0;
  };

  /// `words`: a command up to the name of the back end and of the file.
  void run(Row& row, std::vector<std::string> words, const std::string& backend) const {
    words.insert(words.end(), {"--backend", backend, "-o", picture});
    row.cost = cheapest(row.cost, measured_run(words));
    row.bytes = static_cast<double>(std::filesystem::file_size(picture));
  }

  /// Runs the command with both back ends in turns and holds ours to the bars.
  void compare(const std::string& what, const std::vector<std::string>& words) const {
    Row native;
    Row cairo;
    for (int turn = 0; turn < 3; ++turn) {
      run(native, words, "native");
      run(cairo, words, "cairo");
    }
    print_row((what + ", native").c_str(), native.cost);
    print_row((what + ", Cairo").c_str(), cairo.cost);
    std::printf("native / Cairo: cpu 1 / %.1f, bytes %.0f / %.0f = %.2f\n", cairo.cost.cpu_s / native.cost.cpu_s,
                native.bytes, cairo.bytes, native.bytes / cairo.bytes);
    EXPECT_LE(native.cost.cpu_s * 6.0, cairo.cost.cpu_s);
    EXPECT_LE(native.bytes, cairo.bytes);
    EXPECT_LE(native.cost.peak_mib, 32.0);
  }

  static std::vector<std::string> koch(int order) {
    return {BURIN_TOOL_PATH, "draw", "koch", "--quiet", "--all-points", "-D", "levels=" + std::to_string(order)};
  }

  TemporaryFolder folder;
  std::string picture = folder.file("picture.pdf");
};

TEST_F(PdfBench, AMillionSegmentsAreSmallerAndASixthOfCairos) {
  compare("PDF, Koch, order 10", koch(10));
}

TEST_F(PdfBench, AHundredThousandLinesAreSmallerAndASixthOfCairos) {
  compare("PDF, 100,000 x 20 points", {BURIN_DRAW_LINES_PATH});
}

TEST_F(PdfBench, MemoryDoesNotGrowWithTheDrawing) {
  Row ten;
  Row twelve;
  run(ten, koch(10), "native");
  run(twelve, koch(12), "native");
  print_row("PDF, Koch, order 10", ten.cost);
  print_row("PDF, Koch, order 12", twelve.cost);
  EXPECT_LE(twelve.cost.peak_mib, ten.cost.peak_mib + 1.0);
  EXPECT_LE(twelve.cost.peak_mib, 32.0);
}

}  // namespace
}  // namespace burin::test
