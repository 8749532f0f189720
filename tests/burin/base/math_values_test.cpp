// Values the elementary functions must hit exactly, their special cases, and one hash that pins every bit.
#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/base/sha256.hpp>

namespace burin {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tiniest = std::numeric_limits<double>::denorm_min();

TEST(MathValues, DegreesAreExactWhereTheValueIs) {
  for (int turn = -5; turn <= 5; ++turn) {
    const double d = 360.0 * turn;
    for (const auto& [degrees, sine] : {std::pair{0.0, 0.0},
                                        {30.0, 0.5},
                                        {90.0, 1.0},
                                        {150.0, 0.5},
                                        {180.0, 0.0},
                                        {210.0, -0.5},
                                        {270.0, -1.0},
                                        {330.0, -0.5}}) {
      EXPECT_EQ(math::sin_degrees(d + degrees), sine) << d + degrees;
      EXPECT_EQ(math::cos_degrees(d + degrees - 90.0), sine) << d + degrees - 90.0;
      EXPECT_FALSE(sine == 0.0 && std::signbit(math::sin_degrees(d + degrees))) << d + degrees;
    }
    EXPECT_EQ(math::tan_degrees(d + 45.0), 1.0);
    EXPECT_EQ(math::tan_degrees(d + 135.0), -1.0);
    EXPECT_EQ(math::tan_degrees(d + 90.0), inf);
    EXPECT_EQ(math::sin_degrees(d + 45.0), std::sqrt(0.5));
    EXPECT_EQ(math::cos_degrees(d + 45.0), std::sqrt(0.5));
    EXPECT_EQ(math::sin_degrees(d + 60.0), std::sqrt(0.75));
  }
  EXPECT_EQ(math::sin_degrees(360.0 * 0x1p900 + 0.0), 0.0);
  EXPECT_TRUE(std::isnan(math::sin_degrees(inf)));
  EXPECT_TRUE(std::isnan(math::cos_degrees(nan)));
}

TEST(MathValues, InverseDegreesAreExactWhereTheValueIs) {
  EXPECT_EQ(math::asin_degrees(0.5), 30.0);
  EXPECT_EQ(math::asin_degrees(-1.0), -90.0);
  EXPECT_EQ(math::acos_degrees(0.5), 60.0);
  EXPECT_EQ(math::acos_degrees(-0.5), 120.0);
  EXPECT_EQ(math::acos_degrees(0.0), 90.0);
  EXPECT_EQ(math::acos_degrees(-1.0), 180.0);
  EXPECT_EQ(math::atan_degrees(1.0), 45.0);
  EXPECT_EQ(math::atan_degrees(-inf), -90.0);
  EXPECT_EQ(math::atan2_degrees(1.0, -1.0), 135.0);
  EXPECT_EQ(math::atan2_degrees(-7e300, -7e300), -135.0);
  EXPECT_EQ(math::atan2_degrees(tiniest, tiniest), 45.0);
  EXPECT_EQ(math::atan2_degrees(-3.0, 0.0), -90.0);
}

TEST(MathValues, RadiansKnowTheTruePi) {
  EXPECT_EQ(math::sin(math::pi), 0x1.1a62633145c07p-53);  // what the double pi lacks
  EXPECT_EQ(math::cos(0.5 * math::pi), 0x1.1a62633145c07p-54);
  EXPECT_EQ(math::cos(0x1p1023), static_cast<double>(std::cos(0x1p1023L)));
  // The double closest to a multiple of pi/2: 61 bits cancel.
  EXPECT_EQ(math::cos(6381956970095103.0 * 0x1p797), static_cast<double>(std::cos(6381956970095103.0L * 0x1p797L)));
}

TEST(MathValues, SignedZerosAndTinyArgumentsPassThrough) {
  for (const double x : {0.0, -0.0, tiniest, -tiniest, 1e-300, -1e-10}) {
    for (const auto f : {math::sin, math::tan, math::asin, math::atan}) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(f(x)), std::bit_cast<std::uint64_t>(x)) << x;
    }
  }
  EXPECT_TRUE(std::signbit(math::cbrt(-0.0)));
  EXPECT_EQ(math::cos(tiniest), 1.0);
  EXPECT_EQ(math::exp(-0.0), 1.0);
}

TEST(MathValues, CosineAndSineTogetherHaveTheBitsOfEach) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  using math::pi;
  std::vector<double> angles = {0.0, -0.0, 1e-300, -1e-9, pi / 4, pi / 2, pi, 1.5 * pi, 2.0 * pi, 1e6, 1e15, -1e300};
  for (int k = -4000; k < 4000; ++k) angles.push_back(0.0073 * k);
  for (const double angle : angles) {
    const math::CosineSine both = math::cos_sin(angle);
    EXPECT_EQ(bits(both.cosine), bits(math::cos(angle))) << angle;
    EXPECT_EQ(bits(both.sine), bits(math::sin(angle))) << angle;
  }
  EXPECT_TRUE(std::isnan(math::cos_sin(inf).cosine));
  EXPECT_TRUE(std::isnan(math::cos_sin(nan).sine));
}

TEST(MathValues, OutsideTheDomainIsNaN) {
  for (const auto f : {math::sin, math::cos, math::tan, math::asin, math::acos}) {
    EXPECT_TRUE(std::isnan(f(inf)));
    EXPECT_TRUE(std::isnan(f(-inf)));
    EXPECT_TRUE(std::isnan(f(nan)));
  }
  for (const auto f : {math::log, math::log2, math::log10}) {
    EXPECT_TRUE(std::isnan(f(-1.0)));
    EXPECT_TRUE(std::isnan(f(-inf)));
    EXPECT_TRUE(std::isnan(f(nan)));
    EXPECT_EQ(f(0.0), -inf);
    EXPECT_EQ(f(inf), inf);
    EXPECT_EQ(f(1.0), 0.0);
  }
  EXPECT_TRUE(std::isnan(math::asin(1.0000000000000002)));
  EXPECT_TRUE(std::isnan(math::pow(-8.0, 1.0 / 3.0)));
  EXPECT_TRUE(std::isnan(math::exp(nan)));
  EXPECT_TRUE(std::isnan(math::atan2(nan, 1.0)));
  EXPECT_TRUE(std::isnan(math::hypot(1.0, nan)));
}

TEST(MathValues, Atan2FollowsIeee) {
  EXPECT_EQ(math::atan2(0.0, 1.0), 0.0);
  EXPECT_EQ(math::atan2(0.0, -1.0), math::pi);
  EXPECT_EQ(math::atan2(-0.0, -1.0), -math::pi);
  EXPECT_EQ(math::atan2(0.0, -0.0), math::pi);
  EXPECT_TRUE(std::signbit(math::atan2(-0.0, 0.0)));
  EXPECT_EQ(math::atan2(1.0, 0.0), 0.5 * math::pi);
  EXPECT_EQ(math::atan2(-1.0, -0.0), -0.5 * math::pi);
  EXPECT_EQ(math::atan2(inf, inf), 0.25 * math::pi);
  EXPECT_EQ(math::atan2(-inf, -inf), -0.75 * math::pi);
  EXPECT_EQ(math::atan2(1.0, inf), 0.0);
  EXPECT_EQ(math::atan2(1.0, -inf), math::pi);
  EXPECT_EQ(math::atan2(inf, -5.0), 0.5 * math::pi);
  EXPECT_EQ(math::atan2(tiniest, 1e300), 0.0);
}

TEST(MathValues, ExponentialsEndWhereDoublesDo) {
  EXPECT_EQ(math::exp(709.782712893384), 0x1.fffffffffff2ap1023);
  EXPECT_EQ(math::exp(709.782712893385), inf);
  EXPECT_EQ(math::exp(-745.1332191019411), tiniest);
  EXPECT_EQ(math::exp(-745.1332191019413), 0.0);
  EXPECT_EQ(math::exp(inf), inf);
  EXPECT_EQ(math::exp(-inf), 0.0);
  EXPECT_EQ(math::exp(1.0), 2.718281828459045);
}

TEST(MathValues, LogarithmsAreExactForExactPowers) {
  for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(math::log2(std::ldexp(1.0, n)), n);
  double power = 1.0;
  for (int n = 0; n <= 22; ++n, power *= 10.0) EXPECT_EQ(math::log10(power), n);
}

TEST(MathValues, RepresentableIntegerPowersAreExact) {
  for (int base = -40; base <= 40; ++base) {
    double power = 1.0;
    for (int n = 0; std::abs(power) <= 0x1p53; ++n, power *= base) {
      EXPECT_EQ(math::pow(base, n), power) << base << '^' << n;
      if (n > 200) break;  // 0, 1 and -1 never grow
    }
  }
  for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(math::pow(2.0, n), std::ldexp(1.0, n)) << n;
  EXPECT_EQ(math::pow(0.75, 20.0), 3486784401.0 / 0x1p40);
  EXPECT_EQ(math::pow(1.5, 33.0), 5559060566555523.0 / 0x1p33);
  EXPECT_EQ(math::pow(4.0, -0.5), 0.5);
  EXPECT_EQ(math::pow(6.25, 1.5), 15.625);
  for (int n = -200000; n <= 200000; n += 37) EXPECT_EQ(math::cbrt(static_cast<double>(n) * n * n), n);
}

TEST(MathValues, PowFollowsIeee) {
  for (const double x : {0.0, -1.0, 5.0, inf, -inf, nan}) EXPECT_EQ(math::pow(x, 0.0), 1.0);
  for (const double y : {-3.0, 0.5, inf, -inf, nan}) EXPECT_EQ(math::pow(1.0, y), 1.0);
  EXPECT_EQ(math::pow(-1.0, inf), 1.0);
  EXPECT_EQ(math::pow(0.5, inf), 0.0);
  EXPECT_EQ(math::pow(-2.0, -inf), 0.0);
  EXPECT_EQ(math::pow(0.5, -inf), inf);
  EXPECT_EQ(math::pow(-0.0, -3.0), -inf);
  EXPECT_EQ(math::pow(-0.0, -4.0), inf);
  EXPECT_TRUE(std::signbit(math::pow(-0.0, 3.0)));
  EXPECT_FALSE(std::signbit(math::pow(-0.0, 2.5)));
  EXPECT_EQ(math::pow(-inf, 3.0), -inf);
  EXPECT_EQ(math::pow(-inf, 0.5), inf);
  EXPECT_EQ(math::pow(inf, -1.0), 0.0);
  EXPECT_EQ(math::pow(-2.0, 1025.0), -inf);
  EXPECT_EQ(math::pow(-2.0, 0x1p53 - 1.0), -inf);
  EXPECT_EQ(math::pow(-1.0, 0x1p53 - 1.0), -1.0);
  EXPECT_EQ(math::pow(-1.0, 0x1p53 + 2.0), 1.0);
  EXPECT_EQ(math::pow(3.0, 1e308), inf);
  EXPECT_TRUE(std::isnan(math::pow(nan, 2.0)));
}

TEST(MathValues, HypotNeitherOverflowsNorVanishes) {
  EXPECT_EQ(math::hypot(3.0, -4.0), 5.0);
  EXPECT_EQ(math::hypot(3e300, 4e300), 5e300);
  EXPECT_EQ(math::hypot(3 * tiniest, 4 * tiniest), 5 * tiniest);
  EXPECT_EQ(math::hypot(0.0, 0.0), 0.0);
  EXPECT_EQ(math::hypot(nan, -inf), inf);
  EXPECT_EQ(math::hypot(1e308, 1.2e308), 1.5620499351813308e308);
  EXPECT_EQ(math::hypot(1.7e308, 1.7e308), inf);
}

/// Any change of any bit shows here: compilers and machines must agree with this line.
TEST(MathValues, BitsArePinned) {
  Sha256 hash;
  const auto pin = [&hash](double value) {
    auto bits = std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8U) hash.add(std::string(1, static_cast<char>(bits & 0xFFU)));
  };
  for (int i = 0; i < 20000; ++i) {
    const double any = std::bit_cast<double>(random_bits(7, i));
    const double unit = uniform_symmetric(8, i);
    const double everyday = 1000.0 * uniform_symmetric(9, i);
    for (const double x : {any, unit, everyday}) {
      for (const auto f : {math::sin, math::cos, math::tan, math::sin_degrees, math::cos_degrees, math::tan_degrees,
                           math::asin, math::acos, math::atan, math::asin_degrees, math::acos_degrees,
                           math::atan_degrees, math::exp, math::log, math::log2, math::log10, math::cbrt}) {
        pin(f(x));
      }
      for (const auto f : {math::atan2, math::atan2_degrees, math::pow, math::hypot}) {
        pin(f(x, unit));
        pin(f(std::abs(everyday), x));
      }
    }
  }
  EXPECT_EQ(hash.hex_digest(), "195a2631315e9f9fb0747380b3c5ddafd93c79970a5c4ddcd0fd3ad8f2b53da3");
}

}  // namespace
}  // namespace burin
