#include <gtest/gtest.h>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

constexpr const char* preset_text =
    "burin = 1\npens = { ink = { color = \"black\" }, red = { color = \"red\", width = \"1mm\" } }\n"
    "[[layer]]\ncurve = { family = \"two-point\", levels = 2 }\n"
    "[[layer]]\npen = \"red\"\ncurve = { family = \"two-point\", levels = 1 }\n";

constexpr const char* sets_text =
    "[desk]\nink = { color = \"navy\", width = \"0.7mm\" }\nred = { width = 0.4, cmyk = [0, 100, 80, 5.5] }\n"
    "\"blue.1\" = { color = \"blue\" }\n[odd]\nink = 3\n";

class Pens : public testing::Test {
 protected:
  Pens() {
    folder.write("p.toml", preset_text);
    std::filesystem::create_directories(folder.path() / "home/burin");
    folder.write("home/burin/pens.toml", sets_text);
  }

  Finished draw(std::vector<std::string> words, bool at_home = true) const {
    words.insert(words.begin(), {"draw", "p.toml", "-q"});
    ToolSetup setup;
    if (at_home) setup.environment.emplace_back("XDG_CONFIG_HOME", folder.file("home"));
    return burin_in(folder, words, setup);
  }

  TemporaryFolder folder;
};

TEST_F(Pens, ASetReplacesPensOfItsNames) {
  const Finished drawn = draw({"--pens", "desk", "-o", "-"});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.out, "1 ink 0.7")) << drawn.out;
  EXPECT_TRUE(contains(drawn.out, "#000080"));
  EXPECT_TRUE(contains(drawn.out, "2 red 0.4"));
  EXPECT_TRUE(contains(drawn.out, "#ff0000"));   // its colour is the preset's
  EXPECT_FALSE(contains(drawn.out, "#0000ff"));  // the preset has no such pen
}

TEST_F(Pens, SingleKeysAndWhatIsSetByHandComeLater) {
  const Finished drawn = draw({"--pens", "desk", "--pens", "red.color=teal", "--set", "pens.ink.width=2mm", "-o", "-"});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.out, "1 ink 2"));
  EXPECT_TRUE(contains(drawn.out, "#008080"));
}

TEST_F(Pens, ADrawingIsDrawnAgainWithoutTheFile) {
  ASSERT_EQ(draw({"--pens", "desk", "-o", "a.svg"}).code, 0);
  const Finished again = burin_in(folder, {"redraw", "a.svg", "-q", "-o", "b.svg"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(folder.read("b.svg"), folder.read("a.svg"));
}

TEST_F(Pens, SaysWhatIsWrong) {
  const auto error = [&](const std::string& word, bool at_home = true) {
    const Finished drawn = draw({"--pens", word, "-o", "-"}, at_home);
    EXPECT_EQ(drawn.code, 2);
    return drawn.err;
  };
  EXPECT_TRUE(contains(error("dusk"), "no pens 'dusk' in ")) << error("dusk");
  EXPECT_TRUE(contains(error("dusk"), "did you mean 'desk'?"));
  EXPECT_TRUE(contains(error("odd"), "pen 'ink' in "));
  EXPECT_TRUE(contains(error("desk", false), "pens.toml"));
  folder.write("home/burin/pens.toml", "[desk\n");
  EXPECT_TRUE(contains(error("desk"), "pens.toml:1"));
}

}  // namespace
}  // namespace burin::test
