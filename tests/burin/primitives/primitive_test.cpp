#include <string>

#include <gtest/gtest.h>

#include <burin/primitives/primitive.hpp>

namespace burin::primitives {
namespace {

std::string svg(const std::string& body, const std::string& attributes = "viewBox='0 0 100 100'") {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + body + "</svg>";
}

Primitive read(const std::string& body) {
  Result<Primitive> primitive = read_primitive_svg(svg(body), "mine/figure.svg");
  EXPECT_TRUE(primitive.ok()) << problems_text(primitive.problems());
  return primitive ? *primitive : Primitive{};
}

void expect_near(Vec2 p, Vec2 q) {
  EXPECT_NEAR(p.x, q.x, 1e-12);
  EXPECT_NEAR(p.y, q.y, 1e-12);
}

/// The points of the i-th path's first contour.
std::span<const Vec2> points(const Primitive& primitive, std::size_t i) {
  const Recording& drawing = primitive.figure->drawing();
  return drawing.points(drawing.contours(drawing.paths()[i]).front());
}

TEST(Primitive, UnitSizeAndMiddleWithoutAnchor) {
  const Primitive p = read("<rect x='10' y='20' width='40' height='20' stroke='red' fill='none'/>");
  EXPECT_EQ(p.name, "figure");
  EXPECT_EQ(p.title, "figure");
  ASSERT_EQ(p.figure->drawing().paths().size(), 1U);
  EXPECT_TRUE(p.figure->drawing().paths()[0].head.closed);
  EXPECT_EQ(p.figure->drawing().paths()[0].head.paint, Paint::stroke);
  ASSERT_EQ(points(p, 0).size(), 4U);
  expect_near(points(p, 0)[0], {-0.5, 0.25});  // y up
  expect_near(points(p, 0)[2], {0.5, -0.25});
}

TEST(Primitive, AnchorIsTheOrigin) {
  const Primitive p =
      read("<path d='M0 0 H10 V20' fill='none' stroke='black'/><circle id='anchor' cx='10' cy='20' r='3' fill='red'/>");
  ASSERT_EQ(p.figure->drawing().paths().size(), 1U) << "the anchor itself is not drawn";
  expect_near(points(p, 0)[0], {-0.5, 1.0});
  expect_near(points(p, 0)[2], {0.0, 0.0});
}

TEST(Primitive, AnchorLineGivesUp) {
  const Primitive p = read(
      "<path d='M0 0 H10' fill='none' stroke='black'/>"
      "<path xmlns:inkscape='i' inkscape:label='anchor' d='M0 0 h4' style='display:none'/>");
  expect_near(points(p, 0)[0], {0.0, 0.0});
  expect_near(points(p, 0)[1], {0.0, 1.0});
}

TEST(Primitive, FillAndStrokeArePathsOfTheirOwn) {
  const Primitive p = read("<path d='M0 0 H10 V10 Z M2 2 H4 V4' fill-rule='evenodd' stroke='black'/>");
  const Recording& drawing = p.figure->drawing();
  ASSERT_EQ(drawing.paths().size(), 3U);
  EXPECT_EQ(drawing.paths()[0].head.paint, Paint::fill_evenodd);
  EXPECT_TRUE(drawing.paths()[0].head.closed) << "an area is closed though its outline is open";
  EXPECT_EQ(drawing.contours(drawing.paths()[0]).size(), 2U);
  EXPECT_TRUE(drawing.paths()[1].head.closed);
  EXPECT_FALSE(drawing.paths()[2].head.closed);
}

TEST(Primitive, WhatCannotBeDrawnIsAnErrorOrLeftOut) {
  const std::string text = svg("\n<text>word</text>\n<path d='M0 0h1' stroke='black'/>");
  const Result<Primitive> strict = read_primitive_svg(text, "a.svg");
  ASSERT_FALSE(strict.ok());
  ASSERT_EQ(strict.problems().size(), 1U);
  EXPECT_EQ(strict.problems()[0].where.file, "a.svg");
  EXPECT_EQ(strict.problems()[0].where.line, 2);
  EXPECT_NE(strict.problems()[0].message.find("text"), std::string::npos);
  const Result<Primitive> rest = read_primitive_svg(text, "a.svg", figure_tolerance, Leftovers::are_left_out);
  ASSERT_TRUE(rest.ok());
  EXPECT_EQ(rest->figure->drawing().paths().size(), 1U);
}

TEST(Primitive, NothingToDrawIsAnError) {
  for (const char* body : {"", "<path d=''/>", "<path d='M0 0h9' fill='none'/>",
                           "<g display='none'><rect width='9' "
                           "height='9'/></g>"}) {
    const Result<Primitive> primitive = read_primitive_svg(svg(body), "a.svg");
    ASSERT_FALSE(primitive.ok()) << body;
    EXPECT_NE(primitive.problems()[0].message.find("draws nothing"), std::string::npos);
  }
}

TEST(Primitive, CurvesKeepToTheTolerance) {
  const Primitive p = read("<circle r='20' fill='none' stroke='black'/>");
  double nearest = 1.0;
  const std::span<const Vec2> circle = points(p, 0);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const Vec2 next = circle[(i + 1) % circle.size()];
    EXPECT_NEAR(length(circle[i]), 0.5, 1e-12);
    nearest = std::min(nearest, length(0.5 * (circle[i] + next)));
  }
  EXPECT_GT(nearest, 0.5 - figure_tolerance);
  EXPECT_LT(nearest, 0.5 - figure_tolerance / 4.0) << "more chords than the tolerance needs";
}

}  // namespace
}  // namespace burin::primitives
