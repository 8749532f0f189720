#include <array>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/expr/expression.hpp>

#include "support.hpp"

namespace burin::expr {
namespace {

constexpr std::array<std::string_view, 3> names{"x", "y", "radius"};

/// "column: message" of the one problem, the text beginning at line 1, column 1.
std::string refusal(std::string_view text) {
  const auto compiled = Expression::compile(text, names, {"f", 1, 1});
  if (compiled) return "compiled";
  EXPECT_EQ(compiled.problems().size(), 1U);
  const Problem& problem = compiled.problems()[0];
  EXPECT_EQ(problem.where.file, "f");
  EXPECT_EQ(problem.where.line, 1);
  return std::to_string(problem.where.column) + ": " + problem.message;
}

TEST(ExpressionErrors, UnknownNames) {
  EXPECT_EQ(refusal("x + raduis"), "5: unknown name 'raduis'; did you mean 'radius'?");
  EXPECT_EQ(refusal("1 + sinn(x)"), "5: unknown function 'sinn'; did you mean 'sin'?");
  EXPECT_EQ(refusal("2*qqqqqq"), "3: unknown name 'qqqqqq'; known: x, y, radius, pi, tau, e");
  EXPECT_EQ(refusal("sqr"), "1: unknown name 'sqr'; did you mean 'sqrt'?");
  EXPECT_EQ(refusal("radius(2)"), "1: unknown function 'radius'; did you mean 'radius'?");
  EXPECT_EQ(refusal("sin"), "1: 'sin' is a function: write sin(...)");
  EXPECT_EQ(refusal("inf"), "1: unknown name 'inf'; known: x, y, radius, pi, tau, e");
  EXPECT_EQ(refusal("X"), "1: unknown name 'X'; known: x, y, radius, pi, tau, e");
}

TEST(ExpressionErrors, Syntax) {
  EXPECT_EQ(refusal(""), "1: an expression is missing");
  EXPECT_EQ(refusal("  "), "3: an expression is missing");
  EXPECT_EQ(refusal("1 +"), "4: the expression ends where a value is expected");
  EXPECT_EQ(refusal("-"), "2: the expression ends where a value is expected");
  EXPECT_EQ(refusal("1 + * 2"), "5: a number, a name or '(' is expected here, not '*'");
  EXPECT_EQ(refusal("()"), "2: a number, a name or '(' is expected here, not ')'");
  EXPECT_EQ(refusal("2x"), "2: an operator is missing before 'x'; a product is written with '*'");
  EXPECT_EQ(refusal("2 (3)"), "3: an operator is missing before '('; a product is written with '*'");
  EXPECT_EQ(refusal("1.2.3"), "4: an operator is missing before '.'; a product is written with '*'");
  EXPECT_EQ(refusal("0x10"), "2: an operator is missing before 'x10'; a product is written with '*'");
  EXPECT_EQ(refusal("(1 + 2"), "1: this parenthesis is never closed");
  EXPECT_EQ(refusal("1 + 2)"), "6: this ')' closes nothing");
  EXPECT_EQ(refusal("x = 2"), "3: '=' assigns nothing here; compare with '=='");
  EXPECT_EQ(refusal("x & y"), "3: '&' is no operator; 'and' is written '&&'");
  EXPECT_EQ(refusal("x | y"), "3: '|' is no operator; 'or' is written '||'");
  EXPECT_EQ(refusal("x % y"), "3: '%' is no operator; the remainder is mod(a, b)");
  EXPECT_EQ(refusal("!!x"), "1: '!' cannot stand beside another sign; use parentheses, as in !(-x)");
  EXPECT_EQ(refusal("-!x"), "2: '!' cannot stand beside another sign; use parentheses, as in !(-x)");
  EXPECT_EQ(refusal("1e999"), "1: '1e999' is too large or too small for a number");
  EXPECT_EQ(refusal("x $ 2"), "3: unexpected character '$'");
  EXPECT_EQ(refusal("\"a\""), "1: a number, a name or '(' is expected here, not '\"'");
  EXPECT_EQ(refusal("2 \xC3\x97 3"), "3: unexpected character '\xC3\x97'");
  EXPECT_EQ(refusal(std::string_view("1\0+2", 4)), "2: unexpected character '\\x00'");
}

TEST(ExpressionErrors, Choices) {
  EXPECT_EQ(refusal("x ? 1"), "3: '?' without its ':', as in a > b ? a : b");
  EXPECT_EQ(refusal("1 : 2"), "3: ':' without a '?' before it");
  EXPECT_EQ(refusal("x ? (1 : 2)"), "8: ':' without a '?' before it");
  EXPECT_EQ(refusal("(x ? 1) : 2"), "4: '?' without its ':', as in a > b ? a : b");
  EXPECT_EQ(refusal("min(x ? 1, 2)"), "7: '?' without its ':', as in a > b ? a : b");
}

TEST(ExpressionErrors, Arguments) {
  EXPECT_EQ(refusal("1, 2"), "2: ',' only separates the arguments of a function; decimals take a point, as in 0.5");
  EXPECT_EQ(refusal("sin((1, 2))"),
            "7: ',' only separates the arguments of a function; decimals take a point, as in 0.5");
  EXPECT_EQ(refusal("x + sin(1, 2)"), "5: 'sin' takes 1 argument, not 2");
  EXPECT_EQ(refusal("clamp(1, 2)"), "1: 'clamp' takes 3 arguments, not 2");
  EXPECT_EQ(refusal("sin()"), "5: 'sin' needs an argument");
  EXPECT_EQ(refusal("min( )"), "6: 'min' needs an argument");
  EXPECT_EQ(refusal("min(1,)"), "7: a number, a name or '(' is expected here, not ')'");
  EXPECT_EQ(refusal("min(,1)"), "5: a number, a name or '(' is expected here, not ','");
}

TEST(ExpressionErrors, ColumnsAreAddedToThePlaceOfTheText) {
  const auto compiled = Expression::compile("x + foo", names, {"a.toml", 12, 20});
  ASSERT_FALSE(compiled);
  EXPECT_EQ(compiled.problems()[0].where.line, 12);
  EXPECT_EQ(compiled.problems()[0].where.column, 24);
  // An option has no columns: the words say where.
  const auto option = Expression::compile("2 + width", {}, {"-D a=2+width", 0, 0});
  ASSERT_FALSE(option);
  EXPECT_EQ(problem_text(option.problems()[0]),
            "-D a=2+width: error: at character 5 of '2 + width': unknown name 'width'; known: pi, tau, e");
}

TEST(ExpressionErrors, BlanksBeforeTheParenthesisOfAFunctionAreFine) {
  EXPECT_EQ(value_of("max (1, 2)"), 2.0);
}

TEST(HostileExpressions, LengthIsLimited) {
  EXPECT_EQ(refusal(std::string(4097, '1')), "1: the expression has 4097 characters; at most 4096 are allowed");
  EXPECT_EQ(refusal(std::string(100000, '(')), "1: the expression has 100000 characters; at most 4096 are allowed");
  EXPECT_EQ(refusal(std::string(100000, '-') + "1"),
            "1: the expression has 100001 characters; at most 4096 are allowed");
  EXPECT_EQ(value_of(std::string(4095, ' ') + "1"), 1.0);
}

TEST(HostileExpressions, NestingIsLimited) {
  const auto nested = [](std::size_t depth, const std::string& opening) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += opening;
    return text + "1" + std::string(depth, ')');
  };
  EXPECT_EQ(value_of(nested(100, "(")), 1.0);
  EXPECT_EQ(value_of(nested(100, "abs(")), 1.0);
  EXPECT_EQ(refusal(nested(101, "(")), "101: more than 100 parentheses inside each other");
  EXPECT_EQ(refusal(nested(101, "-(")), "202: more than 100 parentheses inside each other");
  EXPECT_EQ(refusal(std::string(4096, '(')), "101: more than 100 parentheses inside each other");
}

TEST(HostileExpressions, LongChainsCompile) {
  EXPECT_EQ(value_of(std::string(4095, '-') + "1"), -1.0);
  EXPECT_EQ(value_of(std::string(4094, '-') + "1"), 1.0);
  std::string sum = "1";
  std::string tower = "1";
  std::string choices = "0";
  for (int i = 0; i < 1000; ++i) {
    sum += "+1";
    tower += "^2";
    choices = "0?1:" + choices;
  }
  EXPECT_EQ(value_of(sum), 1001.0);
  EXPECT_EQ(value_of(tower), 1.0);
  EXPECT_EQ(value_of(choices), 0.0);
  std::string name(4000, 'x');
  EXPECT_EQ(refusal(name).substr(0, 40), "1: unknown name 'xxxxxxxxxxxxxxxxxxxxxxx");
  EXPECT_LT(refusal(name).size(), 150U);
}

/// Whatever the text: a value or exactly one problem inside it, never anything else.
TEST(HostileExpressions, RandomTextsCompileOrAreRefused) {
  constexpr std::array<std::string_view, 34> pieces{
      "1", "2.5", "x",  "y",  "sin(", "min(", "noise(", "(",  ")", ")", ",", "?", ":",  "+",    "-",   "*", "/",
      "^", "<",   ">=", "==", "!=",   "!",    "&&",     "||", " ", "e", "=", "&", "\"", "1e30", "foo", "#", "."};
  int compiled_count = 0;
  constexpr int cases = 30000;
  for (int i = 0; i < cases; ++i) {
    std::string text;
    const auto length = random_bits(77, i) % 12 + 1;
    for (std::size_t k = 0; k < length; ++k) text += pieces[random_bits(78, i, k) % pieces.size()];
    const auto compiled = Expression::compile(text, names, {"f", 1, 1});
    if (compiled) {
      ++compiled_count;
      static_cast<void>((*compiled)(std::array{0.5, -2.0, 3.0}));
      continue;
    }
    ASSERT_EQ(compiled.problems().size(), 1U) << text;
    const Problem& problem = compiled.problems()[0];
    ASSERT_GE(problem.where.column, 1) << text;
    ASSERT_LE(problem.where.column, static_cast<int>(text.size()) + 1) << text;
    // Our own check finds every error: muParser is never the one to refuse.
    ASSERT_EQ(problem.message.find("is no expression"), std::string::npos) << text << ": " << problem.message;
  }
  EXPECT_GT(compiled_count, cases / 100);
}

}  // namespace
}  // namespace burin::expr
