#include <limits>

#include "placing_support.hpp"

namespace burin::primitives {
namespace {

PositionValues at_x(double x, double y = 0.0) {
  PositionValues values{};
  values[0] = x;
  values[1] = y;
  return values;
}

TEST(Choice, ReferencesThresholdsOfXPlusY) {
  const Choice<std::string> use = spec(R"({"use": {"by": "x+y", "at": [0, 1], "of": ["a", "b", "c"]}})").use;
  const auto expected = testing::reference("curves.json")["H_placement"]["choose_x_plus_y_thresholds_0_1"];
  const double xs[] = {-1, 0, 0.5, 1, 2};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(use.pick(at_x(xs[i])), expected[i].get<std::size_t>());
}

TEST(Choice, BandsAreHalfOpenAndNanFallsIntoTheFirst) {
  const Choice<std::string> use = spec(R"({"use": {"by": "x/y", "at": [1, 2], "of": ["a", "b", "c"]}})").use;
  EXPECT_EQ(use.pick(at_x(1, 1)), 1U);
  EXPECT_EQ(use.pick(at_x(std::nextafter(1.0, 0.0), 1)), 0U);
  EXPECT_EQ(use.pick(at_x(2, 1)), 2U);
  EXPECT_EQ(use.pick(at_x(0, 0)), 0U);
  EXPECT_EQ(use.pick(at_x(1, 0)), 2U);
}

TEST(Choice, AListTakesTurns) {
  Choice<std::string> use = spec(R"({"use": ["a", "b", "c"]})").use;
  PositionValues values{};
  for (std::size_t i = 0; i < 7; ++i) {
    values[position_variable("index")] = static_cast<double>(i);
    EXPECT_EQ(use.pick(values), i % 3);
  }
  use.first = 2.0;
  values[position_variable("index")] = 1.0;
  EXPECT_EQ(use.pick(values), 2U);
  use.first = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(use.pick(values), 0U);
}

TEST(Choice, NumbersAreWrittenInManyWays) {
  const auto scale_at = [](const std::string& json, double x) {
    const PlacingSpec read = spec(R"({"use": "a", "scale": )" + json + "}");
    return read.scale.of[read.scale.pick(at_x(x))].value(at_x(x));
  };
  EXPECT_EQ(scale_at("3", 0), 3.0);
  EXPECT_EQ(scale_at(R"("1cm")", 0), 10.0);
  EXPECT_EQ(scale_at(R"("2*x + 1")", 4), 9.0);
  EXPECT_EQ(scale_at(R"("px")", 4), 0.0);  // the variable, no unit
  EXPECT_EQ(scale_at(R"({"by": "x", "at": [1], "of": ["2mm", "x^2"]})", 0.5), 2.0);
  EXPECT_EQ(scale_at(R"({"by": "x", "at": [1], "of": ["2mm", "x^2"]})", 3), 9.0);
  EXPECT_EQ(scale_at(R"(["1mm", "2mm"])", 0), 1.0);
}

TEST(Choice, SaysWhatIsWrong) {
  EXPECT_EQ(complaint(R"({"use": 3})"), "'use': expected a text, found a whole number");
  EXPECT_EQ(complaint(R"({"use": []})"), "'use': the list is empty: there is nothing to choose from");
  EXPECT_EQ(complaint(R"({"use": {"by": "x", "at": [1]}})"),
            "'use': bands need 'of': { by = \"f(x,y)\", at = [...], of = [...] }");
  EXPECT_EQ(complaint(R"({"use": {"at": [1], "of": ["a", "b"]}})"),
            "'use': bands need 'by': { by = \"f(x,y)\", at = [...], of = [...] }");
  EXPECT_EQ(complaint(R"({"use": {"by": "x", "at": [1], "of": ["a"]}})"),
            "'use': 1 bounds in 'at' need 2 in 'of', found 1");
  EXPECT_EQ(complaint(R"({"use": {"by": "x", "at": [1, 1], "of": ["a", "b", "c"]}})"),
            "'use': bounds must ascend: 1 does not follow 1");
  EXPECT_EQ(complaint(R"({"use": {"by": "tangnet", "at": [1], "of": ["a", "b"]}})"),
            "'use': unknown name 'tangnet'; did you mean 'tangent'?");
  EXPECT_EQ(complaint(R"({"use": "a", "scale": "4 furlongs"})"),
            "'scale': an operator is missing before 'furlongs'; a product is written with '*'");
}

}  // namespace
}  // namespace burin::primitives
