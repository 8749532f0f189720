// Random expression trees, written out with as few parentheses as the documented precedences allow and evaluated by
// walking the tree: the parser must read the same tree back.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/expr/expression.hpp>

namespace burin::expr {
namespace {

constexpr std::array<std::string_view, 3> names{"x", "y", "t"};

/// A subexpression's text, its value in double arithmetic and how tightly its outermost operation binds.
struct Term {
  std::string text;
  double value = 0.0;
  int binding = 9;  ///< 0 choice, 1 or, 2 and, 3 comparison, 4 sum, 5 product, 6 sign, 7 power, 9 atom
};

/// Makes one tree from one key.
class Tree {
 public:
  Tree(int key, bool smooth, std::array<double, 3> values) : key_(key), smooth_(smooth), values_(values) {}

  Term grow(int depth) {
    if (depth == 0 || draw(6) == 0) return atom();
    switch (draw(smooth_ ? 5 : 9)) {
      case 0:
        return binary("+", grow(depth - 1), grow(depth - 1), 4, [](double a, double b) { return a + b; });
      case 1:
        return binary("-", grow(depth - 1), grow(depth - 1), 4, [](double a, double b) { return a - b; });
      case 2:
        return binary("*", grow(depth - 1), grow(depth - 1), 5, [](double a, double b) { return a * b; });
      case 3:
        return smooth_ ? call(grow(depth - 1)) : negated(grow(depth - 1));
      case 4:
        return smooth_ ? call(grow(depth - 1)) : square(grow(depth - 1));
      case 5:
        return binary("/", grow(depth - 1), grow(depth - 1), 5, [](double a, double b) { return a / b; });
      case 6:
        return binary("<", grow(depth - 1), grow(depth - 1), 3, [](double a, double b) { return a < b ? 1.0 : 0.0; });
      case 7:
        return binary("&&", grow(depth - 1), grow(depth - 1), 2,
                      [](double a, double b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; });
      default:
        return choice(grow(depth - 1), grow(depth - 1), grow(depth - 1));
    }
  }

 private:
  std::size_t draw(std::size_t count) { return random_bits(2024, key_, step_++) % count; }

  static std::string wrapped(const Term& term, bool wrap) { return wrap ? "(" + term.text + ")" : term.text; }
  std::string blank() { return draw(3) == 0 ? " " : ""; }

  Term atom() {
    if (const std::size_t i = draw(6); i < names.size()) return {std::string(names[i]), values_[i]};
    const auto quarters = static_cast<int>(draw(40));
    return {std::to_string(quarters / 4) + std::array{".0", ".25", ".5", ".75"}[static_cast<std::size_t>(quarters % 4)],
            0.25 * quarters};
  }
  template <class Operation>
  Term binary(const std::string& sign, const Term& a, const Term& b, int binding, Operation operation) {
    return {wrapped(a, a.binding < binding) + blank() + sign + blank() + wrapped(b, b.binding <= binding),
            operation(a.value, b.value), binding};
  }
  static Term negated(const Term& a) { return {"-" + wrapped(a, a.binding < 7), -a.value, 6}; }
  static Term square(const Term& a) { return {wrapped(a, a.binding <= 7) + "^2", a.value * a.value, 7}; }
  static Term choice(const Term& a, const Term& b, const Term& c) {
    return {wrapped(a, a.binding == 0) + "?" + b.text + ":" + c.text, a.value != 0.0 ? b.value : c.value, 0};
  }
  /// Functions that keep values small and errors from growing.
  Term call(const Term& a) {
    switch (draw(5)) {
      case 0:
        return {"sin(" + a.text + ")", std::sin(a.value)};
      case 1:
        return {"cosd(" + a.text + ")", std::cos(a.value * 3.14159265358979323846 / 180.0)};
      case 2:
        return {"atan(" + a.text + ")", std::atan(a.value)};
      case 3:
        return {"hypot(1," + a.text + ")", std::hypot(1.0, a.value)};
      default:
        return {"exp(-abs(" + a.text + "))", std::exp(-std::abs(a.value))};
    }
  }

  int key_;
  bool smooth_;
  std::array<double, 3> values_;
  int step_ = 0;
};

Term random_term(int key, bool smooth, const std::array<double, 3>& values) {
  return Tree(key, smooth, values).grow(1 + key % 5);
}

std::array<double, 3> random_values(int key) {
  return {uniform_symmetric(1, key), 4.0 * uniform_symmetric(2, key), std::floor(4.0 * uniform(3, key))};
}

TEST(RandomExpressions, ArithmeticIsExact) {
  for (int key = 0; key < 7000; ++key) {
    const std::array<double, 3> values = random_values(key);
    const Term term = random_term(key, false, values);
    if (term.text.size() > 4000) continue;
    const auto compiled = Expression::compile(term.text, names, {"f", 1, 1});
    ASSERT_TRUE(compiled) << term.text << '\n' << problems_text(compiled.problems());
    const double value = (*compiled)(values);
    ASSERT_TRUE(value == term.value || (std::isnan(value) && std::isnan(term.value)))
        << "key " << key << ": " << term.text << " = " << value << ", not " << term.value;
  }
}

TEST(RandomExpressions, FunctionsAgreeWithTheCLibrary) {
  for (int key = 0; key < 7000; ++key) {
    const std::array<double, 3> values = random_values(key);
    const Term term = random_term(key, true, values);
    if (term.text.size() > 4000 || std::abs(term.value) > 1e4) continue;
    const auto compiled = Expression::compile(term.text, names, {"f", 1, 1});
    ASSERT_TRUE(compiled) << term.text << '\n' << problems_text(compiled.problems());
    const double value = (*compiled)(values);
    ASSERT_NEAR(value, term.value, 1e-7 * (1.0 + std::abs(term.value))) << "key " << key << ": " << term.text;
  }
}

}  // namespace
}  // namespace burin::expr
