#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/expr/expression.hpp>

#include "support.hpp"

namespace burin::expr {
namespace {

TEST(Functions, OfAngles) {
  EXPECT_EQ(value_of("sin(1)"), math::sin(1.0));
  EXPECT_EQ(value_of("cos(1)"), math::cos(1.0));
  EXPECT_EQ(value_of("tan(1)"), math::tan(1.0));
  EXPECT_EQ(value_of("asin(0.3)"), math::asin(0.3));
  EXPECT_EQ(value_of("acos(0.3)"), math::acos(0.3));
  EXPECT_EQ(value_of("atan(0.3)"), math::atan(0.3));
  EXPECT_EQ(value_of("atan2(-1, -2)"), math::atan2(-1.0, -2.0));
  EXPECT_EQ(value_of("sind(30)"), 0.5);
  EXPECT_EQ(value_of("cosd(60)"), 0.5);
  EXPECT_EQ(value_of("tand(45)"), 1.0);
  EXPECT_EQ(value_of("asind(1/2)"), 30.0);
  EXPECT_EQ(value_of("acosd(1/2)"), 60.0);
  EXPECT_EQ(value_of("atand(1)"), 45.0);
  EXPECT_EQ(value_of("atan2d(1, -1)"), 135.0);
  EXPECT_EQ(value_of("pi"), math::pi);
  EXPECT_EQ(value_of("tau"), 2.0 * math::pi);
  EXPECT_EQ(value_of("e"), math::exp(1.0));
}

TEST(Functions, OfPowers) {
  EXPECT_EQ(value_of("exp(2)"), math::exp(2.0));
  EXPECT_EQ(value_of("log(e)"), 1.0);
  EXPECT_EQ(value_of("log10(1000)"), 3.0);
  EXPECT_EQ(value_of("log2(1/8)"), -3.0);
  EXPECT_EQ(value_of("sqrt(2)"), std::sqrt(2.0));
  EXPECT_EQ(value_of("cbrt(-27)"), -3.0);
  EXPECT_EQ(value_of("pow(2, 10)"), 1024.0);
  EXPECT_EQ(value_of("hypot(3, 4)"), 5.0);
}

TEST(Functions, OfRounding) {
  EXPECT_EQ(value_of("abs(-2)"), 2.0);
  EXPECT_EQ(value_of("sign(-2) + 10*sign(0) + 100*sign(7)"), 99.0);
  EXPECT_EQ(value_of("floor(-1.5)"), -2.0);
  EXPECT_EQ(value_of("ceil(-1.5)"), -1.0);
  EXPECT_EQ(value_of("round(2.5)"), 3.0);
  EXPECT_EQ(value_of("round(-2.5)"), -3.0);
  EXPECT_EQ(value_of("frac(-1.25)"), 0.75);
  EXPECT_EQ(value_of("mod(7, 3)"), 1.0);
  EXPECT_EQ(value_of("mod(-7, 3)"), 2.0);
  EXPECT_EQ(value_of("mod(7, -3)"), -2.0);
  EXPECT_EQ(value_of("mod(-6, 3)"), 0.0);
  EXPECT_EQ(value_of("mod(5.5, 2)"), 1.5);
}

TEST(Functions, OfChoosingAndBlending) {
  EXPECT_EQ(value_of("min(3, 1, 2)"), 1.0);
  EXPECT_EQ(value_of("max(3)"), 3.0);
  EXPECT_EQ(value_of("max(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13)"), 13.0);
  EXPECT_TRUE(std::isnan(value_of("min(1, 0/0, 2)")));
  EXPECT_TRUE(std::isnan(value_of("max(0/0, 2)")));
  EXPECT_EQ(value_of("clamp(5, 0, 1) + clamp(-5, 0, 1) + clamp(0.5, 0, 1)"), 1.5);
  EXPECT_EQ(value_of("lerp(14, 4, 0.5)"), 9.0);
  EXPECT_EQ(value_of("smoothstep(0, 2, 1)"), 0.5);
  EXPECT_EQ(value_of("smoothstep(0, 2, -1)"), 0.0);
  EXPECT_EQ(value_of("smoothstep(0, 2, 3)"), 1.0);
  EXPECT_EQ(value_of("smoothstep(2, 0, 0.5)"), 0.84375);
  EXPECT_EQ(value_of("smoothstep(1, 1, 0.9) + 10*smoothstep(1, 1, 1)"), 10.0);
}

class Noise : public testing::Test {
 protected:
  double operator()(double x, double y) const { return compiled_(std::array{x, y}); }

 private:
  Expression compiled_ = *Expression::compile("noise(x, y)", std::array<std::string_view, 2>{"x", "y"}, {});
};

TEST_F(Noise, StaysBetweenMinusOneAndOneAndUsesThatRange) {
  double least = 0.0;
  double greatest = 0.0;
  double sum = 0.0;
  constexpr int samples = 50000;
  for (int i = 0; i < samples; ++i) {
    const double value = (*this)(300.0 * uniform_symmetric(1, i), 300.0 * uniform_symmetric(2, i));
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
  }
  EXPECT_GE(least, -1.0);
  EXPECT_LE(greatest, 1.0);
  EXPECT_LT(least, -0.7);
  EXPECT_GT(greatest, 0.7);
  EXPECT_NEAR(sum / samples, 0.0, 0.02);
}

TEST_F(Noise, HasNoStepsAndNoKinks) {
  constexpr double h = 1e-4;
  for (int i = 0; i < 20000; ++i) {
    // Half of the points lie on the lines between cells, where a seam would show.
    const double x = i % 2 == 0 ? std::floor(20.0 * uniform_symmetric(3, i)) : 20.0 * uniform_symmetric(3, i);
    const double y = 20.0 * uniform_symmetric(4, i);
    const double before = (*this)(x - h, y);
    const double here = (*this)(x, y);
    const double after = (*this)(x + h, y);
    EXPECT_LT(std::abs(after - here), 6.0 * h);
    EXPECT_LT(std::abs(after - 2.0 * here + before), 40.0 * h * h);
  }
}

TEST_F(Noise, IsPinned) {
  EXPECT_EQ((*this)(0.0, 0.0), 0.0);
  EXPECT_EQ((*this)(-3.0, 12.0), 0.0);
  EXPECT_EQ((*this)(0.5, 0.5), -0.20852232973991244);
  EXPECT_EQ((*this)(-17.25, 1234.625), -0.61166460200944162);
  EXPECT_EQ((*this)(1e300, 0.5), 0.0);
  EXPECT_EQ((*this)(INFINITY, 0.5), 0.0);
  EXPECT_TRUE(std::isnan((*this)(0.5, NAN)));
}

TEST(Functions, NamesAreUniqueAndKnown) {
  std::vector<std::string_view> names = function_names();
  EXPECT_EQ(names.size(), 38U);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_TRUE(std::ranges::binary_search(names, "smoothstep"));
  EXPECT_TRUE(std::ranges::binary_search(names, "pi"));
}

TEST(Functions, APresetMayBringItsOwn) {
  const auto own = [](const char* name, auto value) {
    return PlaneFunction{name, std::make_shared<const std::function<double(double, double)>>(value)};
  };
  const std::vector<PlaneFunction> functions{own("face", [](double x, double y) { return 10 * x + y; }),
                                             own("noise", [](double, double) { return 7.0; })};
  constexpr std::array<std::string_view, 1> variables{"u"};
  const auto compile = [&](std::string_view text) { return Expression::compile(text, variables, {}, functions); };
  Result<Expression> made = compile("face(u, 2) + face(1, face(0, u))");
  ASSERT_TRUE(made.ok()) << problems_text(made.problems());
  const Expression copy = *made;
  *made = Expression();  // the copy has functions of its own
  EXPECT_EQ(copy(std::array{3.0}), 32.0 + 13.0);
  EXPECT_EQ((*compile("noise(0.3, 0.4)"))(std::array{0.0}), 7.0);  // hides ours
  EXPECT_EQ(compile("face(u)").problems().front().message, "'face' takes 2 arguments, not 1");
  EXPECT_EQ(compile("fcae(u, 1)").problems().front().message, "unknown function 'fcae'; did you mean 'face'?");
  EXPECT_FALSE(Expression::compile("face(u, 1)", variables, {}).ok());
}

}  // namespace
}  // namespace burin::expr
