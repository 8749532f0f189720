#include <gtest/gtest.h>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using Names = std::vector<std::string>;

TEST(Draw, WithoutOutputWritesTheNameAsSvgAndTells) {
  const TemporaryFolder folder;
  folder.write("mine.toml", koch_text);
  const Finished run = burin_in(folder, {"draw", "mine.toml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(folder.names(), (Names{"mine.svg", "mine.toml"}));
  EXPECT_TRUE(contains(folder.read("mine.svg"), "</svg>"));
  EXPECT_EQ(run.out.substr(0, 37), "mine.svg: 65 points drawn of 65 asked") << run.out;
  EXPECT_TRUE(contains(run.out, std::to_string(folder.read("mine.svg").size() % 1000) + " bytes\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "page  210 x 297 mm\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "pen   1 ink #000000 0.3 mm\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "seed  1 (nothing here is random)\n")) << run.out;
}

TEST(Draw, TheWordDrawMayBeLeftOutBeforeAFile) {
  const TemporaryFolder folder;
  folder.write("mine.toml", koch_text);
  EXPECT_EQ(burin_in(folder, {"mine.toml", "-q", "-o", "a.svg"}).code, 0);
  EXPECT_EQ(burin_in(folder, {"draw", "mine.toml", "-q", "-o", "b.svg"}).code, 0);
  EXPECT_EQ(folder.read("a.svg"), folder.read("b.svg"));
}

TEST(Draw, FormatFollowsTheSuffixUnlessGiven) {
  const TemporaryFolder folder;
  const Finished run =
      burin_in(folder, {"draw", "koch", "-D", "levels=2", "-o", "a.CSV", "-o", "b.svg", "-o", "c.dump"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.read("a.CSV").substr(0, 14), "layer,path,x,y");
  EXPECT_TRUE(contains(folder.read("b.svg"), "<svg"));
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-D", "levels=2", "--format", "csv", "-o", "d.svg"}).code, 0);
  EXPECT_EQ(folder.read("d.svg"), folder.read("a.CSV"));
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-D", "levels=2", "--format", "csv"}).code, 0);
  EXPECT_EQ(folder.read("koch.csv"), folder.read("a.CSV"));
}

TEST(Draw, StdinAndStdoutAreDashes) {
  const TemporaryFolder folder;
  ToolSetup setup;
  setup.input = koch_text;
  const Finished run = burin_in(folder, {"draw", "-", "-o", "-"}, setup);
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.out, "<svg"));
  EXPECT_TRUE(contains(run.out, "</svg>"));
  EXPECT_FALSE(contains(run.out, "points drawn"));
  EXPECT_TRUE(contains(run.err, "stdout: 65 points drawn")) << run.err;
  EXPECT_TRUE(folder.names().empty());
  EXPECT_EQ(burin_in(folder, {"draw", "-", "-o", "/dev/stdout"}, setup).out, run.out);
  EXPECT_EQ(burin_in(folder, {"draw", "-", "-q", "-o", "-"}, setup).err, "");
  EXPECT_EQ(burin_in(folder, {"draw", "-"}, setup).code, 0);
  EXPECT_EQ(folder.names(), Names{"drawing.svg"});
}

TEST(Draw, AppendingToAFileThroughStdoutKeepsItsBeginning) {
  const TemporaryFolder folder;
  folder.write("log", "first\n");
  EXPECT_EQ(shell_in(folder, "burin draw koch -q -o /dev/stdout >> log").code, 0);
  EXPECT_EQ(folder.read("log").substr(0, 10), "first\n<?xm");
}

TEST(Draw, TwoRunsWriteTheSameBytes) {
  const TemporaryFolder folder;
  Names formats{"svg", "csv", "dump"};
#ifdef BURIN_HAS_CAIRO
  formats.insert(formats.end(), {"pdf", "png"});
#endif
  for (const std::string& format : formats) {
    EXPECT_EQ(burin_in(folder, {"draw", "winter-card", "-q", "-o", "a." + format}).code, 0) << format;
    EXPECT_EQ(burin_in(folder, {"draw", "winter-card", "-q", "-o", "b." + format}).code, 0) << format;
    EXPECT_FALSE(folder.read("a." + format).empty()) << format;
    EXPECT_TRUE(folder.read("a." + format) == folder.read("b." + format)) << format;
  }
}

TEST(Draw, SeveralOutputsAreTheSingleOnes) {
  const TemporaryFolder folder;
  const Names formats{"svg", "csv", "dump"};
  Names words{"draw", "winter-card", "-q", "--decimals", "2"};
  for (const std::string& format : formats) words.insert(words.end(), {"-o", "all." + format});
  EXPECT_EQ(burin_in(folder, words).code, 0);
  EXPECT_EQ(burin_in(folder, {"draw", "winter-card", "-q", "--decimals", "2", "-o", "one.svg"}).code, 0);
  EXPECT_EQ(burin_in(folder, {"draw", "winter-card", "-q", "-o", "one.csv"}).code, 0);
  EXPECT_EQ(burin_in(folder, {"draw", "winter-card", "-q", "-o", "one.dump"}).code, 0);
  for (const std::string& format : formats)
    EXPECT_TRUE(folder.read("all." + format) == folder.read("one." + format)) << format;
}

TEST(Draw, PageOptionsReachThePage) {
  const TemporaryFolder folder;
  const Finished run = burin_in(folder, {"draw", "koch", "--page", "a5", "--landscape", "--margin", "20mm 30mm"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "page  210 x 148 mm")) << run.out;
  EXPECT_TRUE(contains(folder.read("koch.svg"), "width=\"210mm\" height=\"148mm\""));
}

TEST(Draw, AViewBlowsUpAPartOfThePage) {
  const TemporaryFolder folder;
  const Names deep{"draw", "koch", "-D", "levels=1000", "--view", "148.5,37.1465,0.02", "--decimals", "1", "-o"};
  Names words = deep;
  words.push_back("deep.svg");
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(folder.read("deep.svg"), "<path"));
  EXPECT_LT(folder.read("deep.svg").size(), 2'000'000U);
  words.back() = "deep.csv";
  const Finished csv = burin_in(folder, words);
  EXPECT_EQ(csv.code, 2);
  EXPECT_TRUE(contains(csv.err, "--view")) << csv.err;
  for (const char* wrong : {"", "1", "1,2", "1,2,3,4", "1,2,0", "1,2,-1", "nan,2,3", "1,2,inf", "a,b,c", "1,2,3mm"}) {
    const Finished bad = burin_in(folder, {"draw", "koch", "--view", wrong});
    EXPECT_EQ(bad.code, 2) << wrong;
    EXPECT_TRUE(contains(bad.err, "--view must be")) << bad.err;
  }
}

TEST(Draw, SeedsAreWholeNumbersOrRandom) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(burin_in(folder, {"draw", "koch", "--seed", "-3"}).out, "seed  18446744073709551613"));
  EXPECT_TRUE(
      contains(burin_in(folder, {"draw", "koch", "--seed", "18446744073709551615"}).out, "1844674407370955161"));
  const Finished random = burin_in(folder, {"draw", "koch", "--seed", "random"});
  EXPECT_EQ(random.code, 0);
  EXPECT_TRUE(contains(random.out, "seed  ")) << random.out;
  EXPECT_NE(random.out, burin_in(folder, {"draw", "koch", "--seed", "random"}).out);
  for (const char* wrong : {"x", "1.5", "18446744073709551616", "-9223372036854775809", "-", " 1"}) {
    const Finished run = burin_in(folder, {"draw", "koch", "--seed", wrong});
    EXPECT_EQ(run.code, 2) << wrong;
    EXPECT_TRUE(contains(run.err, "--seed must be")) << run.err;
  }
}

TEST(Draw, OnlyAndSkipChooseLayers) {
  const TemporaryFolder folder;
  const std::string second =
      "[[layer]]\nname = \"other\"\ncurve = { family = \"two-point\", motif = \"levy\", levels = 2 }\n";
  folder.write("two.toml", koch_text + second);
  const auto csv = [&](const Names& options) {
    Names words{"draw", "two.toml", "-q", "-o", "-", "--format", "csv"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  EXPECT_NE(csv({}), csv({"--only", "curve"}));
  EXPECT_EQ(csv({"--only", "curve"}), csv({"--skip", "other"}));
  EXPECT_EQ(csv({}), csv({"--only", "curve", "--only", "other"}));
  const Finished wrong = burin_in(folder, {"draw", "two.toml", "--only", "curv", "--skip", "oter"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "--only: there is no layer 'curv'; did you mean 'curve'?")) << wrong.err;
  EXPECT_TRUE(contains(wrong.err, "--skip: there is no layer 'oter'; did you mean 'other'?")) << wrong.err;
  EXPECT_FALSE(folder.has("two.svg"));
}

TEST(Draw, HugeLevelsAreDrawnInABlink) {
  const TemporaryFolder folder;
  folder.write("mine.toml", koch_text);
  RunningTool tool(tool_words({"draw", "mine.toml", "-D", "levels=200"}), {folder.path().string(), {}, {}, {}});
  const Finished run = tool.wait(std::chrono::seconds(20));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "of 2.6e+120 asked")) << run.out;
}

TEST(Draw, TheOriginLetsItBeDrawnAgain) {
  const TemporaryFolder folder;
  folder.write("mine.toml", koch_text);
  EXPECT_EQ(burin_in(folder, {"draw", "mine.toml", "-q", "-D", "levels=2", "--page", "a6"}).code, 0);
  const std::string svg = folder.read("mine.svg");
  EXPECT_TRUE(contains(svg, "levels=2")) << svg;
  EXPECT_TRUE(contains(svg, "mine.toml"));
  EXPECT_TRUE(contains(svg, "a6"));
  EXPECT_TRUE(contains(svg, "refinement levels"));
  EXPECT_FALSE(contains(svg, folder.path().string()));
}

TEST(Draw, VerboseNamesTheLayersAndQuietSaysNothing) {
  const TemporaryFolder folder;
  folder.write("mine.toml", koch_text);
  EXPECT_TRUE(contains(burin_in(folder, {"draw", "mine.toml", "-v"}).out, "layer curve with pen 1"));
  const Finished quiet = burin_in(folder, {"draw", "mine.toml", "-q"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(Draw, DataFilesAreReadBesideThePreset) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  folder.write("sub/base.csv", "x,y\n0,0\n1,0\n1,1\n");
  folder.write("sub/data.toml",
               "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", motif = \"koch\", levels = 1, base = { csv = "
               "\"base.csv\" } }\n");
  EXPECT_EQ(burin_in(folder, {"draw", "sub/data.toml"}).code, 0) << burin_in(folder, {"draw", "sub/data.toml"}).err;
  EXPECT_TRUE(contains(burin_in(folder, {"draw", "sub/data.toml", "-v"}).out, "data  base.csv sha256 "));
  std::filesystem::remove(folder.path() / "sub/base.csv");
  EXPECT_EQ(burin_in(folder, {"draw", "sub/data.toml"}).code, 3);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "sub/base.csv");
  const Finished endless = burin_in(folder, {"draw", "sub/data.toml"});
  EXPECT_EQ(endless.code, 3);
  EXPECT_TRUE(contains(endless.err, "regular")) << endless.err;
}

#ifdef BURIN_HAS_CAIRO
TEST(Draw, LoadsCairoForItsDrawingsOnly) {
  const TemporaryFolder folder;
  ToolSetup setup;
  setup.environment.emplace_back("LD_DEBUG", "files");  // the loader says what it loads
  const auto loads_cairo = [&](const std::string& back_end) {
    const Finished finished = burin_in(folder, {"draw", "koch", "-q", "--backend", back_end, "-o", "a.png"}, setup);
    EXPECT_EQ(finished.code, 0);
    EXPECT_TRUE(contains(finished.err, "libc.so"));
    return contains(finished.err, "libcairo");
  };
  EXPECT_TRUE(loads_cairo("cairo"));
  EXPECT_FALSE(loads_cairo("native"));
}

TEST(Draw, PngSizeIsTheLongerSide) {
  const TemporaryFolder folder;
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-q", "--size", "500px", "-o", "a.png"}).code, 0);
  const std::string png = folder.read("a.png");
  ASSERT_GT(png.size(), 24U);
  const auto big_endian = [&](std::size_t at) {
    return (static_cast<unsigned char>(png[at + 2]) << 8) + static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(std::max(big_endian(16), big_endian(20)), 500);
}
#endif

}  // namespace
}  // namespace burin::test
