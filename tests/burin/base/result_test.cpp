#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/result.hpp>

namespace burin {
namespace {

TEST(Result, HoldsAValue) {
  Result<std::string> result = std::string("yes");
  ASSERT_TRUE(result);
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(*result, "yes");
  EXPECT_EQ(result->size(), 3U);
  *result += "!";
  EXPECT_EQ(*result, "yes!");
}

TEST(Result, HoldsProblems) {
  const Result<int> result = Problem{{"f", 1, 2}, "wrong"};
  ASSERT_FALSE(result);
  ASSERT_EQ(result.problems().size(), 1U);
  EXPECT_EQ(result.problems()[0].message, "wrong");
}

TEST(Result, MovesValuesThatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
  const std::unique_ptr<int> taken = *std::move(result);
  EXPECT_EQ(*taken, 7);
}

TEST(ResultDeathTest, BrokenContractsAbort) {
  const Result<int> good = 1;
  const Result<int> bad = Problem{{}, "wrong"};
  EXPECT_DEATH(static_cast<void>(*bad), "contract broken");
  EXPECT_DEATH(static_cast<void>(good.problems()), "contract broken");
  EXPECT_DEATH(static_cast<void>(Result<int>(Problems{})), "contract broken");
}

}  // namespace
}  // namespace burin
