#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/geom/camera.hpp>

#include "naive_schemes.hpp"
#include "space_support.hpp"

/// Subdivision curves in space: what holds in the plane holds in every coordinate.
namespace burin::curves {
namespace {

using nlohmann::json;
using testing::draw_points;
using testing::space_points;

struct Case {
  std::string family;
  json params;
};

std::vector<Case> cases() {
  const json open = {{"points", testing::json_points(testing::random_space_points(1, 6))}};
  const json closed = {{"points", testing::json_points(testing::random_space_points(2, 5))}, {"closed", true}};
  return {{"de-rham", {{"t", 0.3}, {"base", closed}}},
          {"de-rham", {{"t", 0.7}, {"base", open}, {"ends", "clamp"}}},
          {"de-rham", {{"t", -0.2}, {"normalize", true}, {"base", closed}}},
          {"four-point", {{"base", closed}}},
          {"four-point", {{"t", 0.4}, {"base", open}, {"ends", "reflect"}}},
          {"four-parameter", {{"lambda", 0.125}, {"mu", 0.1}, {"omega", 0.02}, {"base", open}}},
          {"four-parameter", {{"lambda", "1/30"}, {"mu", "1/30"}, {"omega", "1/3"}, {"base", closed}}},
          {"four-parameter", {{"base", open}, {"ends", "given"}}}};
}

TEST(SubdivisionSpace, EveryCoordinateIsRefinedByItself) {
  for (Case c : cases()) {
    SCOPED_TRACE(c.family + c.params.dump());
    c.params["levels"] = 5;
    json plane = c.params;
    for (json& p : plane["base"]["points"]) p = {p[2], p[0]};
    const std::vector<Vec2> expected = draw_points(c.family, plane);
    const std::vector<Vec3> points = space_points(c.family, c.params);
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(points[i].z, expected[i].x, 1e-12);
      EXPECT_NEAR(points[i].x, expected[i].y, 1e-12);
    }
  }
}

TEST(SubdivisionSpace, APlaneBaseAndACameraFromAboveAreThePlane) {
  const json params = {{"base", "square"}, {"levels", 4}};
  json seen = params;
  seen["camera"] = {{"eye", {0, 0, 3}}};
  const std::vector<Vec2> expected = draw_points("four-point", params);
  const std::vector<Vec2> points = draw_points("four-point", seen);
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(distance(points[i], expected[i]), 1e-12);
}

TEST(SubdivisionSpace, PerspectiveIsThatOfEveryPoint) {
  const Camera camera({Projection::perspective, {5, -6, 4}, {0.1, 0, 0}, {0, 0, 1}, 1.5});
  const json seen = {{"projection", "perspective"}, {"eye", {5, -6, 4}}, {"target", {0.1, 0, 0}}, {"scale", 1.5}};
  for (Case c : cases()) {
    SCOPED_TRACE(c.family + c.params.dump());
    c.params["levels"] = 4;
    const std::vector<Vec3> points = space_points(c.family, c.params);
    c.params["camera"] = seen;
    const std::vector<Vec2> pictures = draw_points(c.family, c.params);
    ASSERT_EQ(points.size(), pictures.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(distance(pictures[i], camera(points[i])), 1e-11);
  }
}

TEST(SubdivisionSpace, BoxesAndViewsAreThoseOfTheReplay) {
  for (std::uint64_t seed = 0; seed < 48; ++seed) {
    const std::vector<Case> all = cases();
    Case c = all[seed % all.size()];
    c.params["levels"] = seed % 8;
    c.params["camera"] = {{"projection", seed % 2 == 0 ? "perspective" : "orthographic"},
                          {"eye", {4, -8, 3 + seed % 3}}};
    SCOPED_TRACE(c.family + c.params.dump());
    const Affine2 frame = naive::random_affine(seed);
    const std::vector<Vec2> full = draw_points(c.family, c.params);
    Box2 replayed;
    for (const Vec2 p : full) replayed.add(frame(p));
    const std::any read = *testing::read_params(c.family, c.params.dump()).params;
    const Family& family = *find_family(c.family);
    const std::optional<Box2> box = family.bounds(read, {}, frame);
    ASSERT_TRUE(box.has_value());
    const double tolerance = 1e-12 * (1 + replayed.width() + replayed.height());
    EXPECT_NEAR(box->low.x, replayed.low.x, tolerance);
    EXPECT_NEAR(box->low.y, replayed.low.y, tolerance);
    EXPECT_NEAR(box->high.x, replayed.high.x, tolerance);
    EXPECT_NEAR(box->high.y, replayed.high.y, tolerance);
    const DrawContext context{.view = {Box2{{-0.5, -0.5}, {1, 0.5}}, 0.01}};
    const std::vector<Vec2> seen = draw_points(c.family, c.params, context);
    EXPECT_EQ(family.forecast(read, context, 1e9).points, static_cast<double>(seen.size()));
    std::size_t at = 0;
    for (const Vec2 p : seen) {
      while (at < full.size() && full[at] != p) ++at;
      ASSERT_LT(at++, full.size()) << "what is seen is a part of what there is";
    }
  }
}

TEST(SubdivisionSpace, WhatComesBehindTheEyeIsRefused) {
  // The curve leaves the hull of its points: not the polygon but the curve passes the eye.
  const char* text = R"({"w": 0.2, "levels": 8, "base": {"points": [[0,0,0],[4,0,0],[4,0,1],[0,0,1]], "closed": true},
                         "camera": {"projection": "perspective", "eye": [4.3, 0, 0.5], "target": [0, 0, 0.5]}})";
  EXPECT_FALSE(testing::read_params("four-point", text).params.has_value());
  std::string straight = text;
  straight.replace(straight.find("0.2"), 3, "0.0");
  EXPECT_TRUE(testing::read_params("four-point", straight).params.has_value());
  EXPECT_FALSE(testing::read_params("de-rham", R"({"camera": {"projection": "perspective", "eye": [0.5, 0, 0]}})")
                   .params.has_value());
}

}  // namespace
}  // namespace burin::curves
