#include <array>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/expr/expression.hpp>

#include "support.hpp"

namespace burin::expr {
namespace {

TEST(Expression, Numbers) {
  EXPECT_EQ(value_of("1"), 1.0);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("5."), 5.0);
  EXPECT_EQ(value_of("2.5e-3"), 0.0025);
  EXPECT_EQ(value_of("1E2"), 100.0);
  EXPECT_EQ(value_of("0.1"), 0.1);
  EXPECT_EQ(value_of("123456789012345678"), 123456789012345678.0);
  EXPECT_EQ(value_of("\t 7 \n"), 7.0);
}

TEST(Expression, Precedence) {
  EXPECT_EQ(value_of("1+2*3"), 7.0);
  EXPECT_EQ(value_of("(1+2)*3"), 9.0);
  EXPECT_EQ(value_of("8/4/2"), 1.0);
  EXPECT_EQ(value_of("8-4-2"), 2.0);
  EXPECT_EQ(value_of("8/4*2"), 4.0);
  EXPECT_EQ(value_of("2*3^2"), 18.0);
  EXPECT_EQ(value_of("2^3^2"), 512.0);
  EXPECT_EQ(value_of("(2^3)^2"), 64.0);
  EXPECT_EQ(value_of("-2^2"), -4.0);
  EXPECT_EQ(value_of("(-2)^2"), 4.0);
  EXPECT_EQ(value_of("2^-1"), 0.5);
  EXPECT_EQ(value_of("2^-1*4"), 2.0);
  EXPECT_EQ(value_of("2^-2^2"), 1.0 / 16.0);
  EXPECT_EQ(value_of("-2*-3"), 6.0);
  EXPECT_EQ(value_of("1 - -1"), 2.0);
  EXPECT_EQ(value_of("1--1"), 2.0);
  EXPECT_EQ(value_of("--2"), 2.0);
  EXPECT_EQ(value_of("-+-+-2^2"), -4.0);
  EXPECT_EQ(value_of("+3"), 3.0);
}

TEST(Expression, LogicAndChoice) {
  EXPECT_EQ(value_of("1<2"), 1.0);
  EXPECT_EQ(value_of("2<=1"), 0.0);
  EXPECT_EQ(value_of("1+1==2"), 1.0);
  EXPECT_EQ(value_of("1!=1"), 0.0);
  EXPECT_EQ(value_of("2>=2 && 3>2"), 1.0);
  EXPECT_EQ(value_of("1 || 0 && 0"), 1.0);
  EXPECT_EQ(value_of("(1 || 0) && 0"), 0.0);
  EXPECT_EQ(value_of("0.5 && 0.25"), 1.0);
  EXPECT_EQ(value_of("!0"), 1.0);
  EXPECT_EQ(value_of("!3 + 5"), 5.0);
  EXPECT_EQ(value_of("1 == !0"), 1.0);
  EXPECT_EQ(value_of("1 ? 2 : 3"), 2.0);
  EXPECT_EQ(value_of("0 ? 2 : 3"), 3.0);
  EXPECT_EQ(value_of("0 ? 1 : 0 ? 2 : 3"), 3.0);
  EXPECT_EQ(value_of("1 ? 0 ? 4 : 5 : 6"), 5.0);
  EXPECT_EQ(value_of("1 > 2 ? 10 : 20 + 1"), 21.0);
  EXPECT_EQ(value_of("(0 ? 1 : 2) + 3"), 5.0);
  EXPECT_EQ(value_of("2 * (1 ? 3 : 4)"), 6.0);
  EXPECT_EQ(value_of("max(1 ? 2 : 9, 0 ? 9 : 3)"), 3.0);
  EXPECT_EQ(value_of("-(0 ? 1 : 2)"), -2.0);
}

TEST(Expression, InfinityAndNaNAreValues) {
  EXPECT_EQ(value_of("1/0"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(value_of("0/0")));
  EXPECT_TRUE(std::isnan(value_of("sqrt(-1)")));
  EXPECT_TRUE(std::isnan(value_of("(-8)^(1/3)")));
}

TEST(Expression, PowersAreOurOwn) {
  const std::array<std::string_view, 2> names{"x", "y"};
  const auto power = Expression::compile("x^y", names, {});
  const auto square = Expression::compile("x^2", names, {});
  ASSERT_TRUE(power);
  ASSERT_TRUE(square);
  for (int i = 1; i < 500; ++i) {
    const std::array<double, 2> values{0.37 * i, std::sin(i) * 20.0};
    EXPECT_EQ((*power)(values), math::pow(values[0], values[1]));
    EXPECT_EQ((*square)(values), values[0] * values[0]);
  }
  EXPECT_EQ(value_of("1.1^2.2"), math::pow(1.1, 2.2));  // folded while compiling
}

/// muParser's optimiser would turn this into x*1 + 0.
TEST(Expression, NothingIsRearranged) {
  const std::array<std::string_view, 1> names{"x"};
  const auto compiled = Expression::compile("x + 1e16 - 1e16", names, {});
  ASSERT_TRUE(compiled);
  EXPECT_EQ((*compiled)(std::array{0.5}), 0.5 + 1e16 - 1e16);
  EXPECT_NE((*compiled)(std::array{0.5}), 0.5);
}

TEST(Expression, VariablesComeInTheGivenOrder) {
  const std::array<std::string_view, 4> names{"x", "y", "r", "rand_2"};
  const auto compiled = Expression::compile("x - 10*y + 100 * rand_2", names, {});
  ASSERT_TRUE(compiled);
  EXPECT_EQ((*compiled)(std::array{1.0, 2.0, 77.0, 3.0}), 281.0);
  EXPECT_EQ((*compiled)(std::array{4.0, 0.0, 77.0, 0.0}), 4.0);
  EXPECT_TRUE(compiled->uses(0));
  EXPECT_TRUE(compiled->uses(1));
  EXPECT_FALSE(compiled->uses(2));
  EXPECT_TRUE(compiled->uses(3));
  EXPECT_FALSE(compiled->is_constant());
  EXPECT_EQ(compiled->text(), "x - 10*y + 100 * rand_2");
}

TEST(Expression, AVariableHidesAConstantAndMayBeNamedLikeAFunction) {
  const std::array<std::string_view, 2> names{"e", "mod"};
  const auto compiled = Expression::compile("e + mod(7, mod) * pi", names, {});
  ASSERT_TRUE(compiled) << problems_text(compiled.problems());
  EXPECT_EQ((*compiled)(std::array{1.0, 4.0}), 1.0 + 3.0 * math::pi);
}

TEST(Expression, ConstantsUseNothing) {
  const std::array<std::string_view, 1> names{"x"};
  const auto compiled = Expression::compile("sqrt(3)/6", names, {});
  ASSERT_TRUE(compiled);
  EXPECT_TRUE(compiled->is_constant());
  EXPECT_EQ((*compiled)(std::array{0.0}), std::sqrt(3.0) / 6.0);
  EXPECT_EQ(Expression()({}), 0.0);
  EXPECT_EQ(Expression().text(), "0");
  EXPECT_TRUE(Expression().is_constant());
}

TEST(Expression, CopiesAreIndependent) {
  const std::array<std::string_view, 1> names{"x"};
  auto first = Expression::compile("x*x", names, {});
  ASSERT_TRUE(first);
  Expression second = *first;
  *first = Expression();
  EXPECT_EQ(second(std::array{3.0}), 9.0);
  EXPECT_TRUE(second.uses(0));
  const Expression third = std::move(second);
  EXPECT_EQ(third(std::array{4.0}), 16.0);
}

TEST(Expression, CopiesRunOnThreadsOfTheirOwn) {
  const std::array<std::string_view, 1> names{"x"};
  const auto shared = Expression::compile("sin(x) + x^3 / (1 + x)", names, {});
  ASSERT_TRUE(shared);
  const auto sum = [](const Expression& f) {
    double total = 0.0;
    for (int i = 0; i < 20000; ++i) total += f(std::array{0.001 * i});
    return total;
  };
  std::array<double, 4> totals{};
  {
    std::vector<std::jthread> threads;
    for (double& total : totals) threads.emplace_back([&total, &sum, copy = *shared] { total = sum(copy); });
  }
  for (const double total : totals) EXPECT_EQ(total, sum(*shared));
}

class CommaLocale : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Expression, LocalesDoNotReachNumbers) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaLocale));
  const double value = value_of("max(1.5, 0.25)");
  std::locale::global(before);
  EXPECT_EQ(value, 1.5);
}

TEST(EvaluateConstant, WantsAFiniteNumber) {
  const auto good = evaluate_constant("sqrt(3)/6", {});
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, std::sqrt(3.0) / 6.0);
  for (const std::string_view bad : {"1/0", "0/0", "log(0)"}) {
    const auto result = evaluate_constant(bad, {"f", 3, 4});
    ASSERT_FALSE(result) << bad;
    EXPECT_NE(result.problems()[0].message.find("a finite number is expected"), std::string::npos);
    EXPECT_EQ(result.problems()[0].where.line, 3);
    EXPECT_EQ(result.problems()[0].where.column, 4);
  }
  EXPECT_FALSE(evaluate_constant("x", {}));
}

}  // namespace
}  // namespace burin::expr
