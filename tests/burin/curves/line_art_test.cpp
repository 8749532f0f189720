#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/base/math.hpp>

#include "line_art_support.hpp"

/// The polyline model and the boundary model against the reference: vectors G_line_art, stated moments, properties.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::drawn_lines;
using testing::DrawnLine;

constexpr double degrees_of_0_6_radians = 0.6 / math::radians_per_degree;

json g_line_art() {
  return testing::reference("curves.json")["G_line_art"];
}

json polyline_params(const json& v, int lines) {
  return {{"lines", lines},
          {"segments", {v["m"], v["m"].get<int>() + v["n"].get<int>()}},
          {"length", {v["a"], v["b"]}},
          {"turn", v["alpha"].get<double>() / math::radians_per_degree},
          {"start", v["region"]}};
}

TEST(LineArt, PolylinesAreTheReferences) {
  const json v = g_line_art()["polyline"];
  const std::vector<DrawnLine> lines =
      drawn_lines("line-art", polyline_params(v, 1000).dump(), {.seed = v["seed"].get<std::uint64_t>()});
  for (std::size_t j = 0; j < 3; ++j) {
    ASSERT_EQ(lines[j].points.size(), v["first3"][j].size());
    testing::expect_points(lines[j].points, v["first3"][j]);
  }
  std::size_t segments = 0;
  for (const DrawnLine& line : lines) segments += line.points.size() - 1;
  EXPECT_EQ(segments, v["total_segments_first_1000"].get<std::size_t>());
}

TEST(LineArt, PolylinesHoldWithinAFewBitsOfTheReference) {
  const json v = g_line_art()["polyline"];
  const std::vector<DrawnLine> lines = drawn_lines("line-art", polyline_params(v, 3).dump(), {.seed = 42});
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < lines[j].points.size(); ++i) {
      EXPECT_NEAR(lines[j].points[i].x, v["first3"][j][i][0].get<double>(), 1e-14 * 16);
      EXPECT_NEAR(lines[j].points[i].y, v["first3"][j][i][1].get<double>(), 1e-14 * 16);
    }
  }
}

TEST(LineArt, PropertiesHoldForEveryPolyline) {
  const std::vector<DrawnLine> lines =
      drawn_lines("line-art", R"({"lines": 3000, "segments": [2, 6], "length": [0.5, 2], "turn": 40})", {.seed = 5});
  std::vector<int> of_count(7);
  for (const DrawnLine& line : lines) {
    EXPECT_EQ(line.points.front(), (Vec2{0.0, 0.0}));
    ++of_count[line.points.size() - 1];
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Vec2 d = line.points[i] - line.points[i - 1];
      EXPECT_GE(length(d), 0.5 - 1e-12);
      EXPECT_LT(length(d), 2.0 + 1e-12);
      if (i < 2) continue;
      const Vec2 before = line.points[i - 1] - line.points[i - 2];
      EXPECT_LE(std::abs(math::atan2(cross(before, d), dot(before, d))), 40.0 * math::radians_per_degree + 1e-9);
    }
  }
  // Five counts, each with the chance 1/5: 600 +- 4.5 standard deviations.
  for (int count = 2; count <= 6; ++count) EXPECT_NEAR(of_count[static_cast<std::size_t>(count)], 600, 100);
}

TEST(LineArt, MomentsOfTwentyThousandPolylinesAreAsStated) {
  const json expected = g_line_art()["polyline"]["expected_end2"];
  for (const int n : {3, 5, 7}) {
    const std::string text =
        fmt::format(R"({{"lines": 20000, "segments": {}, "length": [1, 3], "turn": {}}})", n, degrees_of_0_6_radians);
    double end_squared = 0.0;
    double lengths = 0.0;
    double lengths_squared = 0.0;
    for (const DrawnLine& line : drawn_lines("line-art", text, {.seed = 7})) {
      end_squared += length_squared(line.points.back() - line.points.front());
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        const double l = distance(line.points[i - 1], line.points[i]);
        lengths += l;
        lengths_squared += l * l;
      }
    }
    const double value = expected[std::to_string(n)];
    EXPECT_NEAR(end_squared / 20000.0, value, 0.03 * value) << n;
    const double mean = lengths / (20000.0 * n);
    EXPECT_NEAR(mean, 2.0, 0.03 * 2.0);
    EXPECT_NEAR(lengths_squared / (20000.0 * n) - mean * mean, 4.0 / 12.0, 0.03 * 4.0 / 12.0);
  }
}

TEST(LineArt, BoundaryPolylinesAreTheReferences) {
  const json v = g_line_art()["boundary"];
  const json params = {{"lines", 2},       {"from", v["R0"]},      {"to", v["R1"]}, {"markers", v["alpha"]},
                       {"offset", v["B"]}, {"levels", v["levels"]}};
  const std::vector<DrawnLine> lines =
      drawn_lines("line-art-boundary", params.dump(), {.seed = v["seed"].get<std::uint64_t>()});
  for (std::size_t j = 0; j < 2; ++j) {
    ASSERT_EQ(lines[j].points.size(), v["first2"][j].size());
    for (std::size_t i = 0; i < lines[j].points.size(); ++i) {
      EXPECT_NEAR(lines[j].points[i].x, v["first2"][j][i][0].get<double>(), 1e-14 * 8);
      EXPECT_NEAR(lines[j].points[i].y, v["first2"][j][i][1].get<double>(), 1e-14 * 8);
    }
  }
}

TEST(LineArt, EveryLevelMultipliesTheSquaresByTheStatedGain) {
  const json v = g_line_art()["boundary"];
  for (const int levels : {1, 2, 3}) {
    const std::string text =
        fmt::format(R"({{"lines": 20000, "from": [0, 0], "to": [2, 0], "offset": {}, "levels": {}}})",
                    v["B"].get<double>(), levels);
    double squares = 0.0;
    for (const DrawnLine& line : drawn_lines("line-art-boundary", text, {.seed = 3})) {
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        squares += length_squared(line.points[i] - line.points[i - 1]);
      }
    }
    const double expected = 4.0 * std::pow(v["gain"].get<double>(), levels);
    EXPECT_NEAR(squares / 20000.0, expected, 0.03 * expected);
  }
}

TEST(LineArt, OffsetsAreRelativeOrAbsoluteAndDecay) {
  for (const bool absolute : {false, true}) {
    for (const int level : {1, 2}) {
      const std::string text = fmt::format(
          R"({{"lines": 500, "from": [0, 0], "to": [4, 0], "markers": [0.5], "levels": {}, "offset": 0.3, "decay": 0.5,
               "unit": "{}"}})",
          level, absolute ? "absolute" : "relative");
      double farthest = 0.0;
      for (const DrawnLine& line : drawn_lines("line-art-boundary", text)) {
        // The middles of this level's edges, from what the level made of them.
        for (std::size_t i = 1; i < line.points.size(); i += 2) {
          const Vec2 a = line.points[i - 1];
          const Vec2 b = line.points[i + 1];
          farthest = std::max(farthest, distance(line.points[i], lerp(a, b, 0.5)) / (absolute ? 1.0 : distance(a, b)));
        }
      }
      const double bound = level == 1 ? 0.3 : 0.15;
      EXPECT_LE(farthest, bound + 1e-12);
      EXPECT_GT(farthest, 0.98 * bound);
    }
  }
}

TEST(LineArt, OneMorePolylineChangesNoOther) {
  for (const auto& [family, rest] :
       {std::pair{"line-art", R"("start": {"disc": [0, 0, 1]}, "compose": {"density": 0.5})"},
        {"line-art-boundary", R"("to": [{"disc": [4, 0, 1]}, {"point": [3, 3]}])"}}) {
    const auto with = [keys = rest](int lines) { return fmt::format(R"({{"lines": {}, {}}})", lines, keys); };
    const std::vector<DrawnLine> few = drawn_lines(family, with(100), {.seed = 9});
    const std::vector<DrawnLine> more = drawn_lines(family, with(140), {.seed = 9});
    ASSERT_GT(more.size(), few.size());
    EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
  }
}

TEST(LineArt, BundlesShareTheirPlacesAndDirection) {
  const std::vector<DrawnLine> lines = drawn_lines(
      "line-art",
      R"({"starts": 20, "lines_per_start": 30, "start": [0, 0, 9, 9], "spread": 10, "segments": 3, "turn": 0})");
  ASSERT_EQ(lines.size(), 600U);
  for (std::size_t bundle = 0; bundle < 20; ++bundle) {
    const Vec2 first = lines[30 * bundle].points[1] - lines[30 * bundle].points[0];
    for (std::size_t j = 30 * bundle; j < 30 * (bundle + 1); ++j) {
      EXPECT_EQ(lines[j].points.front(), lines[30 * bundle].points.front());
      const Vec2 d = lines[j].points[1] - lines[j].points[0];
      EXPECT_LE(std::abs(math::atan2(cross(first, d), dot(first, d))), 20.0 * math::radians_per_degree);
    }
  }
  EXPECT_NE(lines[0].points.front(), lines[30].points.front());
}

TEST(LineArt, FlowIsFollowedAndPolylinesMayGrowBothWays) {
  // Circles about the origin: short steps along the tangent stay near the circle of the start.
  const std::vector<DrawnLine> lines = drawn_lines(
      "line-art",
      R"({"lines": 50, "start": {"ring": [0, 0, 1, 2]}, "segments": 41, "length": 0.01, "turn": 0, "flow": "phi + 90",
          "grow": "both"})");
  for (const DrawnLine& line : lines) {
    ASSERT_EQ(line.points.size(), 42U);
    const double start = length(line.points[20]);
    for (const Vec2 p : line.points) EXPECT_NEAR(length(p), start, 0.01 * start);
    EXPECT_GT(cross(line.points[0], line.points[1]), 0.0);
    EXPECT_GT(cross(line.points[40], line.points[41]), 0.0);
  }
}

TEST(LineArt, StretchScalesSegmentsAndEndsPolylines) {
  const std::vector<DrawnLine> lines = drawn_lines(
      "line-art", R"({"lines": 3, "segments": 10, "length": 1, "turn": 0, "heading": 0, "stretch": "0.5 - t"})");
  for (const DrawnLine& line : lines) {
    ASSERT_EQ(line.points.size(), 6U);
    EXPECT_NEAR(line.points.back().x, 0.5 + 0.4 + 0.3 + 0.2 + 0.1, 1e-12);
  }
}

TEST(LineArt, PlacesMayBePairedInOrderCrossedOrNear) {
  const std::string ends = R"("from": {"segment": [0, 0, 0, 1]}, "to": {"segment": [1, 0, 1, 1]}, "levels": 0)";
  double random = 0.0;
  double nearest = 0.0;
  for (const DrawnLine& line : drawn_lines("line-art-boundary", "{" + ends + R"(, "pairing": "ordered"})")) {
    EXPECT_EQ(line.points[0].y, line.points[1].y);
  }
  for (const DrawnLine& line : drawn_lines("line-art-boundary", "{" + ends + R"(, "pairing": "crossed"})")) {
    EXPECT_NEAR(line.points[0].y, 1.0 - line.points[1].y, 1e-15);
  }
  for (const DrawnLine& line : drawn_lines("line-art-boundary", "{" + ends + "}")) {
    random += std::abs(line.points[1].y - line.points[0].y);
  }
  for (const DrawnLine& line : drawn_lines("line-art-boundary", "{" + ends + R"(, "pairing": "nearest"})")) {
    nearest += std::abs(line.points[1].y - line.points[0].y);
  }
  EXPECT_LT(nearest, 0.25 * random);
}

TEST(LineArt, TargetsAreMetByTheirWeights) {
  int second = 0;
  for (const DrawnLine& line :
       drawn_lines("line-art-boundary",
                   R"({"lines": 4000, "to": [{"point": [1, 0]}, {"point": [2, 0]}], "weights": [3, 1]})")) {
    ASSERT_TRUE(line.points.back() == (Vec2{1.0, 0.0}) || line.points.back() == (Vec2{2.0, 0.0}));
    second += line.points.back().x == 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(second, 1000, 110);  // four standard deviations
}

TEST(LineArt, AViewShowsThePolylinesThatTouchIt) {
  const char* text = R"({"lines": 2000, "start": [0, 0, 40, 40], "compose": {"spacing": 0.05}})";
  const View view{{{10.0, 10.0}, {14.0, 14.0}}, 0.001};
  const std::vector<DrawnLine> all = drawn_lines("line-art", text);
  std::vector<DrawnLine> expected;
  for (const DrawnLine& line : all) {
    Box2 box;
    for (const Vec2 p : line.points) box.add(p);
    if (box.touches(view.box)) expected.push_back(line);
  }
  EXPECT_EQ(drawn_lines("line-art", text, {.view = view}), expected);
  EXPECT_LT(expected.size(), all.size() / 10);
  EXPECT_GT(expected.size(), 0U);
}

TEST(LineArt, GoesByThePapersSpelling) {
  EXPECT_EQ(find_family("delinger"), find_family("line-art"));
  EXPECT_EQ(find_family("delinger-boundary"), find_family("line-art-boundary"));
}

TEST(LineArt, MistakesAreExplained) {
  const auto problem = [](const char* family, const char* text) {
    const testing::ReadParams read = testing::read_params(family, text);
    EXPECT_FALSE(read.params.has_value()) << text;
    return read.problems.empty() ? std::string() : read.problems.front().message;
  };
  EXPECT_EQ(problem("line-art", R"({"segments": [9, 3]})"),
            "'segments': a range is [low, high]: the first number is the greater one");
  EXPECT_EQ(problem("line-art", R"({"segments": 0})"), "a polyline has 1 to 100000 segments");
  EXPECT_EQ(problem("line-art", R"({"lines": 4, "starts": 3})"),
            "'lines' and 'starts' are given: the lines are starts x lines_per_start");
  EXPECT_EQ(problem("line-art", R"({"start": [1, 2, 3]})"),
            "'start': a region is [x, y], [x0, y0, x1, y1] or a table, found a list of 3");
  EXPECT_EQ(problem("line-art", R"({"start": {"disc": [0, 0, 0]}})"),
            "'start': a ring's radii are 0 <= inner < outer, found 0 and 0");
  EXPECT_EQ(
      problem("line-art", R"({"start": {"disc": [0, 0, 1], "point": [0, 0]}})"),
      "'start': a region needs exactly one of 'point', 'segment', 'rectangle', 'disc', 'ring', 'polygon', 'along' "
      "and 'points'");
  EXPECT_EQ(problem("line-art", R"({"start": {"disc": [1e13, 0, 1]}})"), "'start': the region reaches beyond 1e12");
  EXPECT_EQ(problem("line-art", R"({"compose": {"inside": [0, 0]}})"),
            "'compose': must have an inside: a rectangle, disc, ring or polygon");
  EXPECT_EQ(problem("line-art", R"({"compose": {"tone": 0.2}})"),
            "'compose': 'tone' needs 'pen_width', the width of the pen in model units");
  EXPECT_EQ(problem("line-art-boundary", R"({"markers": [0.5, 0.5]})"), "markers ascend between 0 and 1; 0.5 does not");
  EXPECT_EQ(problem("line-art-boundary", R"({"weights": [1, 2]})"), "1 regions in 'to' need as many weights, found 2");
  EXPECT_EQ(problem("line-art-boundary", R"({"levels": 12, "markers": [0.2, 0.4, 0.6]})"),
            "a polyline would have 16,777,216 points, and 1,048,576 are the most; lower 'levels' or 'smooth_levels'");
}

}  // namespace
}  // namespace burin::curves
