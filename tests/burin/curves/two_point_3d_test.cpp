#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>

#include "naive_schemes.hpp"
#include "space_support.hpp"

/// The two-point scheme in space: vectors B_space of the reference, and the properties that curves.md B states.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::expect_near;
using testing::space_points;

json marks(const json& alpha, const json& beta) {
  json list = json::array();
  for (std::size_t j = 0; j < alpha.size(); ++j) list.push_back({alpha[j], beta[j]});
  return {{"marks", list}};
}

TEST(TwoPoint3d, IsTheReferences) {
  const json b = testing::reference("curves.json")["B_space"];
  ASSERT_EQ(b["cases"].size(), 4U);
  for (const json& c : b["cases"]) {
    SCOPED_TRACE(c["orient"].dump() + c["closed"].dump());
    json params = {{"base", {{"points", b["start"]}, {"closed", c["closed"]}}},
                   {"motif", marks(b["alpha"], b["beta"])},
                   {"theta", b["theta"]},
                   {"up", b["up"]},
                   {"orient", c["orient"]},
                   {"levels", 1}};
    const std::vector<Vec3> level1 = space_points("two-point-3d", params);
    ASSERT_EQ(level1.size(), c["level1"].size());
    for (std::size_t i = 0; i < level1.size(); ++i) {
      const json& expected = c["level1"][i];
      expect_near(level1[i], {expected[0], expected[1], expected[2]}, 1e-9);
    }
    params["levels"] = 2;
    Vec3 sum{};
    double squares = 0.0;
    const std::vector<Vec3> level2 = space_points("two-point-3d", params);
    for (const Vec3 p : level2) {
      sum = sum + p;
      squares += length_squared(p);
    }
    EXPECT_EQ(level2.size(), c["level2_count"].get<std::size_t>());
    const json& expected = c["level2_sum"];
    expect_near(sum, {expected[0], expected[1], expected[2]}, 1e-9 * 60);
    EXPECT_NEAR(squares, c["level2_sumsq"].get<double>(), 1e-9 * 250);
  }
}

void expect_same_as_in_the_plane(const json& params) {
  json plane = params;
  for (const char* key : {"theta", "orient", "normalize"}) plane.erase(key);
  json space = params;
  space["camera"] = {{"eye", {0, 0, 1}}};
  const std::vector<Vec2> expected = testing::draw_points("two-point", plane, {.seed = 3});
  const std::vector<Vec2> points = testing::draw_points("two-point-3d", space, {.seed = 3});
  ASSERT_EQ(points.size(), expected.size()) << params.dump();
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LT(distance(points[i], expected[i]), 1e-9) << params.dump() << " point " << i;
  }
}

TEST(TwoPoint3d, InThePlaneTheReferenceSideIsTwoPoint) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    json base = {{"points", testing::json_points(naive::random_points(seed, 5))}};
    if (seed % 2 == 0) base["closed"] = true;
    for (const char* sign : {"constant", "edge", "level", "level-edge", "random"}) {
      expect_same_as_in_the_plane({{"base", base},
                                   {"motif", {{"marks", {{0.3, 0.2}, {0.7, -0.1}}}}},
                                   {"theta", {0.25 * static_cast<double>(seed % 5), 0.9}},
                                   {"orient", "reference"},
                                   {"sign", sign},
                                   {"levels", 4}});
    }
    expect_same_as_in_the_plane({{"base", base},
                                 {"motif", {{"marks", {{0.4, 0.3}}}, {"beta", "absolute"}, {"decay", 0.6}}},
                                 {"orient", "reference"},
                                 {"levels", 4}});
  }
}

TEST(TwoPoint3d, FlagsOfNamedMotifsAreThoseOfThePlane) {
  for (const char* motif : {"dragon", "altpaper", "polya", "sierpinski", "gosper", "hilbert4", "peano9", "koch"}) {
    expect_same_as_in_the_plane({{"motif", motif}, {"base", "square"}, {"orient", "reference"}, {"levels", 3}});
  }
}

TEST(TwoPoint3d, OutwardIsTwoPointOnConvexPolygons) {
  for (const int n : {3, 4, 7}) {
    expect_same_as_in_the_plane({{"base", {{"shape", "ngon"}, {"n", n}}},
                                 {"motif", {{"marks", {{0.3, 0.2}, {0.7, 0.1}}}}},
                                 {"theta", {0, 1}},
                                 {"orient", "outward"},
                                 {"levels", 1}});
  }
}

Vec3 moved(Vec3 p) {
  // A turn by 40 degrees about x, then by 70 about z, and a shift.
  const auto turn = [](double a, double b, double degrees) {
    return Vec2{math::cos_degrees(degrees) * a - math::sin_degrees(degrees) * b,
                math::sin_degrees(degrees) * a + math::cos_degrees(degrees) * b};
  };
  const Vec2 yz = turn(p.y, p.z, 40);
  const Vec2 xy = turn(p.x, yz.x, 70);
  return Vec3{xy.x, xy.y, yz.y} + Vec3{3, -1, 2};
}

TEST(TwoPoint3d, OutwardMovesWithItsBase) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    std::vector<Vec3> base = testing::random_space_points(seed, 6);
    json params = {{"base", {{"points", testing::json_points(base)}, {"closed", seed % 2 == 0}}},
                   {"motif", {{"marks", {{0.5, 0.4}}}}},
                   {"levels", 4}};
    const std::vector<Vec3> points = space_points("two-point-3d", params);
    for (Vec3& p : base) p = moved(p);
    params["base"]["points"] = testing::json_points(base);
    const std::vector<Vec3> of_moved = space_points("two-point-3d", params);
    ASSERT_EQ(points.size(), of_moved.size());
    for (std::size_t i = 0; i < points.size(); ++i) expect_near(of_moved[i], moved(points[i]), 1e-9);
  }
}

TEST(TwoPoint3d, NormalsAreUnitVectorsAcrossTheEdge) {
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    const std::vector<Vec3> base = testing::random_space_points(seed, 5);
    const json params = {{"base", {{"points", testing::json_points(base)}, {"closed", true}}},
                         {"motif", {{"marks", {{0.25, 0.5}, {0.5, 0.5}, {0.75, 0.5}}}}},
                         {"theta", {0, 0.4, 1}},
                         {"levels", 1}};
    const std::vector<Vec3> points = space_points("two-point-3d", params);
    for (std::size_t i = 0; i < 5; ++i) {
      const Vec3 a = base[i];
      const Vec3 d = base[(i + 1) % 5] - a;
      const auto normal = [&](std::size_t j) {
        return (2.0 / length(d)) * (points[4 * i + j] - a - (0.25 * static_cast<double>(j)) * d);
      };
      for (std::size_t j = 1; j <= 3; ++j) {
        EXPECT_NEAR(dot(normal(j), d), 0.0, 1e-9);
        EXPECT_NEAR(length(normal(j)), 1.0, 1e-9);
      }
      // theta = 0: in the plane of the left neighbour, away from it; theta = 1: of the right one.
      const Vec3 left = base[(i + 4) % 5] - a;
      const Vec3 right = base[(i + 2) % 5] - base[(i + 1) % 5];
      EXPECT_NEAR(dot(normal(1), cross(d, left)), 0.0, 1e-9);
      EXPECT_LT(dot(normal(1), left), 0.0);
      EXPECT_NEAR(dot(normal(3), cross(d, right)), 0.0, 1e-9);
      EXPECT_LT(dot(normal(3), right), 0.0);
    }
  }
}

TEST(TwoPoint3d, ThetaGoesByMarkerEdgeAndLevel) {
  // A bent line of three edges: the middle one has a normal in each of two planes.
  const json base = {{"points", {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}}}};
  const auto middle = [&](const json& theta, int levels) {
    const std::vector<Vec3> points = space_points(
        "two-point-3d", {{"base", base}, {"motif", {{"marks", {{0.5, 0.5}}}}}, {"theta", theta}, {"levels", levels}});
    return points[(3U << static_cast<unsigned>(levels)) / 2];
  };
  expect_near(middle(0, 1), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle(1, 1), {0.5, 0, -0.5}, 1e-12);
  expect_near(middle("edge - 1", 1), {0.5, 0, -0.5}, 1e-12);
  expect_near(middle("level - 1", 1), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle("level - 1", 2), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle("1 - marker + 0*level", 1), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle(0.5, 1), {0.5, -0.5 * std::sqrt(0.5), -0.5 * std::sqrt(0.5)}, 1e-12);
}

TEST(TwoPoint3d, BlendsMayStayShortAndOppositeNormalsLeaveTheNearerOne) {
  const json bent = {{"points", {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}}}};
  const json zigzag = {{"points", {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, -1, 0}}}};
  const auto middle = [](const json& base, double theta, bool normalize) {
    return space_points("two-point-3d", {{"base", base},
                                         {"motif", {{"marks", {{0.5, 0.5}}}}},
                                         {"theta", theta},
                                         {"normalize", normalize},
                                         {"levels", 1}})[3];
  };
  expect_near(middle(bent, 0.5, false), {0.5, -0.25, -0.25}, 1e-12);
  expect_near(middle(zigzag, 0.5, true), {0.5, 0.5, 0}, 1e-12);
  expect_near(middle(zigzag, 0.49, true), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle(zigzag, 0.5, false), {0.5, 0, 0}, 1e-12);
}

TEST(TwoPoint3d, StraightAndLoneEdgesGoByUp) {
  const auto middle = [](const json& points, const json& up) {
    return space_points(
        "two-point-3d",
        {{"base", {{"points", points}}}, {"motif", {{"marks", {{0.5, 0.5}}}}}, {"up", up}, {"levels", 1}})[1];
  };
  expect_near(middle({{0, 0, 0}, {1, 0, 0}}, {0, 0, 1}), {0.5, -0.5, 0}, 1e-12);
  expect_near(middle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 0}), {0.5, 0, 0.5}, 1e-12);
  expect_near(middle({{0, 0, 0}, {0, 0, 1}}, {0, 0, 1}), {0, 0.5, 0.5}, 1e-12);
  expect_near(middle({{1, 2, 3}, {1, 2, 3}}, {0, 0, 1}), {1, 2, 3}, 0.0);
}

TEST(TwoPoint3d, SolidsHaveTheirFacesAndKnotsTheirTurns) {
  for (const auto& [solid, faces, corners] : {std::tuple{"tetrahedron", 4U, 3U},
                                              {"cube", 6U, 4U},
                                              {"octahedron", 8U, 3U},
                                              {"dodecahedron", 12U, 5U},
                                              {"icosahedron", 20U, 3U}}) {
    const std::vector<Vec3> points = space_points("two-point-3d", {{"base", {{"solid", solid}}}, {"levels", 0}});
    ASSERT_EQ(points.size(), faces * corners) << solid;
    const double edge = distance(points[0], points[1]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(length(points[i]), 1.0, 1e-12);
      const std::size_t face = i / corners * corners;
      const Vec3 a = points[i];
      const Vec3 b = points[face + (i + 1) % corners];
      const Vec3 c = points[face + (i + 2) % corners];
      EXPECT_NEAR(distance(a, b), edge, 1e-12) << solid;
      EXPECT_GT(dot(cross(b - a, c - b), a), 0.0) << "counter-clockwise from outside";
    }
  }
  const std::vector<Vec3> knot =
      space_points("two-point-3d", {{"base", {{"knot", {2, 3}}, {"n", 12}, {"tube", 0.5}}}, {"levels", 0}});
  ASSERT_EQ(knot.size(), 12U);
  expect_near(knot[0], {1.5, 0, 0}, 1e-12);
  expect_near(knot[1], {0.5, std::sqrt(0.75), 0.5}, 1e-12);
}

TEST(TwoPoint3d, BoxesAreThoseOfTheReplay) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    json camera = {{"eye", {4, -7, 5}}};
    if (seed % 2 == 0) camera["projection"] = "perspective";
    const json params = {
        {"base", {{"points", testing::json_points(testing::random_space_points(seed, 5))}, {"closed", seed % 3 == 0}}},
        {"motif", seed % 4 == 0 ? json("koch") : json{{"marks", {{0.5, 0.2}}}}},
        {"theta", 0.1 * static_cast<double>(seed % 11)},
        {"sign", seed % 5 == 0 ? "random" : "edge"},
        {"levels", seed % 6},
        {"camera", camera}};
    const Affine2 frame = naive::random_affine(seed);
    Box2 replayed;
    for (const Vec2 p : testing::draw_points("two-point-3d", params, {.seed = seed})) replayed.add(frame(p));
    const std::any read = *testing::read_params("two-point-3d", params.dump()).params;
    const std::optional<Box2> box = find_family("two-point-3d")->bounds(read, {.seed = seed}, frame);
    ASSERT_TRUE(box.has_value());
    const double tolerance = 1e-12 * (1 + replayed.width() + replayed.height());
    EXPECT_NEAR(box->low.x, replayed.low.x, tolerance) << params.dump();
    EXPECT_NEAR(box->low.y, replayed.low.y, tolerance) << params.dump();
    EXPECT_NEAR(box->high.x, replayed.high.x, tolerance) << params.dump();
    EXPECT_NEAR(box->high.y, replayed.high.y, tolerance) << params.dump();
  }
}

TEST(TwoPoint3d, ManyLevelsCostWhatIsSeen) {
  for (const char* projection : {"orthographic", "perspective"}) {
    const json params = {
        {"base", {{"solid", "cube"}}}, {"levels", 1000}, {"camera", {{"projection", projection}, {"eye", {3, -5, 4}}}}};
    const std::any read = *testing::read_params("two-point-3d", params.dump()).params;
    const Family& family = *find_family("two-point-3d");
    const std::optional<Box2> box = family.bounds(read, {}, {});
    ASSERT_TRUE(box.has_value());
    const DrawContext context{.view = {*box, 0.02}};
    const Forecast forecast = family.forecast(read, context, 1e7);
    EXPECT_TRUE(forecast.exact);
    EXPECT_GT(forecast.asked_points, 1e300);
    EXPECT_LT(forecast.points, 2e4);
    const std::vector<Vec2> points = testing::draw_points("two-point-3d", params, context);
    EXPECT_EQ(forecast.points, static_cast<double>(points.size()));
    for (const Vec2 p : points) ASSERT_TRUE(box->grown(1e-9).contains(p));
  }
}

TEST(TwoPoint3d, AViewHidesNothingLargerThanItsTolerance) {
  const json params = {{"base", {{"knot", {2, 3}}, {"n", 9}}},
                       {"motif", {{"marks", {{0.35, 0.2}, {0.6, 0.2}}}}},
                       {"theta", {0.2, 0.8}},
                       {"levels", 6},
                       {"camera", {{"projection", "perspective"}, {"eye", {4, -5, 4}}}}};
  const std::vector<Vec2> full = testing::draw_points("two-point-3d", params);
  for (const double tolerance : {0.3, 0.03, 0.003}) {
    const std::vector<Vec2> seen = testing::draw_points("two-point-3d", params, {.view = {.tolerance = tolerance}});
    EXPECT_LT(seen.size(), full.size());
    std::size_t at = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      ASSERT_EQ(full[at], seen[i]);
      const Vec2 next = seen[(i + 1) % seen.size()];
      for (++at; at < full.size() && full[at] != next; ++at) {
        const Vec2 d = next - seen[i];
        const double t = std::clamp(dot(full[at] - seen[i], d) / length_squared(d), 0.0, 1.0);
        ASSERT_LE(distance(full[at], lerp(seen[i], next, t)), tolerance);
      }
    }
  }
}

TEST(TwoPoint3d, MistakesAreExplained) {
  const auto problem = [](const char* text) {
    const testing::ReadParams read = testing::read_params("two-point-3d", text);
    EXPECT_FALSE(read.params.has_value()) << text;
    return read.problems.empty() ? std::string() : read.problems.front().message;
  };
  EXPECT_EQ(problem(R"({"theta": [0, 1]})"), "'theta' needs one value, or one for each of the 3 markers; found 2");
  EXPECT_EQ(problem(R"({"motif": "hilbert"})"), "'join' is for two-point, in the plane");
  EXPECT_EQ(problem(R"({"base": {"points": [[0, 0, 0], [1, 1]]}})"),
            "'base': 'points': expected a point [x, y, z], found a list of 2");
  EXPECT_EQ(problem(R"({"base": {"solid": "cube", "knot": [2, 3]}})"),
            "'base': a base in space needs exactly one of 'points', 'solid' and 'knot'");
  EXPECT_EQ(problem(R"({"base": {"knot": [2]}})"), "'base': a knot is [p, q], found a list of 1");
  EXPECT_EQ(problem(R"({"camera": {"eye": [0, 0, 0]}})"),
            "'camera': 'eye' and 'target' are the same point: the camera looks nowhere");
  EXPECT_EQ(problem(R"({"camera": {"fov": 30}})"),
            "'camera': 'fov' is for projection = \"perspective\"; an orthographic camera has a 'scale'");
  EXPECT_EQ(problem(R"({"camera": {"projection": "perspective", "fov": 30, "scale": 2}})"),
            "'camera': 'fov' and 'scale' both say how large the picture is; give one of them");
  EXPECT_EQ(problem(R"({"camera": {"projection": "perspective", "eye": [0, 0, 1.01]}})"),
            "the curve may come within 0 of the plane through the eye, or behind it; move 'eye' farther away from "
            "'target', or use an orthographic camera");
  EXPECT_EQ(problem(R"({"camera": {"projection": "perspective"}, "motif": {"marks": [["0.5", "0.1*edge"]]}})"),
            "nothing is known of how far this curve reaches: it may come behind the eye; use an orthographic camera");
}

}  // namespace
}  // namespace burin::curves
