#include <filesystem>

#include <gtest/gtest.h>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using Words = std::vector<std::string>;

/// A run that must fail with this code and these words on stderr, and leave nothing behind.
void expect_refused(const Words& words, int code, const Words& said, const std::string& preset = koch_text) {
  const TemporaryFolder folder;
  folder.write("p.toml", preset);
  const Finished run = burin_in(folder, words);
  std::string line;
  for (const std::string& word : words) line += ' ' + word;
  EXPECT_EQ(run.code, code) << line << '\n' << run.err;
  EXPECT_EQ(run.out, "") << line;
  EXPECT_TRUE(contains(run.err, "error: ")) << line << '\n' << run.err;
  for (const std::string& part : said) EXPECT_TRUE(contains(run.err, part)) << line << '\n' << part << '\n' << run.err;
  EXPECT_EQ(folder.names(), Words{"p.toml"}) << line;
}

TEST(Errors, WrongCommandLinesAreUsage) {
  expect_refused({"draw"}, 2, {"say what to draw", "'burin draw --help'"});
  expect_refused({"draw", "p.toml", "q.toml"}, 2, {"one preset at a time"});
  expect_refused({"draw", "p.toml", "--levels", "3"}, 2, {"unknown option '--levels'"});
  expect_refused({"draw", "p.toml", "--forma", "svg"}, 2, {"did you mean '--format'?"});
  expect_refused({"draw", "p.toml", "-D", "levels"}, 2, {"-D name=value, not 'levels'"});
  expect_refused({"draw", "p.toml", "--set", "=3"}, 2, {"--set name=value, not '=3'"});
  expect_refused({"draw", "p.toml", "-o", "a.gif"}, 2, {"'.gif'", "svg"});
  expect_refused({"draw", "p.toml", "-o", "plain"}, 2, {"no suffix", "--format"});
  expect_refused({"draw", "p.toml", "--format", "gif"}, 2, {"there is no format 'gif'; formats: "});
  expect_refused({"draw", "p.toml", "-o", "a.csv", "--backend", "cairo"}, 2, {"back ends of csv: native"});
  expect_refused({"draw", "p.toml", "-o", "a.svg", "-o", "a.svg"}, 2, {"given twice"});
  expect_refused({"draw", "p.toml", "-o", "a.svg", "-o", "./a.svg"}, 2, {"-o ./a.svg is given twice"});
  expect_refused({"draw", "p.toml", "--decimals", "7"}, 2, {"--decimals", "from 0 to 6"});
  expect_refused({"draw", "p.toml", "--decimals", "1.5"}, 2, {"whole number"});
  expect_refused({"draw", "p.toml", "--decimals", "2", "-o", "a.csv"}, 2, {"--decimals is for svg"});
  expect_refused({"draw", "p.toml", "--max-points", "nan"}, 2, {"--max-points"});
  expect_refused({"draw", "p.toml", "--dpi", "300"}, 2, {"--dpi is for png"});
  expect_refused({"draw", "p.toml", "--size", "2000mm"}, 2, {"2000px, not '2000mm'"});
  expect_refused({"draw", "p.toml", "--size", "1e400px"}, 2, {"--size"});
  expect_refused({"check"}, 2, {"name the presets"});
  expect_refused({"show"}, 2, {"name one"});
  expect_refused({"list", "a", "b"}, 2, {"one thing"});
}

TEST(Errors, AllThatIsWrongWithACommandLineIsShown) {
  expect_refused({"draw", "p.toml", "--seed", "x", "--decimals", "9", "-o", "a.gif"}, 2,
                 {"--seed must", "--decimals must", "'.gif'"});
}

#ifdef BURIN_HAS_CAIRO
TEST(Errors, BackEndsAndResolutions) {
  expect_refused({"draw", "p.toml", "-o", "a.csv", "--backend", "cairo"}, 2, {"back ends of csv: native"});
  expect_refused({"draw", "p.toml", "-o", "a.png", "--backend", "native", "--size", "200000px"}, 4, {"100000 a side"});
  expect_refused({"draw", "p.toml", "-o", "a.png", "--dpi", "100", "--size", "100px"}, 2, {"give one of them"});
}
#endif

TEST(Errors, WrongPresetsAreInput) {
  const std::string text = koch_text;
  expect_refused({"draw", "p.toml"}, 3, {"p.toml:10:1: error: ", "amplitud"}, text + "amplitud = 1\n");
  expect_refused({"draw", "p.toml"}, 3, {"p.toml:1:"}, "burin = = 1\n");
  expect_refused({"draw", "p.toml"}, 3, {"p.toml"}, "");
  expect_refused({"draw", "p.toml"}, 3, {"p.toml:3:"},
                 "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", motif = \"koch\", levels = \"many\" }\n");
  expect_refused({"draw", "p.toml", "-D", "levels=1001"}, 3, {"1001", "1000"});
  expect_refused({"draw", "p.toml", "-D", "levels=nan"}, 3, {"levels"});
  expect_refused({"draw", "p.toml", "-D", "levels=-1"}, 3, {"levels"});
  expect_refused({"draw", "p.toml", "-D", "level=1"}, 3, {"did you mean 'levels'?"});
  expect_refused({"draw", "p.toml", "--set", "page.colour=red"}, 3, {"colour"});
  expect_refused({"draw", "p.toml", "--page", "a99"}, 3, {"a99"});
  expect_refused({"draw", "missing.toml"}, 3, {"missing.toml: error: cannot be read: No such file"});
  expect_refused({"draw", "./"}, 3, {"is a folder"});
  expect_refused({"draw", "kohc"}, 3, {"there is no preset 'kohc'; did you mean 'koch'?", "looked in"});
}

TEST(Errors, AllThatIsWrongWithAPresetIsShown) {
  expect_refused(
      {"draw", "p.toml"}, 3, {"p.toml:2:1: error", "p.toml:5:"},
      "burin = 1\ncolour = 1\n[[layer]]\n# here\nlevls = 4\ncurve = { family = \"two-point\", motif = \"koch\" }\n");
}

TEST(Errors, HostilePresetsEndSoon) {
  std::string keys = "a";
  for (int i = 0; i < 50000; ++i) keys += ".a";
  const TemporaryFolder folder;
  folder.write("dots.toml", "burin = 1\n" + keys + " = 1\n");
  folder.write("deep.toml", "burin = 1\nx = " + std::string(100000, '[') + '\n');
  folder.write("large.toml", "burin = 1\n#" + std::string(300000, 'x') + '\n');
  folder.write("bytes.toml", std::string("burin = 1\n\0\xff\xfe", 13));
  for (const char* name : {"dots.toml", "deep.toml", "large.toml", "bytes.toml", "/dev/zero"}) {
    RunningTool tool(tool_words({"draw", name}), {folder.path().string(), {}, {}, {}});
    const Finished run = tool.wait(std::chrono::seconds(20));
    EXPECT_EQ(run.code, 3) << name << '\n' << run.err.substr(0, 2000);
    EXPECT_TRUE(contains(run.err, "error: ")) << name;
    EXPECT_LT(run.err.size(), 4000U) << name;
  }
  EXPECT_EQ(folder.names().size(), 4U);
}

TEST(Errors, TooManyPointsNameTheKnobAndTheOption) {
  expect_refused({"draw", "p.toml", "--all-points", "-D", "levels=200"}, 4, {"levels", "--max-points"});
  expect_refused({"draw", "p.toml", "--all-points", "-D", "levels=4", "--max-points", "256"}, 4, {"--max-points"});
  expect_refused({"draw", "p.toml", "-o", "a.csv", "-D", "levels=1000"}, 4, {"levels", "--max-points"});
#ifdef BURIN_HAS_CAIRO
  expect_refused({"draw", "p.toml", "-o", "a.png", "--size", "30000px"}, 4, {"png through cairo", "--max-memory"});
  expect_refused({"draw", "p.toml", "-o", "a.pdf", "--max-memory", "1"}, 4, {"pdf through cairo", "--max-memory"});
#endif
  const TemporaryFolder folder;
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "--all-points", "-D", "levels=4", "--max-points", "257"}).code, 0);
}

TEST(Errors, ColoursAreForTerminalsOnly) {
  const TemporaryFolder folder;
  const Finished run = burin_in(folder, {"draw", "kohc"});
  EXPECT_FALSE(contains(run.err, "\x1b")) << run.err;
}

#ifdef BURIN_CORE_LIBRARY
TEST(Errors, AnIncompleteInstallationIsSaid) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(BURIN_CORE_LIBRARY, folder.file(BURIN_CORE_NAME));
  folder.write("p.toml", koch_text);
  ToolSetup setup;
  setup.environment.emplace_back("LD_LIBRARY_PATH", folder.path().string());
  const Finished run = burin_in(folder, {"draw", "p.toml", "--backend", "cairo", "-o", "-"}, setup);
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.err, "Cairo's back ends are not installed: ")) << run.err;
  EXPECT_TRUE(contains(run.err, "--backend native")) << run.err;
  EXPECT_FALSE(contains(run.err, "report")) << run.err;
}
#endif

TEST(Errors, AClosedStdinIsAnError) {
  const TemporaryFolder folder;
  ToolSetup setup;
  setup.in_child = [] { close(STDIN_FILENO); };
  const Finished run = burin_in(folder, {"draw", "-"}, setup);
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(contains(run.err, "-: error: cannot be read")) << run.err;
}

}  // namespace
}  // namespace burin::test
