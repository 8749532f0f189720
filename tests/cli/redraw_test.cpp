#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/tool.hpp"

/// `burin redraw`: the same bytes from the file itself, whatever it was drawn with, and changes on top of them.
namespace burin::test {
namespace {

std::vector<std::string> formats() {
#ifdef BURIN_HAS_CAIRO
  return {"svg", "pdf", "png"};
#else
  return {"svg"};
#endif
}

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Draws, redraws and compares: `options` are those that all formats take, `of_format` those of one.
void expect_same_bytes(const TemporaryFolder& folder, const std::string& preset, const std::string& format,
                       const std::vector<std::string>& options) {
  const std::string file = "one." + format;
  const Finished drawn = burin_in(folder, joined({"draw", preset, "-q", "-o", file}, options));
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  const Finished again = burin_in(folder, {"redraw", file, "-q", "-o", "two." + format});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_TRUE(folder.read(file) == folder.read("two." + format)) << preset << ' ' << format;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(BURIN_SOURCE_DIR) + "/presets")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class RedrawEveryPreset : public testing::TestWithParam<std::string> {};

TEST_P(RedrawEveryPreset, GivesTheSameBytes) {
  const TemporaryFolder folder;
  for (const std::string& format : formats()) {
    const std::vector<std::string> small =
        format == "png" ? std::vector<std::string>{"--size", "400px"} : std::vector<std::string>{};
    expect_same_bytes(folder, GetParam(), format, small);
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, RedrawEveryPreset, testing::ValuesIn(preset_names()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Redraw, KeepsEveryOptionThatTheFileWasDrawnWith) {
  const TemporaryFolder folder;
  std::string text(koch_text);
  text +=
      "[[layer]]\nname = \"\\\"Ö\\\" & <b>\\\\\"\ncurve = { family = \"two-point\", sign = \"random\", levels = 2 }\n";
  folder.write("ä ü.toml", text);
  const std::vector<std::vector<std::string>> all{
      {},
      {"-D", "levels=2", "--seed", "-5"},
      {"--page", "30x40cm", "--landscape", "--margin", "10mm 20mm"},
      {"--view", "90,80,12.5"},
      {"--set", "page.paper=#d9c5a0", "--set", "layer.curve.opacity=0.5", "--all-points"},
      {"--enlarge", "a5"},
      {"--only", "curve"},
      {"--skip", "\"Ö\" & <b>\\"},
  };
  for (const std::vector<std::string>& options : all) {
    for (const std::string& format : formats()) {
      const std::vector<std::string> of_format = format == "png" ? std::vector<std::string>{"--dpi", "20.5"}
                                                 : format == "svg"
                                                     ? std::vector<std::string>{"--paper", "--decimals", "1"}
                                                     : std::vector<std::string>{"--paper"};
      expect_same_bytes(folder, "./ä ü.toml", format, joined(options, of_format));
    }
  }
  if (formats().size() > 1) expect_same_bytes(folder, "koch", "svg", {"--backend", "cairo"});
}

TEST(Redraw, WhatComesFromStdinIsDrawnAgainToo) {
  const TemporaryFolder folder;
  ToolSetup setup;
  setup.input = koch_text;
  ASSERT_EQ(burin_in(folder, {"draw", "-", "-q", "-o", "one.svg"}, setup).code, 0);
  ASSERT_EQ(burin_in(folder, {"redraw", "one.svg", "-q", "-o", "-"}).out, folder.read("one.svg"));
}

TEST(Redraw, ChangesAreThoseOfDraw) {
  const TemporaryFolder folder;
  folder.write("a.toml", koch_text);
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q", "-D", "levels=2", "--decimals", "2", "--page", "a5"}).code, 0);
  const auto expect_equal = [&](const std::vector<std::string>& redrawn, const std::vector<std::string>& drawn) {
    const Finished changed = burin_in(folder, joined({"redraw", "a.svg", "-q", "-o", "-"}, redrawn));
    const Finished direct = burin_in(folder, joined({"draw", "a.toml", "-q", "-o", "-"}, drawn));
    EXPECT_EQ(changed.code, 0) << changed.err;
    EXPECT_EQ(direct.code, 0) << direct.err;
    EXPECT_TRUE(changed.out == direct.out) << redrawn.front();
  };
  expect_equal({"-D", "levels=4"}, {"-D", "levels=4", "--decimals", "2", "--page", "a5"});
  expect_equal({"--set", "page.margin=1cm", "--seed", "9"},
               {"-D", "levels=2", "--decimals", "2", "--page", "a5", "--set", "page.margin=1cm", "--seed", "9"});
  expect_equal({"--page", "a3", "--landscape"}, {"-D", "levels=2", "--decimals", "2", "--page", "a3", "--landscape"});
  expect_equal({"--decimals", "4", "--paper"}, {"-D", "levels=2", "--decimals", "4", "--page", "a5", "--paper"});
  expect_equal({"--format", "csv"}, {"-D", "levels=2", "--page", "a5", "--format", "csv"});
}

TEST(Redraw, EnlargedFilesCanBePlannedAndEnlargedAgain) {
  const TemporaryFolder folder;
  folder.write("a.toml", koch_text);
  const auto drawn = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-q", "-o", "-"});
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q", "--page", "a5", "-o", "a5.svg"}).code, 0);
  ASSERT_EQ(burin_in(folder, {"redraw", "a5.svg", "-q", "--enlarge", "a1", "-o", "a1.svg"}).code, 0);
  const std::string a1 = folder.read("a1.svg");
  EXPECT_TRUE(contains(a1, "width=\"594mm\" height=\"841mm\"")) << a1.substr(0, 500);
  EXPECT_TRUE(a1 == drawn({"draw", "a.toml", "--page", "a5", "--enlarge", "a1"}));
  EXPECT_TRUE(a1 == drawn({"redraw", "a1.svg"}));
  EXPECT_TRUE(drawn({"redraw", "a1.svg", "--enlarge", "a4"}) ==
              drawn({"draw", "a.toml", "--page", "a5", "--enlarge", "a4"}));
  EXPECT_TRUE(drawn({"redraw", "a1.svg", "--page", "a3"}) == drawn({"draw", "a.toml", "--page", "a3"}));
  const Finished wrong = burin_in(folder, {"redraw", "a1.svg", "--enlarge", "a44"});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_TRUE(contains(wrong.err, "--enlarge a44: error: 'a44' is no paper")) << wrong.err;
}

TEST(Redraw, TheFileItselfIsReplacedOnlyWhenAskedFor) {
  const TemporaryFolder folder;
  folder.write("a.toml", koch_text);
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q"}).code, 0);
  const std::string before = folder.read("a.svg");
  const Finished redrawn = burin_in(folder, {"redraw", "a.svg", "-D", "levels=1"});
  EXPECT_EQ(redrawn.code, 0) << redrawn.err;
  EXPECT_TRUE(contains(redrawn.out, "a-redrawn.svg: ")) << redrawn.out;
  EXPECT_TRUE(folder.read("a.svg") == before);
  EXPECT_FALSE(folder.read("a-redrawn.svg") == before);
  EXPECT_EQ(burin_in(folder, {"redraw", "a.svg", "-D", "levels=1", "-q", "-o", "a.svg"}).code, 0);
  EXPECT_TRUE(folder.read("a.svg") == folder.read("a-redrawn.svg"));
}

TEST(Redraw, PrintsThePresetAsItWas) {
  const TemporaryFolder folder;
  const std::string text = std::string("\xEF\xBB\xBF# é \"\"\" \\ \r\n") + koch_text;
  folder.write("a.toml", text);
  for (const std::string& format : formats()) {
    ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q", "-o", "a." + format}).code, 0);
    const Finished shown = burin_in(folder, {"redraw", "a." + format, "--text"});
    EXPECT_EQ(shown.code, 0);
    EXPECT_EQ(shown.out, text) << format;
  }
}

constexpr const char* csv_text =
    "burin = 1\n[[layer]]\nname = \"points\"\n"
    "curve = { family = \"two-point\", base = { csv = \"points.csv\" }, levels = 2 }\n";

TEST(Redraw, DataFilesAreFoundAndHeldAgainstTheRecord) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "out");
  std::filesystem::create_directories(folder.path() / "elsewhere");
  folder.write("a.toml", csv_text);
  const std::string points = "0,0\n3,1\n4,0\n";
  folder.write("points.csv", points);
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q", "-o", "out/a.svg"}).code, 0);
  const auto redraw = [&](const std::vector<std::string>& options = {}) {
    return burin_in(folder, joined({"redraw", "out/a.svg", "-o", "b.svg"}, options));
  };
  // In the current folder, as it was.
  EXPECT_EQ(redraw().err, "");
  EXPECT_TRUE(folder.read("b.svg") == folder.read("out/a.svg"));
  // Beside the file, but changed: what is as it was is taken first.
  folder.write("out/points.csv", "0,0\n1,1\n");
  EXPECT_EQ(redraw().err, "");
  EXPECT_TRUE(folder.read("b.svg") == folder.read("out/a.svg"));
  // Changed everywhere: named, and drawn.
  folder.write("points.csv", "0,0\n1,2\n");
  const Finished changed = redraw();
  EXPECT_EQ(changed.code, 0);
  EXPECT_EQ(changed.err, "out/a.svg: note: the data file 'points.csv' has changed since it was drawn\n");
  EXPECT_EQ(redraw({"-q"}).err, "");
  // A folder that is named is the only one.
  folder.write("elsewhere/points.csv", points);
  EXPECT_EQ(redraw({"--data-folder", "elsewhere"}).err, "");
  EXPECT_TRUE(folder.read("b.svg") == folder.read("out/a.svg"));
  // Missing.
  std::filesystem::remove(folder.path() / "points.csv");
  std::filesystem::remove(folder.path() / "out/points.csv");
  const Finished missing = redraw();
  EXPECT_EQ(missing.code, 3);
  EXPECT_TRUE(contains(missing.err, "points.csv")) << missing.err;
  EXPECT_TRUE(contains(missing.err, "--data-folder")) << missing.err;
}

TEST(Redraw, AnotherVersionIsTold) {
  const TemporaryFolder folder;
  folder.write("a.toml", koch_text);
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q"}).code, 0);
  std::string svg = folder.read("a.svg");
  const std::size_t version = svg.find("burin = &quot;");
  ASSERT_NE(version, std::string::npos);
  svg.replace(version, 15, "burin = &quot;9");
  folder.write("later.svg", svg);
  const Finished later = burin_in(folder, {"redraw", "later.svg", "-o", "b.svg"});
  EXPECT_EQ(later.code, 0);
  EXPECT_TRUE(contains(later.err, "later.svg: note: burin 9.1.0 drew it")) << later.err;
  svg.insert(version, "twist = &quot;3&quot;\n");
  folder.write("unknown.svg", svg);
  const Finished unknown = burin_in(folder, {"redraw", "unknown.svg"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(contains(unknown.err, "'twist'")) << unknown.err;
  EXPECT_TRUE(contains(unknown.err, "9.1.0")) << unknown.err;
}

TEST(Redraw, ProblemsTellWhatToDo) {
  const TemporaryFolder folder;
  folder.write("a.toml", koch_text);
  ASSERT_EQ(burin_in(folder, {"draw", "a.toml", "-q"}).code, 0);
  folder.write("foreign.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  const auto expect_problem = [&](const std::vector<std::string>& words, int code, const std::string& message) {
    const Finished run = burin_in(folder, joined({"redraw"}, words));
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(contains(run.err, message)) << run.err;
  };
  expect_problem({}, 2, "burin redraw: error: name one SVG, PDF or PNG file");
  expect_problem({"a.svg", "b.svg"}, 2, "name one");
  expect_problem({"missing.svg"}, 3, "missing.svg: error: cannot be read");
  expect_problem({"."}, 3, "is a folder");
  expect_problem({"/dev/null"}, 3, "no regular file");
  expect_problem({"a.toml"}, 3, "a.toml: error: is no SVG, PDF or PNG");
  expect_problem({"foreign.svg"}, 3, "was not drawn by burin");
  expect_problem({"a.svg", "-D", "level=1"}, 3, "did you mean 'levels'?");
  expect_problem({"a.svg", "--dpi", "100"}, 2, "burin redraw: error: --dpi is for png");
  expect_problem({"a.svg", "--decimals", "x"}, 2, "burin redraw: error: --decimals must be");
  expect_problem({"a.svg", "-o", "b.xyz"}, 2, "'.xyz' is no format");
  expect_problem({"a.svg", "--only", "nothing"}, 2, "burin redraw: error: --only: there is no layer 'nothing'");
}

}  // namespace
}  // namespace burin::test
