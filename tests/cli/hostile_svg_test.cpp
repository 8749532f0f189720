#include <string>

#include <gtest/gtest.h>

#include "cli/tool.hpp"

/// SVG files made to harm: the tool refuses them soon and in little memory, and says why.
namespace burin::test {
namespace {

constexpr double most_cpu_s = 2.0;
constexpr double most_mib = 512.0;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\">" + content + "</svg>";
}

void expect_refused(const std::string& svg_text, const std::string& complaint) {
  const TemporaryFolder folder;
  folder.write("a.svg", svg_text);
  folder.write("p.toml", "burin = 1\n[[layer]]\nsvg = \"a.svg\"\n");
  const Finished run = burin_in(folder, {"draw", "p.toml", "-o", "p.svg"});
  EXPECT_TRUE(run.code == 3 || run.code == 4) << run.code;
  EXPECT_TRUE(contains(run.err, complaint)) << run.err.substr(0, 1000);
  EXPECT_TRUE(contains(run.err, "a.svg:")) << run.err.substr(0, 1000);
  EXPECT_LT(run.err.size(), 20'000U);
  EXPECT_LT(run.cpu_s, most_cpu_s);
  EXPECT_LT(run.peak_mib, most_mib);
  EXPECT_FALSE(folder.has("p.svg"));
}

const std::string line = "<path d=\"M0 0L9 9\" stroke=\"red\"/>";

TEST(HostileSvg, Circles) {
  expect_refused(svg("<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g>"), "break the circle");
}

TEST(HostileSvg, AMillionGroupsOneInAnother) {
  const std::string groups = repeated("<g>", 1'000'000);
  expect_refused(svg(groups + line + repeated("</g>", 1'000'000)), "more than 200 groups");
  expect_refused(groups, "no well-formed XML");
}

TEST(HostileSvg, Entities) {
  std::string entities = "<!ENTITY a0 \"M0 0L1 1\">";
  for (int i = 1; i < 30; ++i) {
    entities += "<!ENTITY a" + std::to_string(i) + " \"" + repeated("&a" + std::to_string(i - 1) + ";", 10) + "\">";
  }
  expect_refused("<!DOCTYPE svg [" + entities + "]>" + svg("<path d=\"&a29;\" stroke=\"red\"/>"), "entity");
  expect_refused("<!DOCTYPE svg [<!ENTITY x SYSTEM \"/etc/passwd\">]>" + svg("<path d=\"&x;\" stroke=\"red\"/>"),
                 "entity");
}

TEST(HostileSvg, UsesOfUses) {
  std::string defs = "<g id=\"a0\">" + line + "</g>";
  for (int i = 1; i < 30; ++i) {
    const std::string use = "<use href=\"#a" + std::to_string(i - 1) + "\"/>";
    defs += "<g id=\"a" + std::to_string(i) + "\">" + repeated(use, 10) + "</g>";
  }
  expect_refused(svg("<defs>" + defs + "</defs><use href=\"#a29\"/>"), "more than 100000 elements");
}

TEST(HostileSvg, AnElementOfALongTextUsedAgainAndAgain) {
  const std::string blanks = repeated("<use href=\"#a\"/>", 90'000);
  expect_refused(svg("<path id=\"a\" stroke=\"red\" d=\"M0 0" + std::string(4'000'000, ' ') + "L9 9\"/>" + blanks),
                 "more than 100000 elements");
}

TEST(HostileSvg, HugeNumbers) {
  expect_refused(svg("<path d=\"M1e308 1e308C9e999 0 -1e300 0 0 0\" stroke=\"red\"/>"), "no number between");
  expect_refused(svg("<path d=\"M0 0A1e12 1e12 0 1 1 5 5\" stroke=\"red\"/>"), "outside [-1e12, 1e12]");
  expect_refused(svg(repeated("<g transform=\"scale(1e9)\">", 60) + line + repeated("</g>", 60)), "outside");
}

TEST(HostileSvg, Truncated) {
  expect_refused("<svg xmlns=\"http://www.w3.org/2000/svg\"><g><path d=\"M0 0L9 9", "no well-formed XML");
  expect_refused("<svg><!--" + std::string(5'000'000, '-'), "no well-formed XML");
}

TEST(HostileSvg, ManyRulesForManyElements) {
  std::string rules;
  for (int i = 0; i < 490; ++i) rules += "." + repeated("x", i % 9 + 1) + "{fill:red;stroke:blue;opacity:0.5}";
  expect_refused(svg("<style>" + rules + "</style>" + repeated("<text class=\"x xx xxx xxxx\"/>", 90'000)),
                 "text is not drawn");
}

TEST(HostileSvg, LargeFiles) {
  expect_refused(svg(repeated(line, 1'000'000)), "larger than the 8 MiB");
}

}  // namespace
}  // namespace burin::test
