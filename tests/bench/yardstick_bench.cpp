#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/costs.hpp"
#include "support/temporary_folder.hpp"

/// Context Free (cfdg) and GNU plotutils draw the same Koch curve of order 10, in turns with the tool. cfdg's edges are
/// soft as ours; plotutils' PNG has none, so it is asked for SVG only.
namespace burin::test {
namespace {

constexpr int order = 10;
constexpr int turns = 5;

/// A shape for each level: cfdg 3.4 takes no arithmetic in a shape's arguments. The pen is one pixel of 2000.
std::string koch_cfdg() {
  std::string text = fmt::format("startshape k{}\nCF::Background = [b 0]\npath k0 {{ MOVETO(0,0) LINETO(1,0) ", order);
  text += fmt::format("STROKE({}, CF::ButtCap)[] }}\n", 0.0005 * std::pow(3.0, order));
  for (int level = 1; level <= order; ++level) {
    text += fmt::format(
        "shape k{0} {{ k{1}[s 0.3333333333] k{1}[x 0.3333333333 s 0.3333333333 r 60] k{1}[x 0.5 y 0.2886751346 s "
        "0.3333333333 r -60] k{1}[x 0.6666666667 s 0.3333333333] }}\n",
        level, level - 1);
  }
  return text;
}

class YardstickBench : public testing::Test {
 protected:
  YardstickBench() {
    std::ofstream(preset) << "burin = 1\npage = { size = \"200x200mm\" }\npens = { ink = { width = \"0.1mm\" } }\n"
                             "layer = [{ curve = { family = \"two-point\", motif = \"koch\", levels = "
                          << order << " } }]\n";
    std::ofstream(design) << koch_cfdg();
  }

  Cost ours(const std::string& suffix, const std::vector<std::string>& options) const {
    std::vector<std::string> words{BURIN_TOOL_PATH, "draw",      preset, "-q", "--backend",
                                   "native",        "--threads", "1",    "-o", folder.file("ours." + suffix)};
    words.insert(words.end(), options.begin(), options.end());
    return measured_run(words);
  }
  Cost cfdg(const std::string& suffix) const {
    std::vector<std::string> words{"cfdg", "-q", "-s", "2000", "-b", "0", "-x", "0.00001"};
    if (suffix == "svg") words.emplace_back("-V");
    words.insert(words.end(), {design, folder.file("cfdg." + suffix)});
    return measured_run(words);
  }
  double bytes(const std::string& name) const {
    return static_cast<double>(std::filesystem::file_size(folder.file(name)));
  }

  TemporaryFolder folder;
  std::string preset = folder.file("koch.toml");
  std::string design = folder.file("koch.cfdg");
};

TEST_F(YardstickBench, PngIsSixtyTimesCheaperThanCfdgs) {
  const Ratio ratio = times_theirs(
      turns,
      [&] {
        return ours("png", {"--size", "2000px"}).cpu_s;
      },
      [&] { return cfdg("png").cpu_s; });
  print_ratio("Koch, order 10, PNG: cfdg / native", ratio);
  EXPECT_GE(ratio.median, 45.0);
}

TEST_F(YardstickBench, SvgIsAHundredTimesCheaperThanCfdgsAndTenTimesSmaller) {
  const Ratio ratio = times_theirs(
      turns, [&] { return ours("svg", {"--all-points"}).cpu_s; }, [&] { return cfdg("svg").cpu_s; });
  print_ratio("Koch, order 10, SVG: cfdg / native", ratio);
  EXPECT_GE(ratio.median, 60.0);
  EXPECT_LE(10.0 * bytes("ours.svg"), bytes("cfdg.svg"));
}

#ifdef BURIN_PLOTTER_PROGRAM_PATH
TEST_F(YardstickBench, SvgIsTenTimesCheaperThanPlotutils) {
  const Ratio ratio = times_theirs(
      turns, [&] { return ours("svg", {"--all-points"}).cpu_s; },
      [&] {
        return measured_run({BURIN_PLOTTER_PROGRAM_PATH, preset, folder.file("plotutils.svg")}).cpu_s;
      });
  print_ratio("Koch, order 10, SVG: plotutils / native", ratio);
  EXPECT_GE(ratio.median, 8.0);
  EXPECT_LE(bytes("ours.svg"), bytes("plotutils.svg"));
}
#endif

}  // namespace
}  // namespace burin::test
