#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include <burin/data/image.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

std::string koch_with(const std::string& levels) {
  std::string text = koch_text;
  text.replace(text.find("default = 3"), 11, "default = " + levels);
  return text;
}

/// Two cases, blessed.
class GoldenFolder : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "cases" / "sub");
    folder_.write("cases/koch.toml", koch_text);
    folder_.write("cases/sub/two.toml", koch_with("2"));
    const Finished blessed = golden({"--bless", "--size", "90px"});
    ASSERT_EQ(blessed.code, 0) << blessed.err;
    EXPECT_EQ(blessed.err, "");
    EXPECT_TRUE(contains(blessed.out, "cases/koch.dump: written, it is new\ncases/koch.png: written, it is new\n"));
    EXPECT_TRUE(contains(blessed.out, "cases: 2 cases; 4 files written\n")) << blessed.out;
  }

  Finished golden(std::vector<std::string> words) const {
    words.insert(words.begin(), {"golden", "cases"});
    return burin_in(folder_, std::move(words));
  }

  TemporaryFolder folder_;
};

TEST_F(GoldenFolder, HoldsWhatDrawWrites) {
  const Finished check = golden({});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_EQ(check.out, "cases: 2 cases; all as they should be\n");
  EXPECT_EQ(golden({"-q"}).out, "");
  ASSERT_EQ(burin_in(folder_, {"draw", "cases/koch.toml", "-q", "-o", "k.dump"}).code, 0);
  EXPECT_EQ(folder_.read("k.dump"), folder_.read("cases/koch.dump"));
  ASSERT_EQ(
      burin_in(folder_, {"draw", "cases/koch.toml", "-q", "-o", "k.png", "--size", "90px", "--backend", "native"}).code,
      0);
  EXPECT_EQ(burin_in(folder_, {"diff", "k.png", "cases/koch.png"}).code, 0);
}

TEST_F(GoldenFolder, BlessingAgainWritesNothing) {
  const auto date = fs::last_write_time(folder_.file("cases/koch.png"));
  EXPECT_EQ(golden({"--bless"}).out, "cases: 2 cases; 0 files written\n");
  EXPECT_EQ(fs::last_write_time(folder_.file("cases/koch.png")), date);
}

TEST_F(GoldenFolder, AChangedPresetFailsUntilItIsBlessed) {
  folder_.write("cases/koch.toml", koch_with("2"));
  const Finished check = golden({});
  EXPECT_EQ(check.code, 1);
  EXPECT_EQ(check.out, "");
  EXPECT_TRUE(contains(check.err, "cases/koch.dump: line ")) << check.err;
  EXPECT_TRUE(contains(check.err, "  golden: ")) << check.err;
  EXPECT_TRUE(contains(check.err, "cases/koch.png: ")) << check.err;
  EXPECT_TRUE(contains(check.err, " of 5760 pixels are not the same: max ")) << check.err;
  EXPECT_FALSE(contains(check.err, "two")) << check.err;
  EXPECT_TRUE(contains(check.err, "cases: 2 cases, 1 not as they should be\n")) << check.err;
  EXPECT_TRUE(contains(check.err, "'burin golden cases --bless' keeps them")) << check.err;

  const Finished blessed = golden({"--bless"});
  EXPECT_EQ(blessed.code, 0) << blessed.err;
  EXPECT_TRUE(contains(blessed.out, "cases/koch.png: written, before: ")) << blessed.out;
  EXPECT_TRUE(contains(blessed.out, "2 files written\n")) << blessed.out;
  EXPECT_EQ(golden({}).code, 0);
  EXPECT_EQ(folder_.read("cases/koch.dump"), folder_.read("cases/sub/two.dump"));
}

TEST_F(GoldenFolder, ACommentInAPresetChangesNothing) {
  folder_.write("cases/koch.toml", "# More words.\n" + std::string(koch_text));
  EXPECT_EQ(golden({}).code, 0);
}

TEST_F(GoldenFolder, AMissingGoldenFails) {
  fs::remove(folder_.path() / "cases/sub/two.png");
  const Finished check = golden({});
  EXPECT_EQ(check.code, 1);
  EXPECT_TRUE(contains(check.err, "cases/sub/two.png: is missing\n")) << check.err;
}

TEST_F(GoldenFolder, AnOrphanFailsAndIsNotBlessedAway) {
  fs::remove(folder_.path() / "cases/sub/two.toml");
  for (const Finished& run : {golden({}), golden({"--bless"})}) {
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(contains(run.err, "cases/sub/two.dump: has no preset beside it")) << run.err;
    EXPECT_TRUE(contains(run.err, "cases/sub/two.png: has no preset beside it")) << run.err;
  }
  EXPECT_TRUE(folder_.has("cases/sub/two.png"));
}

TEST_F(GoldenFolder, ADamagedPictureFailsAndIsBlessed) {
  folder_.write("cases/koch.png", "version https://git-lfs.github.com/spec/v1\n");
  const Finished check = golden({});
  EXPECT_EQ(check.code, 1);
  EXPECT_TRUE(contains(check.err, "cases/koch.png: is no PNG: it does not begin as one\n")) << check.err;
  EXPECT_EQ(golden({"--bless", "--size", "90px"}).code, 0);
  EXPECT_EQ(golden({}).code, 0);
}

TEST_F(GoldenFolder, PicturesKeepTheirSizeAndNewOnesHaveTheOneAskedFor) {
  const auto height = [&] { return data::read_png(folder_.read("cases/koch.png"), "koch.png")->height; };
  EXPECT_EQ(height(), 90);
  ASSERT_EQ(golden({"--bless"}).code, 0);
  EXPECT_EQ(height(), 90);
  ASSERT_EQ(golden({"--bless", "--size", "120"}).code, 0);
  EXPECT_EQ(height(), 90);
  fs::remove(folder_.path() / "cases/koch.png");
  ASSERT_EQ(golden({"--bless", "--size", "120"}).code, 0);
  EXPECT_EQ(height(), 120);
  EXPECT_EQ(golden({}).code, 0);
  const Finished alone = golden({"--size", "120px"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_TRUE(contains(alone.err, "--size goes with --bless")) << alone.err;
}

TEST_F(GoldenFolder, APresetThatCannotBeDrawnIsToldAndTheOthersAreChecked) {
  folder_.write("cases/koch.toml", std::string(koch_text) + "colour = 1\n");
  folder_.write("cases/sub/two.toml", koch_with("1"));
  const Finished check = golden({});
  EXPECT_EQ(check.code, 3);
  EXPECT_TRUE(contains(check.err, "cases/koch.toml:10:1: error: ")) << check.err;
  EXPECT_TRUE(contains(check.err, "cases/sub/two.dump: line ")) << check.err;
  EXPECT_TRUE(contains(check.err, "2 cases, 1 cannot be drawn, 1 not as they should be")) << check.err;
  const std::string before = folder_.read("cases/koch.dump");
  EXPECT_EQ(golden({"--bless"}).code, 3);
  EXPECT_EQ(folder_.read("cases/koch.dump"), before);
}

TEST_F(GoldenFolder, DataOfAPresetIsRead) {
  folder_.write("cases/sub/coast.csv", "x,y\n0,0\n1,1\n");
  folder_.write("cases/sub/coast.toml",
                "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", base = { csv = \"coast.csv\" } }\n");
  EXPECT_EQ(golden({"--bless", "--size", "50px"}).code, 0);
  folder_.write("cases/sub/coast.csv", "x,y\n0,0\n1,2\n");
  const Finished check = golden({});
  EXPECT_EQ(check.code, 1);
  EXPECT_TRUE(contains(check.err, "cases/sub/coast.dump")) << check.err;
}

TEST_F(GoldenFolder, TheReportShowsWhatFailedAndCountsForCi) {
  folder_.write("cases/koch.toml", koch_with("1"));
  folder_.write("cases/lost.png", "x");
  folder_.write("cases/bad.toml", "burin = <1>\n");
  ASSERT_EQ(golden({"--report", "out"}).code, 3);
  const std::string page = folder_.read("out/index.html");
  EXPECT_TRUE(contains(page, "<img src=\"koch.png\"")) << page;
  EXPECT_TRUE(contains(page, "1 of 3 cases are as they should be; 1 files have no preset")) << page;
  EXPECT_TRUE(contains(page, "<li>lost.png</li>")) << page;
  EXPECT_TRUE(contains(page, "<li>sub/two</li>")) << page;
  EXPECT_TRUE(contains(page, "burin = &lt;1&gt;")) << page;
  const Result<data::Image> panels = data::read_png(folder_.read("out/koch.png"), "koch.png");
  ASSERT_TRUE(panels.ok());
  EXPECT_EQ(panels->width, 3 * 64 + 2 * 8);
  EXPECT_EQ(panels->height, 90);
  EXPECT_FALSE(folder_.has("out/sub/two.png"));

  const std::string junit = folder_.read("out/junit.xml");
  EXPECT_TRUE(contains(junit, "<testsuite name=\"burin golden cases\" tests=\"4\" failures=\"2\" errors=\"1\">"))
      << junit;
  EXPECT_TRUE(contains(junit, "<testcase classname=\"sub\" name=\"two\"/>")) << junit;
  EXPECT_TRUE(contains(junit, "<testcase classname=\"golden\" name=\"koch\">\n      <failure message=\"line "))
      << junit;
  EXPECT_TRUE(contains(junit, "<testcase classname=\"golden\" name=\"bad\">\n      <error message=\"")) << junit;
}

TEST_F(GoldenFolder, AReportOfAMissingPictureShowsWhatIsDrawn) {
  fs::remove(folder_.path() / "cases/koch.png");
  ASSERT_EQ(golden({"--report", "out"}).code, 1);
  EXPECT_TRUE(folder_.has("out/koch.png"));
}

TEST_F(GoldenFolder, NothingDependsOnThreads) {
  folder_.write("cases/koch.toml", koch_with("1"));
  folder_.write("cases/sub/two.toml", koch_with("4"));
  for (int i = 0; i < 6; ++i) folder_.write("cases/sub/n" + std::to_string(i) + ".toml", koch_with(std::to_string(i)));
  const Finished one = golden({"--threads", "1", "--report", "one"});
  const Finished four = golden({"--threads", "4", "--report", "four"});
  EXPECT_EQ(one.err, four.err);
  for (const char* const file : {"index.html", "junit.xml", "koch.png", "sub/two.png", "sub/n5.png"}) {
    EXPECT_FALSE(folder_.read("one/" + std::string(file)).empty()) << file;
    EXPECT_EQ(folder_.read("one/" + std::string(file)), folder_.read("four/" + std::string(file))) << file;
  }
}

TEST_F(GoldenFolder, WrongCommandLinesTeach) {
  EXPECT_EQ(burin_in(folder_, {"golden"}).code, 2);
  EXPECT_EQ(burin_in(folder_, {"golden", "cases", "more"}).code, 2);
  EXPECT_EQ(golden({"--threads", "0"}).code, 2);
  EXPECT_EQ(golden({"--bless", "--size", "tiny"}).code, 2);
  const Finished inside = golden({"--report", "cases/report"});
  EXPECT_EQ(inside.code, 2);
  EXPECT_TRUE(contains(inside.err, "would be taken for goldens")) << inside.err;
  const Finished missing = burin_in(folder_, {"golden", "nowhere"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_TRUE(contains(missing.err, "nowhere: error: cannot be looked through")) << missing.err;
  fs::create_directory(folder_.path() / "empty");
  const Finished empty = burin_in(folder_, {"golden", "empty"});
  EXPECT_EQ(empty.code, 3);
  EXPECT_TRUE(contains(empty.err, "empty: error: has no presets")) << empty.err;
}

TEST_F(GoldenFolder, WhatCannotBeWrittenIsToldAndLeavesNothingBehind) {
  fs::remove(folder_.path() / "cases/koch.png");
  fs::create_directory(folder_.path() / "cases/koch.png");
  EXPECT_NE(golden({"--bless"}).code, 0);
  folder_.write("file", "");
  const Finished report = burin_in(folder_, {"golden", "cases/sub", "--report", "file"});
  EXPECT_EQ(report.code, 5);
  EXPECT_EQ(folder_.read("file"), "");
}

}  // namespace
}  // namespace burin::test
