#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/base_shape.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::curves {
namespace {

using testing::read_params;
using testing::two_point;

BaseShape base(const std::string& json) {
  return two_point(R"({"base": )" + json + "}").base;
}

TEST(BaseShape, NamedShapesRunCounterClockwise) {
  for (const char* shape :
       {R"("triangle")", R"("square")", R"({"shape": "ngon", "n": 7})", R"({"shape": "star", "n": 5, "inner": 0.4})"}) {
    const BaseShape read = base(shape);
    ASSERT_EQ(read.polylines.size(), 1U);
    EXPECT_TRUE(read.polylines[0].closed);
    double area = 0.0;
    for (std::size_t e = 0; e < read.edge_count(); ++e) {
      area += 0.5 * cross(read.polylines[0].edge_begin(e), read.polylines[0].edge_end(e));
    }
    EXPECT_GT(area, 0.0) << shape;
  }
  EXPECT_EQ(base(R"("segment")").polylines[0].points, (std::vector<Vec2>{{0, 0}, {1, 0}}));
  EXPECT_EQ(base(R"({"shape": "ngon", "n": 6})").polylines[0].points.size(), 6U);
  EXPECT_EQ(base(R"({"shape": "star", "n": 6})").polylines[0].points.size(), 12U);
  EXPECT_EQ(base(R"({"shape": "ngon", "n": 4})").polylines[0].points[0], (Vec2{0, 1}));
}

TEST(BaseShape, PointsMayBeExpressionsAndRepeatTheirFirst) {
  const BaseShape read = base(R"j({"points": [[0, 0], ["sqrt(4)", 0], [1, 1], [0, 0]], "closed": true})j");
  EXPECT_EQ(read.polylines[0].points, (std::vector<Vec2>{{0, 0}, {2, 0}, {1, 1}}));
  EXPECT_EQ(base(R"({"points": [[0, 0], [2, 0]]})").polylines[0].closed, false);
}

TEST(BaseShape, PathsTurnYUpAndKeepTheirClosing) {
  const BaseShape read = base(R"({"path": "M0 0 L2 0 L2 1 Z M5 5 H7"})");
  ASSERT_EQ(read.polylines.size(), 2U);
  EXPECT_EQ(read.polylines[0].points, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, -1}}));
  EXPECT_TRUE(read.polylines[0].closed);
  EXPECT_FALSE(read.polylines[1].closed);
  EXPECT_EQ(read.edge_count(), 4U);
}

TEST(BaseShape, FilesAreReadByTheReaderGiven) {
  const ReadFile files = [](std::string_view name) -> Result<std::string> {
    if (name == "coast.csv") return std::string("x,y\n0,0\n1,0\n1,1\n");
    return Problem{{}, "cannot read '" + std::string(name) + "': no such file"};
  };
  const testing::ReadParams read = read_params("two-point", R"({"base": {"csv": "coast.csv", "closed": true}})", files);
  ASSERT_TRUE(read.params.has_value()) << problems_text(read.problems);
  EXPECT_EQ(std::any_cast<TwoPointParams>(*read.params).base.polylines[0].points.size(), 3U);
  const testing::ReadParams missing = read_params("two-point", R"({"base": {"csv": "cost.csv"}})", files);
  ASSERT_EQ(missing.problems.size(), 1U);
  EXPECT_NE(missing.problems[0].message.find("no such file"), std::string::npos);
}

TEST(BaseShape, AnotherCurveIsABase) {
  const std::string koch = R"({"family": "two-point", "levels": 2, "base": "triangle"})";
  const BaseShape read = base(R"({"curve": )" + koch + "}");
  ASSERT_EQ(read.polylines.size(), 1U);
  EXPECT_TRUE(read.polylines[0].closed);
  EXPECT_EQ(read.polylines[0].points, testing::draw_points(two_point(R"({"levels": 2, "base": "triangle"})")));
  // Two levels of it refined twice are four.
  const std::vector<Vec2> four = testing::draw_points(two_point(R"({"levels": 4, "base": "triangle"})"));
  const std::vector<Vec2> again = testing::draw_points(two_point(R"({"levels": 2, "base": {"curve": )" + koch + "}}"));
  ASSERT_EQ(again.size(), four.size());
  for (std::size_t i = 0; i < four.size(); ++i) EXPECT_LT(distance(again[i], four[i]), 1e-14);
}

TEST(BaseShape, ARandomCurveHasASeedOfItsOwn) {
  const auto random = [](const std::string& seed) {
    return base(R"({"curve": {"family": "two-point", "levels": 3, "motif": {"marks": [[0.5, {"random": [-1, 1]}]]})" +
                seed + "}}")
        .polylines[0]
        .points;
  };
  EXPECT_EQ(random(""), random(R"(, "seed": 0)"));
  EXPECT_EQ(random(R"(, "seed": 7)"), random(R"(, "seed": 7)"));
  EXPECT_NE(random(R"(, "seed": 7)"), random(R"(, "seed": 8)"));
}

TEST(BaseShape, MistakesAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("sqare")", "did you mean 'square'?"},
      {R"({})", "exactly one of 'shape', 'points', 'csv', 'path' and 'curve'"},
      {R"({"points": []})", "exactly one of"},
      {R"({"points": [[1, 1]]})", "at least 2 points, found 1"},
      {R"({"points": [[1, 1], [2]]})", "a point [x, y]"},
      {R"({"points": [[1, 1], [2, "1/0"]]})", ""},
      {R"({"shape": "ngon", "n": 1})", "'n' = 1 is outside [2, 10000]"},
      {R"({"shape": "star", "inner": 0})", "'inner' = 0 is outside (0, inf)"},
      {R"({"path": ""})", ""},
      {R"({"path": "M0 0"})", "draws no line"},
      {R"({"path": "M0 0 L"})", ""},
      {R"(3)", "expected a base"},
      {R"({"curve": "koch"})", "a curve: { family"},
      {R"({"curve": {"levels": 2}})", "needs a 'family'"},
      {R"({"curve": {"family": "two-piont"}})", "did you mean 'two-point'?"},
      {R"({"curve": {"family": "two-point", "level": 2}})", "did you mean 'levels'?"},
      {R"({"curve": {"family": "two-point", "levels": 11}})", "at most a million points of a curve; lower 'levels'"},
  };
  for (const auto& [json, expected] : cases) {
    const testing::ReadParams read = read_params("two-point", R"({"base": )" + std::string(json) + "}");
    ASSERT_FALSE(read.problems.empty()) << json;
    EXPECT_NE(read.problems.front().message.find(expected), std::string::npos) << json << '\n'
                                                                               << read.problems.front().message;
  }
}

}  // namespace
}  // namespace burin::curves
