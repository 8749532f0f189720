#include <array>

#include <gtest/gtest.h>

#include <cli/options.hpp>

namespace burin::cli {
namespace {

constexpr std::array rows{OptionRow{"output", 'o', "FILE", "", true}, OptionRow{"knob", 'D', "NAME=VALUE", "", true},
                          OptionRow{"seed", 0, "N", ""}, OptionRow{"quiet", 'q', "", ""}};

Arguments parsed(const std::vector<std::string>& words) {
  Result<Arguments> arguments = parse_arguments("burin test", rows, words);
  if (!arguments) ADD_FAILURE() << problems_text(arguments.problems());
  return arguments ? *std::move(arguments) : Arguments({}, {});
}

std::string refused(const std::vector<std::string>& words) {
  const Result<Arguments> arguments = parse_arguments("burin test", rows, words);
  return arguments ? std::string() : problems_text(arguments.problems());
}

using Words = std::vector<std::string>;

TEST(Options, StandAnywhere) {
  const Arguments arguments = parsed({"-o", "a.svg", "koch", "--seed", "7", "-q"});
  EXPECT_EQ(arguments.words(), Words{"koch"});
  EXPECT_EQ(arguments.values("output"), Words{"a.svg"});
  EXPECT_EQ(arguments.value("seed"), "7");
  EXPECT_TRUE(arguments.has("quiet"));
}

TEST(Options, EveryWayToGiveAValue) {
  EXPECT_EQ(parsed({"-oa", "-o", "b", "--output", "c", "--output=d"}).values("output"), (Words{"a", "b", "c", "d"}));
}

TEST(Options, ValuesMayBeginWithADash) {
  EXPECT_EQ(parsed({"--seed", "-3"}).value("seed"), "-3");
  EXPECT_EQ(parsed({"--seed=-3"}).value("seed"), "-3");
  EXPECT_EQ(parsed({"-D", "turn=-1.5"}).values("knob"), Words{"turn=-1.5"});
  EXPECT_EQ(parsed({"-D", "-1"}).values("knob"), Words{"-1"});
  EXPECT_EQ(parsed({"-o", "-", "-"}).values("output"), Words{"-"});
  EXPECT_EQ(parsed({"-o", "-", "-"}).words(), Words{"-"});
}

TEST(Options, TwoDashesEndThem) {
  EXPECT_EQ(parsed({"-q", "--", "-o", "--seed"}).words(), (Words{"-o", "--seed"}));
}

TEST(Options, AreNeverGuessed) {
  EXPECT_EQ(refused({"--outpu", "x"}), "burin test: error: unknown option '--outpu'; did you mean '--output'?\n");
  EXPECT_EQ(refused({"--out=x"}), "burin test: error: unknown option '--out'; 'burin test --help' lists the options\n");
}

TEST(Options, EveryUnknownOneIsReported) {
  const std::string text = refused({"--sead", "1", "--quite"});
  EXPECT_NE(text.find("'--sead'; did you mean '--seed'?"), std::string::npos) << text;
  EXPECT_NE(text.find("'--quite'; did you mean '--quiet'?"), std::string::npos) << text;
}

TEST(Options, MissingAndSuperfluousValues) {
  EXPECT_EQ(refused({"--seed"}), "burin test: error: option '--seed' needs a value: --seed N\n");
  EXPECT_EQ(refused({"--seed="}), "burin test: error: option '--seed' needs a value: --seed N\n");
  EXPECT_EQ(refused({"-o"}), "burin test: error: option '-o' needs a value: -o FILE\n");
  EXPECT_EQ(refused({"-o", "-q"}), "burin test: error: option '-o' needs a value: -o FILE\n");
  EXPECT_EQ(refused({"--quiet=yes"}), "burin test: error: option '-q' takes no value\n");
}

TEST(Options, OnlyLettersAndListsMayBeRepeated) {
  EXPECT_EQ(refused({"--seed", "1", "--seed", "2"}), "burin test: error: option '--seed' is given 2 times\n");
  EXPECT_EQ(refused({"-q", "-q", "-o", "a", "-o", "b"}), "");
}

TEST(Options, AnyWordsAtAllAreSurvived) {
  for (const std::string word :
       {"", "-", "--", "---", "--=", "-=", "=", "-\n", "--seed=\xff", "-o=", "--\t", "-qo", "-qq"}) {
    for (const std::string next : {"", "-", "--", "x"}) {
      const Result<Arguments> arguments = parse_arguments("burin test", rows, {word, next});
      if (!arguments) {
        EXPECT_FALSE(arguments.problems().front().message.empty()) << word;
      }
    }
  }
}

}  // namespace
}  // namespace burin::cli
