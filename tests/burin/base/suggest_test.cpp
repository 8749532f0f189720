#include <array>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/suggest.hpp>

namespace burin {
namespace {

constexpr std::array<std::string_view, 4> keys{"amplitude", "levels", "turn", "r"};

TEST(Suggest, FindsOneSlip) {
  EXPECT_EQ(closest_word("amplitud", keys), "amplitude");    // deleted
  EXPECT_EQ(closest_word("ampllitude", keys), "amplitude");  // inserted
  EXPECT_EQ(closest_word("levals", keys), "levels");         // replaced
  EXPECT_EQ(closest_word("levles", keys), "levels");         // swapped
  EXPECT_EQ(closest_word("turn", keys), "turn");
}

TEST(Suggest, DistanceTwoIsTheLimit) {
  EXPECT_EQ(closest_word("amplitdue", keys), "amplitude");
  EXPECT_EQ(closest_word("amplexxde", keys), "");
  EXPECT_EQ(closest_word("", keys), "");
  EXPECT_EQ(closest_word("x", keys), "");
}

TEST(Suggest, TiesGoToTheFirst) {
  constexpr std::array<std::string_view, 2> twins{"cold", "bold"};
  EXPECT_EQ(closest_word("gold", twins), "cold");
}

TEST(Suggest, HostileWordsAreNotCompared) {
  EXPECT_EQ(closest_word(std::string(1000000, 'a'), keys), "");
}

TEST(Suggest, WordsTheSentence) {
  EXPECT_EQ(suggestion("levls", keys), "; did you mean 'levels'?");
  EXPECT_EQ(suggestion("zebra", keys), "; known: amplitude, levels, turn, r");
  EXPECT_EQ(suggestion("zebra", {}), "");
}

}  // namespace
}  // namespace burin
