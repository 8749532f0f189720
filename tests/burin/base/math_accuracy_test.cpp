// The elementary functions against the C library's long double ones, which carry 11 bits more and share no code.
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>

namespace burin {
namespace {

constexpr std::uint64_t seed = 20240517;
constexpr int arguments_each = 40000;

long double ulp(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0L, std::max(exponent - 53, -1074));
}

/// Any finite double, all magnitudes alike.
double any_double(int i) {
  for (int attempt = 0;; ++attempt) {
    const double x = std::bit_cast<double>(random_bits(seed, 1, i, attempt));
    if (std::isfinite(x)) return x;
  }
}
double positive_double(int i) {
  return std::abs(any_double(i));
}
/// Between 2^-30 and 2^30, either sign.
double everyday_double(int i) {
  const double mantissa = uniform_symmetric(seed, 2, i);
  return std::copysign(std::ldexp(1.0 + std::abs(mantissa), static_cast<int>(uniform(seed, 3, i) * 60.0) - 30),
                       mantissa);
}
double in_unit_interval(int i) {
  return uniform_symmetric(seed, 4, i);
}
double near_one(int i) {
  return 1.0 + std::ldexp(uniform_symmetric(seed, 5, i), -(i % 53));
}
double in_range_of_exp(int i) {
  return 746.0 * uniform_symmetric(seed, 6, i);
}
/// As close to a multiple of pi/2 as a double can be made: the reduction has to cancel almost everything.
double near_quarter_turn(int i) {
  const auto multiple = static_cast<long double>(random_bits(seed, 7, i) >> (11 + i % 52));
  return static_cast<double>(multiple * 1.57079632679489661923132169163975144L);
}

struct Accuracy {
  std::string name;
  std::function<double(double)> ours;
  std::function<long double(long double)> truth;
  std::function<double(int)> argument;
};

void PrintTo(const Accuracy& row, std::ostream* out) {
  *out << row.name;
}

class MathAccuracy : public testing::TestWithParam<Accuracy> {};

TEST_P(MathAccuracy, IsWithinOneUlp) {
  static_assert(std::numeric_limits<long double>::digits >= 64, "the oracle needs more bits than a double");
  for (int i = 0; i < arguments_each; ++i) {
    const double x = GetParam().argument(i);
    const double value = GetParam().ours(x);
    const long double truth = GetParam().truth(static_cast<long double>(x));
    const auto rounded = static_cast<double>(truth);
    if (std::isnan(rounded)) {
      ASSERT_TRUE(std::isnan(value)) << GetParam().name << '(' << std::hexfloat << x << ") = " << value;
    } else if (std::isinf(rounded)) {
      ASSERT_EQ(value, rounded) << GetParam().name << '(' << std::hexfloat << x << ')';
    } else {
      ASSERT_LE(std::abs(static_cast<long double>(value) - truth), ulp(rounded))
          << GetParam().name << '(' << std::hexfloat << x << ") = " << value << ", not " << rounded;
    }
  }
}

std::function<double(double)> power(double exponent) {
  return [exponent](double x) { return math::pow(x, exponent); };
}
std::function<long double(long double)> true_power(double exponent) {
  return [exponent](long double x) { return std::pow(x, static_cast<long double>(exponent)); };
}

using Long = long double;
INSTANTIATE_TEST_SUITE_P(
    Functions, MathAccuracy,
    testing::Values(Accuracy{"sin_any", math::sin, [](Long x) { return std::sin(x); }, any_double},
                    Accuracy{"sin_everyday", math::sin, [](Long x) { return std::sin(x); }, everyday_double},
                    Accuracy{"sin_cancelling", math::sin, [](Long x) { return std::sin(x); }, near_quarter_turn},
                    Accuracy{"cos_any", math::cos, [](Long x) { return std::cos(x); }, any_double},
                    Accuracy{"cos_everyday", math::cos, [](Long x) { return std::cos(x); }, everyday_double},
                    Accuracy{"cos_cancelling", math::cos, [](Long x) { return std::cos(x); }, near_quarter_turn},
                    Accuracy{"tan_any", math::tan, [](Long x) { return std::tan(x); }, any_double},
                    Accuracy{"tan_everyday", math::tan, [](Long x) { return std::tan(x); }, everyday_double},
                    Accuracy{"tan_cancelling", math::tan, [](Long x) { return std::tan(x); }, near_quarter_turn},
                    Accuracy{"asin", math::asin, [](Long x) { return std::asin(x); }, in_unit_interval},
                    Accuracy{"asin_near_one", math::asin, [](Long x) { return std::asin(x); }, near_one},
                    Accuracy{"asin_any", math::asin, [](Long x) { return std::asin(x); }, any_double},
                    Accuracy{"acos", math::acos, [](Long x) { return std::acos(x); }, in_unit_interval},
                    Accuracy{"acos_near_one", math::acos, [](Long x) { return std::acos(x); }, near_one},
                    Accuracy{"acos_any", math::acos, [](Long x) { return std::acos(x); }, any_double},
                    Accuracy{"atan_any", math::atan, [](Long x) { return std::atan(x); }, any_double},
                    Accuracy{"atan_everyday", math::atan, [](Long x) { return std::atan(x); }, everyday_double},
                    Accuracy{"exp", math::exp, [](Long x) { return std::exp(x); }, in_range_of_exp},
                    Accuracy{"exp_any", math::exp, [](Long x) { return std::exp(x); }, any_double},
                    Accuracy{"log", math::log, [](Long x) { return std::log(x); }, any_double},
                    Accuracy{"log_near_one", math::log, [](Long x) { return std::log(x); }, near_one},
                    Accuracy{"log2", math::log2, [](Long x) { return std::log2(x); }, positive_double},
                    Accuracy{"log2_near_one", math::log2, [](Long x) { return std::log2(x); }, near_one},
                    Accuracy{"log10", math::log10, [](Long x) { return std::log10(x); }, positive_double},
                    Accuracy{"log10_near_one", math::log10, [](Long x) { return std::log10(x); }, near_one},
                    Accuracy{"cbrt", math::cbrt, [](Long x) { return std::cbrt(x); }, any_double},
                    Accuracy{"square", power(2.0), true_power(2.0), any_double},
                    Accuracy{"root", power(0.5), true_power(0.5), any_double},
                    Accuracy{"inverse_cube", power(-3.0), true_power(-3.0), any_double},
                    Accuracy{"odd_power", power(17.3), true_power(17.3), positive_double},
                    Accuracy{"high_power_near_one", power(1e10), true_power(1e10), near_one},
                    Accuracy{"negative_power_near_one", power(-12345.0), true_power(-12345.0), near_one},
                    Accuracy{"small_power", power(-1e-3), true_power(-1e-3), positive_double}),
    [](const testing::TestParamInfo<Accuracy>& row) { return row.param.name; });

TEST(MathAccuracy, TwoArgumentsAreWithinOneUlp) {
  for (int i = 0; i < arguments_each; ++i) {
    const double y = i % 2 == 0 ? any_double(i) : everyday_double(i);
    const double x = i % 2 == 0 ? any_double(i + arguments_each) : everyday_double(i + arguments_each);
    const Long angle = std::atan2(static_cast<Long>(y), static_cast<Long>(x));
    ASSERT_LE(std::abs(math::atan2(y, x) - angle), ulp(static_cast<double>(angle))) << std::hexfloat << y << ' ' << x;
    const Long length = std::hypot(static_cast<Long>(y), static_cast<Long>(x));
    if (length > std::numeric_limits<double>::max()) {
      ASSERT_GE(math::hypot(y, x), std::numeric_limits<double>::max());
    } else {
      ASSERT_LE(std::abs(math::hypot(y, x) - length), ulp(static_cast<double>(length)))
          << std::hexfloat << y << ' ' << x;
    }
  }
}

TEST(MathAccuracy, PowersOfEverydayNumbersAreWithinOneUlp) {
  for (int i = 0; i < arguments_each; ++i) {
    const double base = std::abs(everyday_double(i));
    const double exponent = 30.0 * in_unit_interval(i);
    const Long truth = std::pow(static_cast<Long>(base), static_cast<Long>(exponent));
    ASSERT_LE(std::abs(math::pow(base, exponent) - truth), ulp(static_cast<double>(truth)))
        << std::hexfloat << base << " ^ " << exponent;
  }
}

TEST(MathAccuracy, DegreesAreWithinOneUlp) {
  constexpr Long per_degree = 0.0174532925199432957692369076848861271L;
  for (int i = 0; i < arguments_each; ++i) {
    const double degrees = 45.0 * in_unit_interval(i);
    const Long radians = static_cast<Long>(degrees) * per_degree;
    ASSERT_LE(std::abs(math::sin_degrees(degrees) - std::sin(radians)), ulp(math::sin_degrees(degrees))) << degrees;
    ASSERT_LE(std::abs(math::cos_degrees(degrees) - std::cos(radians)), ulp(math::cos_degrees(degrees))) << degrees;
    ASSERT_LE(std::abs(math::tan_degrees(degrees) - std::tan(radians)), ulp(math::tan_degrees(degrees))) << degrees;
    const double x = everyday_double(i);
    const Long angle = std::atan(static_cast<Long>(x)) / per_degree;
    ASSERT_LE(std::abs(math::atan_degrees(x) - angle), ulp(static_cast<double>(angle))) << std::hexfloat << x;
    const double sine = in_unit_interval(i);
    const Long arc = std::asin(static_cast<Long>(sine)) / per_degree;
    ASSERT_LE(std::abs(math::asin_degrees(sine) - arc), ulp(static_cast<double>(arc))) << std::hexfloat << sine;
    const Long other_arc = std::acos(static_cast<Long>(sine)) / per_degree;
    ASSERT_LE(std::abs(math::acos_degrees(sine) - other_arc), ulp(static_cast<double>(other_arc))) << sine;
  }
}

}  // namespace
}  // namespace burin
