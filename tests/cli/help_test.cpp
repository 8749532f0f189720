#include <chrono>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cli/command.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

TEST(Help, BareToolPrintsTheCommandsOnStdout) {
  const TemporaryFolder folder;
  const Finished bare = burin_in(folder, {});
  EXPECT_EQ(bare.code, 0);
  EXPECT_EQ(bare.err, "");
  for (const cli::Command& command : cli::commands()) {
    EXPECT_TRUE(contains(bare.out, "  " + std::string(command.name) + ' ')) << command.name;
    EXPECT_TRUE(contains(bare.out, std::string(command.summary))) << command.name;
  }
  EXPECT_EQ(burin_in(folder, {"--help"}).out, bare.out);
  EXPECT_EQ(burin_in(folder, {"help"}).out, bare.out);
}

TEST(Help, EveryCommandTellsItsOptionsWithinEightyColumns) {
  const TemporaryFolder folder;
  for (const cli::Command& command : cli::commands()) {
    const Finished help = burin_in(folder, {std::string(command.name), "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_FALSE(command.examples.empty()) << command.name;
    for (const cli::OptionRow& row : command.options) {
      EXPECT_TRUE(contains(help.out, "--" + std::string(row.name))) << command.name << ' ' << row.name;
    }
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_EQ(burin_in(folder, {"help", std::string(command.name)}).out, help.out);
  }
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const cli::Command& command : cli::commands()) names.emplace_back(command.name);
  return names;
}

class HelpOfEveryCommand : public testing::TestWithParam<std::string> {};

TEST_P(HelpOfEveryCommand, HasExamplesThatRunInAnEmptyFolder) {
  for (const cli::Example& example : cli::find_command(GetParam())->examples) {
    const TemporaryFolder folder;
    const std::string line(example.line);
#ifndef BURIN_HAS_CAIRO
    if (contains(line, ".pdf") || contains(line, ".png") || contains(line, "gallery")) continue;
#endif
    EXPECT_EQ(line.substr(0, 6), "burin ");
    const Finished run = shell_in(folder, example.endless ? "timeout --preserve-status -s INT 0.3 " + line : line);
    EXPECT_EQ(run.code, example.endless ? 130 : 0) << line << '\n' << run.err;
    EXPECT_EQ(run.err, "") << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, HelpOfEveryCommand, testing::ValuesIn(command_names()),
                         [](const auto& test) { return test.param; });

TEST(Help, VersionIsOneLineAndQuick) {
  const TemporaryFolder folder;
  const Finished version = burin_in(folder, {"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.substr(0, 6), "burin ");
  EXPECT_EQ(version.out.find('\n'), version.out.size() - 1);
}

TEST(Help, UnknownCommandsAreAnswered) {
  const TemporaryFolder folder;
  const Finished close = burin_in(folder, {"drwa"});
  EXPECT_EQ(close.code, 2);
  EXPECT_EQ(close.out, "");
  EXPECT_TRUE(contains(close.err, "burin: error: there is no command 'drwa'; did you mean 'draw'?")) << close.err;
  const Finished preset = burin_in(folder, {"minkowski-island"});
  EXPECT_EQ(preset.code, 2);
  EXPECT_TRUE(contains(preset.err, "burin draw minkowski-island")) << preset.err;
}

TEST(List, PresetsHaveTitlesFamiliesAndFormatsSummaries) {
  const TemporaryFolder folder;
  const Finished presets = burin_in(folder, {"list"});
  EXPECT_EQ(presets.code, 0);
  EXPECT_TRUE(contains(presets.out, "  koch ")) << presets.out;
  EXPECT_FALSE(contains(presets.out, "has problems")) << presets.out;
  EXPECT_TRUE(contains(burin_in(folder, {"list", "families"}).out, "  two-point "));
  EXPECT_TRUE(contains(burin_in(folder, {"list", "formats"}).out, "  svg "));
  EXPECT_TRUE(contains(burin_in(folder, {"list", "colors"}).out, "tomato"));
  const Finished wrong = burin_in(folder, {"list", "colours"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "did you mean 'colors'")) << wrong.err;
}

TEST(List, FoldersOfTheEnvironmentComeFirst) {
  const TemporaryFolder folder;
  const TemporaryFolder library;
  library.write("koch.toml", koch_text);
  library.write("mine.toml", koch_text);
  ToolSetup setup;
  setup.environment.emplace_back("BURIN_PATH", "/nowhere:" + library.path().string());
  const Finished list = burin_in(folder, {"list"}, setup);
  EXPECT_TRUE(contains(list.out, "mine")) << list.out;
  EXPECT_TRUE(contains(list.out, "dragon")) << list.out;
  EXPECT_TRUE(contains(burin_in(folder, {"show", "koch"}, setup).out, library.file("koch.toml")));
}

TEST(Show, PresetFamilyAndTable) {
  const TemporaryFolder folder;
  const Finished preset = burin_in(folder, {"show", "koch"});
  EXPECT_EQ(preset.code, 0);
  EXPECT_TRUE(contains(preset.out, "levels")) << preset.out;
  EXPECT_TRUE(contains(preset.out, "[0, 1000]")) << preset.out;
  EXPECT_TRUE(contains(burin_in(folder, {"show", "koch", "--text"}).out, "burin = 1"));
  EXPECT_TRUE(contains(burin_in(folder, {"show", "two-point"}).out, "motif"));
  EXPECT_TRUE(contains(burin_in(folder, {"show", "page"}).out, "margin"));
  const Finished wrong = burin_in(folder, {"show", "kohc"});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_TRUE(contains(wrong.err, "did you mean 'koch'")) << wrong.err;
}

TEST(New, CopiesAPresetAndKeepsWhatIsThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(burin_in(folder, {"new", "mine.toml", "--from", "koch"}).code, 0);
  const std::string copy = folder.read("mine.toml");
  EXPECT_EQ(copy.front(), '#');
  const std::string original = burin_in(folder, {"show", "koch", "--text"}).out;
  ASSERT_GT(copy.size(), original.size());
  EXPECT_EQ(copy.substr(copy.size() - original.size()), original);

  folder.write("mine.toml", "mine");
  const Finished again = burin_in(folder, {"new", "mine.toml", "--from", "koch"});
  EXPECT_EQ(again.code, 5);
  EXPECT_TRUE(contains(again.err, "--force")) << again.err;
  EXPECT_EQ(folder.read("mine.toml"), "mine");
  EXPECT_EQ(burin_in(folder, {"new", "mine.toml", "--from", "koch", "--force"}).code, 0);
  EXPECT_EQ(folder.read("mine.toml"), copy);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"mine.toml"});
}

TEST(New, NeedsAFileAndAPreset) {
  const TemporaryFolder folder;
  const Finished none = burin_in(folder, {"new"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "--from")) << none.err;
  EXPECT_TRUE(contains(none.err, "FILE.toml")) << none.err;
}

TEST(Check, CountsWhatIsFineAndShowsEveryProblem) {
  const TemporaryFolder folder;
  folder.write("good.toml", koch_text);
  folder.write("one.toml", std::string(koch_text) + "colour = 1\n");
  folder.write("two.toml", std::string(koch_text) + "widht = 1\n");
  const Finished fine = burin_in(folder, {"check", "good.toml", "koch"});
  EXPECT_EQ(fine.code, 0) << fine.err;
  EXPECT_EQ(fine.out, "2 presets are fine\n");
  const Finished bad = burin_in(folder, {"check", "one.toml", "good.toml", "two.toml"});
  EXPECT_EQ(bad.code, 3);
  EXPECT_TRUE(contains(bad.err, "one.toml:10:1: error:")) << bad.err;
  EXPECT_TRUE(contains(bad.err, "two.toml:10:1: error:")) << bad.err;
}

}  // namespace
}  // namespace burin::test
