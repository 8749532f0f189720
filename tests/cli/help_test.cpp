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

TEST(Show, SubdivisionSchemesSayHowSmoothTheirCurvesAre) {
  const TemporaryFolder folder;
  const auto theory = [&](const std::vector<std::string>& parameters) {
    std::vector<std::string> words{"show", "four-parameter"};
    for (const std::string& parameter : parameters) words.insert(words.end(), {"-D", parameter});
    return burin_in(folder, words);
  };
  // Fig. 2 b of the paper as it is printed, and corrected.
  const Finished printed = theory({"lambda=1/80", "mu=1/16", "omega=1/32"});
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_TRUE(contains(printed.out, "Theorem 2 (C1): does not apply, its side condition is 0.05")) << printed.out;
  EXPECT_TRUE(contains(printed.out, "by the theorems: C0")) << printed.out;
  EXPECT_TRUE(contains(printed.out, "exponent: 0.9087 to 0.9341")) << printed.out;
  const Finished corrected = theory({"lambda=1/16", "mu=1/16", "omega=1/32"});
  EXPECT_TRUE(contains(corrected.out, "by the theorems: C2")) << corrected.out;
  EXPECT_TRUE(contains(corrected.out, "proven: C2")) << corrected.out;
  EXPECT_TRUE(contains(corrected.out, "excluded: C3")) << corrected.out;
  // Its Fig. 4: no theorem holds, and yet the limit is continuous.
  const Finished rough = theory({"lambda=1/30", "mu=1/30", "omega=1/3"});
  EXPECT_TRUE(contains(rough.out, "by the theorems: nothing")) << rough.out;
  EXPECT_TRUE(contains(rough.out, "proven: C0 by the norm of power 3")) << rough.out;
  EXPECT_TRUE(contains(burin_in(folder, {"show", "de-rham", "-D", "t=1.2"}).out, "does not converge"));
  EXPECT_TRUE(
      contains(burin_in(folder, {"show", "four-point", "-D", "w=0.55"}).out, "excluded: C0; the scheme diverges"));
  // Without -D the parameters come first.
  const Finished family = burin_in(folder, {"show", "four-point"});
  EXPECT_TRUE(contains(family.out, "levels")) << family.out;
  EXPECT_TRUE(contains(family.out, "proven: C1")) << family.out;
}

TEST(Show, FamiliesThatNeedDataTellTheirParametersWithoutIt) {
  const TemporaryFolder folder;
  for (const char* family : {"fractal-interpolation", "svg"}) {
    const Finished alone = burin_in(folder, {"show", family});
    EXPECT_EQ(alone.code, 0) << alone.err;
    EXPECT_FALSE(contains(alone.out, "with these defaults")) << alone.out;
  }
  const Finished fractal = burin_in(folder, {"show", "fractal-interpolation", "-D", "scaling=0.5", "-D",
                                             "points=[[0, 0], [0.25, 0.8], [0.5, 0.2], [0.75, 1], [1, 0.3]]"});
  EXPECT_TRUE(contains(fractal.out, "4 intervals, the scaling at most 0.5 in size")) << fractal.out;
  EXPECT_TRUE(contains(fractal.out, "proven: C0\nexcluded: C1, by the dimension")) << fractal.out;
  EXPECT_TRUE(contains(fractal.out, "exponent: at least 0.5, at most 0.5")) << fractal.out;
  EXPECT_TRUE(contains(fractal.out, "box dimension: 1.5 to 1.5, the lower bound by the growth")) << fractal.out;
  EXPECT_EQ(burin_in(folder, {"show", "fractal-interpolation", "-D", "scaling=0.5"}).code, 3);
}

TEST(Show, ParametersThatCannotBeAreRefused) {
  const TemporaryFolder folder;
  const Finished unknown = burin_in(folder, {"show", "four-parameter", "-D", "omga=1"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(contains(unknown.err, "did you mean 'omega'")) << unknown.err;
  EXPECT_EQ(burin_in(folder, {"show", "four-parameter", "-D", "omega=big"}).code, 3);
  EXPECT_EQ(burin_in(folder, {"show", "four-parameter", "-D", "omega"}).code, 2);
  EXPECT_EQ(burin_in(folder, {"show", "koch", "-D", "levels=3"}).code, 2);
  EXPECT_EQ(burin_in(folder, {"show", "two-point", "-D", "levels=3"}).code, 2);
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
