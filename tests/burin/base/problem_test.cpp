#include <string>

#include <gtest/gtest.h>

#include <burin/base/problem.hpp>

namespace burin {
namespace {

TEST(Problem, PlaceComesFirst) {
  EXPECT_EQ(problem_text({{"a.toml", 12, 9}, "'levels' = 4000 is outside [0, 1000]"}),
            "a.toml:12:9: error: 'levels' = 4000 is outside [0, 1000]");
  EXPECT_EQ(problem_text({{"-D levels=x", 0, 0}, "no number"}), "-D levels=x: error: no number");
  EXPECT_EQ(problem_text({{}, "no place"}), "error: no place");
}

TEST(Problem, CaretStandsUnderTheCharacter) {
  const Problem plain{{"f", 1, 5}, "m", Trouble::input, "key = 1"};
  EXPECT_EQ(problem_text(plain), "f:1:5: error: m\n  key = 1\n      ^");
  const Problem tabs{{"f", 1, 4}, "m", Trouble::input, "\t\tab"};
  EXPECT_EQ(problem_text(tabs), "f:1:4: error: m\n  \t\tab\n  \t\t ^");
  // "é" has two bytes, "雪" three: the column counts bytes, the caret characters.
  const Problem utf8{{"f", 1, 6}, "m", Trouble::input, "\xC3\xA9\xE9\x9B\xAAz"};
  EXPECT_EQ(problem_text(utf8), "f:1:6: error: m\n  \xC3\xA9\xE9\x9B\xAAz\n    ^");
}

TEST(Problem, LongLinesAndColumnsBehindTheLineAreHarmless) {
  EXPECT_EQ(problem_text({{"f", 1, 5}, "m", Trouble::input, std::string(10000, 'x')}), "f:1:5: error: m");
  EXPECT_EQ(problem_text({{"f", 1, 50}, "m", Trouble::input, "ab"}), "f:1:50: error: m\n  ab\n    ^");
}

TEST(Problem, AttachSourceTakesTheLineOfItsFile) {
  Problems problems{{{"a", 2, 1}, "second"},
                    {{"b", 2, 1}, "other file"},
                    {{"a", 9, 1}, "behind the end"},
                    {{"a", 0, 0}, "whole file"},
                    {{"a", 3, 1}, "last, without newline"}};
  attach_source(problems, "a", "one\ntwo\r\nthree");
  EXPECT_EQ(problems[0].source_line, "two");
  EXPECT_EQ(problems[1].source_line, "");
  EXPECT_EQ(problems[2].source_line, "");
  EXPECT_EQ(problems[3].source_line, "");
  EXPECT_EQ(problems[4].source_line, "three");
  EXPECT_EQ(problems_text({problems[0], problems[1]}), "a:2:1: error: second\n  two\n  ^\nb:2:1: error: other file\n");
}

}  // namespace
}  // namespace burin
