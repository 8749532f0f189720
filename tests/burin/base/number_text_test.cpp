#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>

namespace burin {
namespace {

TEST(NumberText, ShortestReadsBackExactly) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(-0.0), "0");
  EXPECT_EQ(shortest_text(1e21), "1e+21");
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random_bits(3, i));
    if (!std::isfinite(value)) continue;
    const auto read = parse_number(shortest_text(value));
    ASSERT_TRUE(read) << shortest_text(value);
    EXPECT_EQ(*read, value);
  }
}

TEST(NumberText, FixedHasNoExponentAndNoTrailingZeros) {
  EXPECT_EQ(fixed_text(1.25, 3), "1.25");
  EXPECT_EQ(fixed_text(1e-9, 3), "0");
  EXPECT_EQ(fixed_text(-0.0004, 3), "0");
  EXPECT_EQ(fixed_text(100.0, 0), "100");
  EXPECT_EQ(fixed_text(100.0, 2), "100");
  EXPECT_EQ(fixed_text(2.0 / 3.0, 4), "0.6667");
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::max(), 2).size(), 309U);
}

TEST(NumberText, CountsAreForPeople) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1025), "1,025");
  EXPECT_EQ(count_text(50'000'000), "50,000,000");
  EXPECT_EQ(count_text(2.58e120), "2.6e+120");
  EXPECT_EQ(count_text(std::numeric_limits<double>::infinity()), "more than 1e308");
}

TEST(NumberText, ParsesWholeNumbersOnly) {
  EXPECT_EQ(parse_number("1"), 1.0);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("+2e-3"), 0.002);
  for (const char* wrong : {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "--1", "+-1", "1e", "one"}) {
    EXPECT_FALSE(parse_number(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace burin
