#include <random>

#include <gtest/gtest.h>

#include <burin/data/svg_path.hpp>

namespace burin::data {
namespace {

using Points = std::vector<Vec2>;

std::vector<Subpath> subpaths(std::string_view d, double tolerance = 0.01) {
  auto parsed = parse_svg_path(d, tolerance, {});
  EXPECT_TRUE(parsed.ok()) << d << ": " << (parsed.ok() ? "" : problems_text(parsed.problems()));
  return parsed.ok() ? *std::move(parsed) : std::vector<Subpath>{};
}

Points points(std::string_view d, double tolerance = 0.01) {
  const auto all = subpaths(d, tolerance);
  EXPECT_EQ(all.size(), 1U) << d;
  return all.empty() ? Points{} : all.front().points;
}

Problem problem(std::string_view d) {
  const auto parsed = parse_svg_path(d, 0.01, {"f.svg", 7, 10});
  EXPECT_FALSE(parsed.ok()) << d;
  return parsed.ok() ? Problem{} : parsed.problems().front();
}

/// The offset of the fault, told by the column.
int offset(std::string_view d) {
  return problem(d).where.column - 10;
}

TEST(SvgPath, LinesAbsoluteAndRelative) {
  EXPECT_EQ(points("M1 2L3 4H5V6"), (Points{{1, 2}, {3, 4}, {5, 4}, {5, 6}}));
  EXPECT_EQ(points("m1 2l3 4h5v6"), (Points{{1, 2}, {4, 6}, {9, 6}, {9, 12}}));
  EXPECT_EQ(points(" \n M 1 , 2 \t L 3 , 4 , 5 , 6 \r\n"), (Points{{1, 2}, {3, 4}, {5, 6}}));
}

TEST(SvgPath, ArgumentsRepeatTheCommandAndMovetoBecomesLineto) {
  EXPECT_EQ(points("M0 0 1 2 3 4"), (Points{{0, 0}, {1, 2}, {3, 4}}));
  EXPECT_EQ(points("m1 1 1 2 3 4"), (Points{{1, 1}, {2, 3}, {5, 7}}));
  EXPECT_EQ(points("M0 0H1 2 3"), (Points{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
}

TEST(SvgPath, NumbersNeedNoSeparators) {
  EXPECT_EQ(points("M.5.5-1e-3.25L+1-2"), (Points{{.5, .5}, {-1e-3, .25}, {1, -2}}));
  EXPECT_EQ(points("M1.-2.L1e2-1E+1"), (Points{{1, -2}, {100, -10}}));
  EXPECT_EQ(points("M00 007L1.5.25"), (Points{{0, 7}, {1.5, .25}}));
}

TEST(SvgPath, ArcFlagsNeedNoSeparators) {
  for (const std::string_view d :
       {"M0 0a1 1 0 01.5.5", "M0 0a1 1 0 0 1 .5 .5", "M0 0a1,1,0,0,1,.5,.5", "M0 0a1 1 0 0,1.5.5"}) {
    EXPECT_EQ(points(d), points("M0 0 A 1 1 0 0 1 0.5 0.5")) << d;
  }
  EXPECT_EQ(points("M0 0a1 1 0 1110 1"), points("M0 0 A 1 1 0 1 1 10 1"));
}

TEST(SvgPath, ClosingReturnsToTheStartWithoutRepeatingIt) {
  const auto closed = subpaths("M1 1h2v2z");
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_TRUE(closed[0].closed);
  EXPECT_EQ(closed[0].points, (Points{{1, 1}, {3, 1}, {3, 3}}));
  EXPECT_EQ(subpaths("M1 1h2v2L1 1z")[0].points, closed[0].points);
  EXPECT_FALSE(subpaths("M1 1h2v2L1 1")[0].closed);
}

TEST(SvgPath, AfterZTheNextSubpathBeginsWhereTheLastBegan) {
  const auto both = subpaths("m1 1h2v2z l5 5 Z m1 0 l1 1");
  ASSERT_EQ(both.size(), 3U);
  EXPECT_EQ(both[1].points, (Points{{1, 1}, {6, 6}}));
  EXPECT_TRUE(both[1].closed);
  EXPECT_EQ(both[2].points, (Points{{2, 1}, {3, 2}}));
  EXPECT_FALSE(both[2].closed);
}

TEST(SvgPath, EveryMovetoBeginsASubpathAndALoneOneDrawsNothing) {
  EXPECT_EQ(subpaths("M0 0L1 1M5 5L6 6").size(), 2U);
  EXPECT_EQ(subpaths("M0 0M9 9L1 1M5 5").size(), 1U);
  EXPECT_TRUE(subpaths("").empty());
  EXPECT_TRUE(subpaths("  ").empty());
  EXPECT_TRUE(subpaths("M3 3").empty());
  EXPECT_TRUE(subpaths("M3 3Z").empty());
  EXPECT_EQ(points("M3 3h0"), (Points{{3, 3}, {3, 3}})) << "a dot";
}

TEST(SvgPath, SmoothCurvesMirrorTheLastControlPoint) {
  EXPECT_EQ(points("M0 0C0 1 1 1 1 0S2-1 2 0"), points("M0 0C0 1 1 1 1 0C1-1 2-1 2 0"));
  EXPECT_EQ(points("m0 0c0 1 1 1 1 0s1-1 1 0"), points("M0 0C0 1 1 1 1 0C1-1 2-1 2 0"));
  EXPECT_EQ(points("M0 0Q1 1 2 0T4 0 6 0"), points("M0 0Q1 1 2 0Q3-1 4 0Q5 1 6 0"));
  EXPECT_EQ(points("m0 0q1 1 2 0t2 0"), points("M0 0Q1 1 2 0Q3-1 4 0"));
}

TEST(SvgPath, SmoothCurvesAfterAnotherKindHaveNothingToMirror) {
  EXPECT_EQ(points("M0 0L1 0S2 1 3 0"), points("M0 0L1 0C1 0 2 1 3 0"));
  EXPECT_EQ(points("M0 0L1 0T3 0"), points("M0 0L1 0Q1 0 3 0"));
  EXPECT_EQ(points("M0 0Q1 1 2 0S3 1 4 0"), points("M0 0Q1 1 2 0C2 0 3 1 4 0"));
  EXPECT_EQ(points("M0 0C0 1 1 1 2 0T4 1"), points("M0 0C0 1 1 1 2 0Q2 0 4 1"));
}

TEST(SvgPath, AFaultHasItsExactOffset) {
  EXPECT_EQ(offset("L0 0"), 0);
  EXPECT_EQ(offset("  L0 0"), 2);
  EXPECT_EQ(offset("M0 0X1 1"), 4);
  EXPECT_EQ(offset("M0 0L1"), 6);
  EXPECT_EQ(offset("M0 0L1 ?"), 7);
  EXPECT_EQ(offset("M,0 0"), 1);
  EXPECT_EQ(offset("M0,,0"), 3);
  EXPECT_EQ(offset("M0 0,"), 5);
  EXPECT_EQ(offset("M0 0L1 1,Z"), 9);
  EXPECT_EQ(offset("M0 0a1 1 0 2 1 5 5"), 11);
  EXPECT_EQ(offset("M0 0Z1 1"), 5);
  EXPECT_EQ(offset("M0 0L1 1e"), 8);
  EXPECT_EQ(offset("M0 0L1 --1"), 7);
  EXPECT_EQ(offset("M0 0L1 +-1"), 7);
  EXPECT_EQ(offset("M0 0Lnan 1"), 5);
  EXPECT_EQ(offset("M0 0L.,1"), 5);
  EXPECT_EQ(offset(std::string_view("M0 0\0L1 1", 9)), 4);
  EXPECT_EQ(offset("M0 0L1 1\xC3\xA9"), 8);
  EXPECT_EQ(problem("M0 0X1 1").where.line, 7);
  EXPECT_NE(problem("M0 0X1 1").message.find("character 5"), std::string::npos);
}

TEST(SvgPath, NumbersOutsideTheRangeAreRefused) {
  EXPECT_EQ(offset("M0 0L1e13 1"), 5);
  EXPECT_EQ(offset("M0 0L1e999 1"), 5);
  EXPECT_FALSE(parse_svg_path("M9e11 0l9e11 0", 0.1, {}).ok()) << "the sum is outside";
}

TEST(SvgPath, CommandsAreCapped) {
  std::string d = "M0 0";
  for (int i = 1; i < 65'536; ++i) d += "h1";
  EXPECT_EQ(points(d).size(), 65'536U);
  EXPECT_EQ(problem(d + "h1").trouble, Trouble::limit);
  EXPECT_EQ(problem("M0 0" + std::string(70'000, 'z')).trouble, Trouble::limit);
  std::string repeated = "M0 0L";
  for (int i = 0; i < 65'536; ++i) repeated += " 1 1";
  EXPECT_EQ(problem(repeated).trouble, Trouble::limit) << "implicit commands count";
}

TEST(SvgPath, PointsAreCappedWhateverTheTolerance) {
  std::string d = "M0 0";
  for (int i = 0; i < 2000; ++i) d += "c1e9 0 0 1e9 1 1";
  for (const double tolerance : {0.0, 1e-300}) {
    const auto parsed = parse_svg_path(d, tolerance, {});
    ASSERT_FALSE(parsed.ok());
    EXPECT_EQ(parsed.problems().front().trouble, Trouble::limit);
  }
  EXPECT_TRUE(parse_svg_path(d, 1e9, {}).ok());
}

TEST(SvgPath, NoiseNeverBreaksIt) {
  constexpr std::string_view letters = "MmLlHhVvCcSsQqTtAaZz0123456789+-.eE, ,0011 \n#";
  std::mt19937_64 random(11);
  for (int n = 0; n < 20'000; ++n) {
    std::string d = "M0 0";
    for (std::uint64_t length = random() % 60; length > 0; --length) d += letters[random() % letters.size()];
    const auto parsed = parse_svg_path(d, 0.1, {});
    if (!parsed.ok()) continue;
    for (const Subpath& subpath : *parsed) {
      ASSERT_FALSE(subpath.points.empty()) << d;
      for (const Vec2 p : subpath.points) ASSERT_TRUE(is_finite(p)) << d;
    }
  }
}

}  // namespace
}  // namespace burin::data
