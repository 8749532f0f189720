#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/geom/vec3.hpp>

#include "line_art_support.hpp"

/// Line art in space: the moments that curves.md G.3 states, regions, and what the plane's models promise too.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::drawn_lines;
using testing::DrawnLine;

/// The polylines in space: seen from above and from the front, put together.
std::vector<std::vector<Vec3>> space_lines(const std::string& family, json params, std::uint64_t seed = 0) {
  params["camera"] = {{"eye", {0, 0, 1}}};
  const std::vector<DrawnLine> above = drawn_lines(family, params.dump(), {.seed = seed});
  params["camera"] = {{"eye", {0, -1, 0}}};
  const std::vector<DrawnLine> front = drawn_lines(family, params.dump(), {.seed = seed});
  EXPECT_EQ(above.size(), front.size());
  std::vector<std::vector<Vec3>> lines(std::min(above.size(), front.size()));
  for (std::size_t j = 0; j < lines.size(); ++j) {
    for (std::size_t i = 0; i < above[j].points.size(); ++i) {
      lines[j].push_back({above[j].points[i].x, above[j].points[i].y, front[j].points[i].y});
    }
  }
  return lines;
}

/// Holds shares that should be uniform in [0, 1) to that: chi-squared of 20 bins, 99.99 %.
void expect_uniform(const std::vector<double>& shares, const char* what) {
  std::array<double, 20> bins{};
  for (const double share : shares) {
    ASSERT_GE(share, -1e-9) << what;
    ASSERT_LE(share, 1.0 + 1e-9) << what;
    bins[std::min<std::size_t>(static_cast<std::size_t>(std::max(share, 0.0) * 20.0), 19)] += 1.0;
  }
  const double expected = static_cast<double>(shares.size()) / 20.0;
  double chi_squared = 0.0;
  for (const double count : bins) chi_squared += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_squared, 50.8) << what;
}

TEST(LineArt3d, MomentsOfTwentyThousandPolylinesAreAsStated) {
  const json expected = testing::reference("curves.json")["G_line_art"]["polyline"]["expected_end2"];
  for (const int n : {3, 5, 7}) {
    const json params = {
        {"lines", 20000}, {"segments", n}, {"length", {1, 3}}, {"turn", 0.6 / math::radians_per_degree}};
    double end_squared = 0.0;
    double lengths = 0.0;
    double lengths_squared = 0.0;
    for (const std::vector<Vec3>& line : space_lines("line-art-3d", params, 7)) {
      ASSERT_EQ(line.size(), static_cast<std::size_t>(n) + 1);
      end_squared += length_squared(line.back() - line.front());
      for (std::size_t i = 1; i < line.size(); ++i) {
        const double l = distance(line[i - 1], line[i]);
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

TEST(LineArt3d, HeadingsAreUniformAndTurnsGoAnyWay) {
  const json params = {{"lines", 20000}, {"segments", 2}, {"length", 1}, {"turn", 50}};
  std::vector<double> heights;
  std::vector<double> azimuths;
  std::vector<double> turns;
  double forward = 0.0;
  for (const std::vector<Vec3>& line : space_lines("line-art-3d", params, 3)) {
    const Vec3 first = line[1] - line[0];
    const Vec3 second = line[2] - line[1];
    EXPECT_NEAR(length(first), 1.0, 1e-12);
    heights.push_back(0.5 + 0.5 * first.z);
    azimuths.push_back(0.5 + math::atan2(first.y, first.x) / math::tau);
    turns.push_back(std::acos(std::clamp(dot(first, second), -1.0, 1.0)) / (50 * math::radians_per_degree));
    forward += dot(first, second);
  }
  expect_uniform(heights, "heights of headings");
  expect_uniform(azimuths, "azimuths of headings");
  expect_uniform(turns, "turns");
  const double angle = 50 * math::radians_per_degree;
  EXPECT_NEAR(forward / 20000.0, std::sin(angle) / angle, 0.03 * std::sin(angle) / angle);
}

TEST(LineArt3d, AHeadingMayBeGivenWithASpread) {
  const json params = {{"lines", 500}, {"segments", 1}, {"length", 1}, {"heading", {0, 3, 4}}, {"spread", 20}};
  double widest = 0.0;
  for (const std::vector<Vec3>& line : space_lines("line-art-3d", params)) {
    const double off = std::acos(std::min(1.0, dot(line[1] - line[0], Vec3{0, 0.6, 0.8})));
    widest = std::max(widest, off / math::radians_per_degree);
  }
  EXPECT_LE(widest, 20.0 + 1e-6);
  EXPECT_GT(widest, 19.0);
}

TEST(LineArt3d, EveryLevelMultipliesTheSquaresByTheStatedGain) {
  const json v = testing::reference("curves.json")["G_line_art"]["boundary"];
  for (const int levels : {1, 2, 3}) {
    const json params = {
        {"lines", 20000}, {"from", {0, 0, 0}}, {"to", {1, 1, std::sqrt(2.0)}}, {"offset", v["B"]}, {"levels", levels}};
    double squares = 0.0;
    for (const std::vector<Vec3>& line : space_lines("line-art-boundary-3d", params, 3)) {
      for (std::size_t i = 1; i < line.size(); ++i) squares += length_squared(line[i] - line[i - 1]);
    }
    const double expected = 4.0 * std::pow(v["gain"].get<double>(), levels);
    EXPECT_NEAR(squares / 20000.0, expected, 0.03 * expected);
  }
}

TEST(LineArt3d, OffsetsGoAcrossInEveryDirection) {
  const json params = {{"lines", 20000}, {"from", {0, 0, 0}}, {"to", {0, 0, 2}},
                       {"offset", 0.3},  {"levels", 1},       {"markers", {0.25}}};
  std::vector<double> azimuths;
  std::vector<double> offsets;
  for (const std::vector<Vec3>& line : space_lines("line-art-boundary-3d", params, 5)) {
    ASSERT_EQ(line.size(), 3U);
    EXPECT_EQ(line[0], (Vec3{0, 0, 0}));
    EXPECT_EQ(line[2], (Vec3{0, 0, 2}));
    EXPECT_NEAR(line[1].z, 0.5, 1e-12);
    azimuths.push_back(0.5 + math::atan2(line[1].y, line[1].x) / math::tau);
    offsets.push_back(length(Vec2{line[1].x, line[1].y}) / 0.6);
  }
  expect_uniform(azimuths, "azimuths of offsets");
  expect_uniform(offsets, "offsets");
}

/// The starts of 20000 lines in a region.
std::vector<Vec3> places(const json& region, const char* order = "random") {
  std::vector<Vec3> starts;
  const json params = {{"lines", 20000}, {"start", region}, {"segments", 1}, {"length", 1}, {"places", order}};
  for (const std::vector<Vec3>& line : space_lines("line-art-3d", params, 11)) starts.push_back(line.front());
  return starts;
}

std::vector<double> shares(const std::vector<Vec3>& points, const auto& share) {
  std::vector<double> all;
  for (const Vec3 p : points) all.push_back(share(p));
  return all;
}

TEST(LineArt3d, PlacesAreUniformInTheirRegions) {
  const std::vector<Vec3> box = places({{"box", {-1, 0, 2, 1, 4, 3}}});
  expect_uniform(shares(box, [](Vec3 p) { return 0.5 + 0.5 * p.x; }), "box x");
  expect_uniform(shares(box, [](Vec3 p) { return 0.25 * p.y; }), "box y");
  expect_uniform(shares(box, [](Vec3 p) { return p.z - 2.0; }), "box z");
  const auto azimuth = [](Vec3 p) { return 0.5 + math::atan2(p.y - 1.0, p.x) / math::tau; };
  for (const char* order : {"random", "even", "steps"}) {
    const std::vector<Vec3> ball = places({{"ball", {0, 1, 0, 2}}}, order);
    const auto radius = [](Vec3 p) { return std::pow(distance(p, {0, 1, 0}) / 2.0, 3.0); };
    expect_uniform(shares(ball, radius), "ball");
    expect_uniform(shares(ball, [&](Vec3 p) { return 0.5 + 0.5 * p.z / distance(p, {0, 1, 0}); }), "ball, heights");
    expect_uniform(shares(ball, azimuth), "ball, azimuths");
    const std::vector<Vec3> sphere = places({{"sphere", {0, 1, 0, 2}}}, order);
    for (const Vec3 p : sphere) EXPECT_NEAR(distance(p, {0, 1, 0}), 2.0, 1e-12);
    expect_uniform(shares(sphere, [](Vec3 p) { return 0.5 + 0.25 * p.z; }), "sphere, heights");
    expect_uniform(shares(sphere, azimuth), "sphere, azimuths");
  }
  const std::vector<Vec3> segment = places({{"segment", {0, 0, 0, 1, 2, 3}}});
  for (const Vec3 p : segment) EXPECT_NEAR(distance(p, p.x * Vec3{1, 2, 3}), 0.0, 1e-12);
  expect_uniform(shares(segment, [](Vec3 p) { return p.x; }), "segment");
}

TEST(LineArt3d, PlacesAreUniformInPolygonsAndAlongLines) {
  // A parallelogram in a slanted plane, p = a + u (1, 0, 1) + v (0, 2, 0).
  const std::vector<Vec3> polygon = places({{"polygon", {{"points", {{1, 1, 1}, {2, 1, 2}, {2, 3, 2}, {1, 3, 1}}}}}});
  for (const Vec3 p : polygon) EXPECT_NEAR(p.z, p.x, 1e-12);
  expect_uniform(shares(polygon, [](Vec3 p) { return p.x - 1.0; }), "polygon u");
  expect_uniform(shares(polygon, [](Vec3 p) { return 0.5 * (p.y - 1.0); }), "polygon v");
  // A line of lengths 1, 2 and 3.
  const std::vector<Vec3> track = places({{"along", {{"points", {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 3}}}}}});
  expect_uniform(shares(track, [](Vec3 p) { return (p.x + p.y + p.z) / 6.0; }), "along");
}

TEST(LineArt3d, OneMorePolylineChangesNoOther) {
  for (const auto& [family, rest] :
       {std::pair{"line-art-3d", R"("start": {"ball": [0, 0, 0, 1]}, "compose": {"density": 0.5})"},
        {"line-art-boundary-3d", R"("to": [{"sphere": [4, 0, 0, 1]}, {"point": [3, 3, 3]}])"}}) {
    const auto with = [keys = rest](int lines) { return fmt::format(R"({{"lines": {}, {}}})", lines, keys); };
    const std::vector<DrawnLine> few = drawn_lines(family, with(100), {.seed = 9});
    const std::vector<DrawnLine> more = drawn_lines(family, with(140), {.seed = 9});
    ASSERT_GT(more.size(), few.size());
    EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
  }
}

TEST(LineArt3d, EndsArePairedAsInThePlane) {
  const json knot = {{"along", {{"knot", {2, 3}}, {"n", 60}}}};
  const json params = {{"lines", 50}, {"from", knot}, {"to", knot}, {"pairing", "ordered"}, {"levels", 0}};
  for (const std::vector<Vec3>& line : space_lines("line-art-boundary-3d", params)) EXPECT_EQ(line[0], line[1]);
  int second = 0;
  const json weighted = {
      {"lines", 4000}, {"to", {{{"point", {1, 0, 0}}}, {{"point", {2, 0, 0}}}}}, {"weights", {3, 1}}};
  for (const std::vector<Vec3>& line : space_lines("line-art-boundary-3d", weighted)) {
    ASSERT_TRUE(line.back() == (Vec3{1, 0, 0}) || line.back() == (Vec3{2, 0, 0}));
    second += line.back().x == 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(second, 1000, 110);
}

TEST(LineArt3d, KindsAndDensityGoByDepth) {
  const std::string text = R"({"lines": 400, "start": {"box": [-1, -1, -1, 1, 1, 1]}, "segments": 1, "length": 0,
      "camera": {"eye": [0, -5, 0], "target": [0, 0.5, 0]}, "compose": {"kind": "depth > 0", "density": "depth < 0.2"}})";
  std::string above = text;
  above.replace(above.find("[0, -5, 0]"), 10, "[0, 0.5, 9]");
  above.replace(above.find("depth > 0"), 9, "0 * rand");
  above.replace(above.find("depth < 0.2"), 11, "2");
  const std::vector<DrawnLine> all = drawn_lines("line-art-3d", above, {.seed = 4});
  std::vector<int> kinds;
  for (const DrawnLine& line : all) {
    // Seen from above, y of the place is its depth in the other picture.
    const double depth = line.points.front().y;
    if (depth < 0.2) kinds.push_back(depth > 0.0 ? 1 : 0);
  }
  const std::vector<DrawnLine> lines = drawn_lines("line-art-3d", text, {.seed = 4});
  ASSERT_EQ(lines.size(), kinds.size());
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].level, kinds[i]);
}

TEST(LineArt3d, LinesEndWhereTheyComeBehindTheEye) {
  const char* rising =
      R"({"lines": 5, "start": [0, 0, 0], "segments": 10, "length": 1, "turn": 0, "heading": [0, 0.3, 1],
      "camera": {"projection": "perspective", "eye": [0, 0, 5.5], "up": [0, 1, 0]}})";
  for (const DrawnLine& line : drawn_lines("line-art-3d", rising)) EXPECT_EQ(line.points.size(), 6U);
  const char* through = R"({"lines": 40, "from": [0, 0, 0], "to": [[0, 1, 9], [0, 1, 1]], "weights": [1, 1],
      "camera": {"projection": "perspective", "eye": [0, 0, 5.5], "up": [0, 1, 0]}})";
  const std::size_t drawn = drawn_lines("line-art-boundary-3d", through).size();
  EXPECT_GT(drawn, 10U);
  EXPECT_LT(drawn, 30U);
}

TEST(LineArt3d, MistakesAreExplained) {
  const auto problem = [](const char* family, const char* text) {
    const testing::ReadParams read = testing::read_params(family, text);
    EXPECT_FALSE(read.params.has_value()) << text;
    return read.problems.empty() ? std::string() : read.problems.front().message;
  };
  EXPECT_EQ(problem("line-art-3d", R"({"start": [0, 0]})"), "'start': expected a point [x, y, z], found a list of 2");
  EXPECT_EQ(problem("line-art-3d", R"({"start": {"ball": [0, 0, 0, 0]}})"), "'start': a radius is above 0, found 0");
  EXPECT_EQ(problem("line-art-3d", R"({"start": {}})"),
            "'start': a region in space needs exactly one of 'point', 'segment', 'box', 'ball', 'sphere', 'polygon' "
            "and 'along'");
  EXPECT_EQ(problem("line-art-3d", R"({"start": {"polygon": {"points": [[0,0,0],[1,0,0],[1,1,0],[0,1,1]]}}})"),
            "'start': the points of the polygon do not lie in one plane");
  EXPECT_EQ(problem("line-art-3d", R"({"heading": [0, 0, 0]})"), "'heading' is a direction; [0, 0, 0] is none");
  EXPECT_EQ(problem("line-art-3d", R"({"spread": 4})"), "'spread' is about 'heading', which is missing");
  EXPECT_EQ(problem("line-art-3d", R"({"segments": 0})"), "a polyline has 1 to 100000 segments");
  EXPECT_EQ(problem("line-art-boundary-3d", R"({"weights": [1, 2]})"),
            "1 regions in 'to' need as many weights, found 2");
}

}  // namespace
}  // namespace burin::curves
