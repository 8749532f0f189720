#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "drawing.hpp"

// All on 20 x 10 mm at 10 pixels a millimetre: 1 mm of the pen is 10 pixels, 1 mm^2 of ink is 100.
namespace burin::test {
namespace {

const double pi = 3.14159265358979323846;

Sheet sheet_with(Cap cap, Join join, double width_mm = 1.0) {
  Sheet sheet = small_sheet();
  sheet.pens[0].width_mm = width_mm;
  sheet.layers[0].cap = cap;
  sheet.layers[0].join = join;
  return sheet;
}

Draw line(std::vector<Vec2> points, bool closed = false) {
  return [=](PathSink& to) { return draw_line(to, points, closed); };
}

/// Every edge of `points` in `parts` equal pieces.
std::vector<Vec2> subdivided(const std::vector<Vec2>& points, int parts, bool closed) {
  std::vector<Vec2> fine;
  const std::size_t edges = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    for (int k = 0; k < parts; ++k) {
      fine.push_back(lerp(points[i], points[(i + 1) % points.size()], static_cast<double>(k) / parts));
    }
  }
  if (!closed) fine.push_back(points.back());
  return fine;
}

TEST(Stroke, ALineCoversItsLengthTimesItsWidth) {
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::butt, Join::round), line({{2.0, 2.0}, {12.0, 7.0}}))),
              100.0 * std::sqrt(125.0), 5.0);
}

TEST(Stroke, CapsAddTheirArea) {
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::butt, Join::round), line({{2.0, 5.0}, {18.0, 5.0}}))), 1600.0, 0.1);
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::square, Join::round), line({{2.0, 5.0}, {18.0, 5.0}}))), 1700.0, 0.1);
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::round, Join::round), line({{2.0, 5.0}, {18.0, 5.0}}))), 1600.0 + 25.0 * pi,
              2.0);
}

TEST(Stroke, JoinsAddTheirArea) {
  const std::vector<Vec2> square = {{5.0, 2.0}, {11.0, 2.0}, {11.0, 8.0}, {5.0, 8.0}};
  const double plain = 2400.0 - 4.0 * 25.0;  // four bands whose inner ends overlap in quarter squares
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::butt, Join::miter), line(square, true))), plain + 100.0, 0.1);
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::butt, Join::bevel), line(square, true))), plain + 50.0, 2.0);
  EXPECT_NEAR(ink(pixels(sheet_with(Cap::butt, Join::round), line(square, true))), plain + 25.0 * pi, 2.0);
}

TEST(Stroke, DotsShowAsTheirCaps) {
  for (const std::vector<Vec2>& dot : {std::vector<Vec2>{{5.0, 5.0}}, std::vector<Vec2>(700, {5.0, 5.0})}) {
    for (const bool closed : {false, true}) {
      EXPECT_NEAR(ink(pixels(sheet_with(Cap::round, Join::round), line(dot, closed))), 25.0 * pi, 1.0);
      EXPECT_NEAR(ink(pixels(sheet_with(Cap::square, Join::round), line(dot, closed))), 100.0, 0.1);
      EXPECT_EQ(ink(pixels(sheet_with(Cap::butt, Join::round), line(dot, closed))), 0.0);
    }
  }
}

TEST(Stroke, ADotInADashedLayerIsADot) {
  Sheet sheet = sheet_with(Cap::round, Join::round);
  sheet.layers[0].dashes_mm = {0.5, 3.0};
  sheet.layers[0].dash_offset_mm = 2.0;
  EXPECT_NEAR(ink(pixels(sheet, line({{5.0, 5.0}}))), 25.0 * pi, 1.0);
}

using Style = std::tuple<Cap, Join, bool>;
class CutStroke : public testing::TestWithParam<Style> {};

// Ends and corners on pixel borders: no soft edge hides a cap too many or a join too few, so cuts may change nothing.
TEST_P(CutStroke, IsTheSameAsInOnePiece) {
  const auto [cap, join, closed] = GetParam();
  const Sheet sheet = sheet_with(cap, join);
  const std::vector<Vec2> corners = {{2.0, 2.0},  {8.0, 2.0},  {8.0, 6.0}, {11.0, 6.0}, {11.0, 2.0}, {17.0, 2.0},
                                     {17.0, 8.0}, {14.0, 8.0}, {5.0, 8.0}, {5.0, 5.0},  {2.0, 5.0}};
  const Pixels whole = pixels(sheet, line(corners, closed));
  // A bevel is half a pixel somewhere, which Cairo rounds in one way with round caps and in another without.
  for (const int parts : {100, 125, 499, 500, 501, 512}) {
    // One segment after a corner the overlap has the corner in it, which is soft unless mitered.
    if (parts == 499 && join != Join::miter) continue;
    const Pixels cut = pixels(sheet, line(subdivided(corners, parts, closed), closed));
    EXPECT_EQ(differing(whole, cut, join == Join::bevel ? 8 : 2), 0) << parts << " segments an edge";
  }
}

TEST_P(CutStroke, DiffersAtTheSoftEdgesOfItsCutsOnly) {
  const auto [cap, join, closed] = GetParam();
  const Sheet sheet = sheet_with(cap, join, 0.4);
  // A closed way that nowhere crosses itself: where two pieces cross, soft edges are drawn twice as well.
  const std::vector<Vec2> corners = {{1.0, 1.0},  {4.0, 8.0},  {7.0, 2.0},  {10.0, 8.0},
                                     {13.0, 3.0}, {19.0, 8.0}, {19.0, 9.6}, {1.0, 9.6}};
  const Pixels whole = pixels(sheet, line(corners, closed));
  // Edges of even numbers of pixels: their 512 parts lie on Cairo's grid of 1/256.
  const std::vector<Vec2> fine = subdivided(corners, 512, closed);
  const int cuts = static_cast<int>(fine.size() / 500);
  const int different = differing(whole, pixels(sheet, line(fine, closed)), 2);
  EXPECT_LE(different, 14 * cuts);
}

INSTANTIATE_TEST_SUITE_P(Styles, CutStroke,
                         testing::Combine(testing::Values(Cap::round, Cap::butt, Cap::square),
                                          testing::Values(Join::round, Join::miter, Join::bevel), testing::Bool()));

TEST(Stroke, ALongCurveOfShortSegmentsIsTheSameAsInFewLongOnes) {
  std::vector<Vec2> fine;
  for (int i = 0; i <= 20000; ++i) fine.push_back({0.001 * i, 5.0 + 3.0 * std::sin(0.001 * i)});
  std::vector<Vec2> coarse;
  for (int i = 0; i <= 400; ++i) coarse.push_back(fine[static_cast<std::size_t>(50 * i)]);
  const Sheet sheet = sheet_with(Cap::round, Join::round);
  const Pixels a = pixels(sheet, line(fine));
  const Pixels b = pixels(sheet, line(coarse));
  EXPECT_NEAR(ink(a), ink(b), 0.005 * ink(b));
}

TEST(Stroke, OpacityJoinsALayersStrokes) {
  Sheet sheet = sheet_with(Cap::butt, Join::round);
  sheet.layers[0].opacity = 0.5;
  const Pixels cross = pixels(sheet, [](PathSink& to) {
    if (draw_line(to, {{2.0, 5.0}, {18.0, 5.0}}) == Flow::stop) return Flow::stop;
    return draw_line(to, subdivided({{10.0, 1.0}, {10.0, 9.0}}, 1600, false));
  });
  EXPECT_NEAR(cross.red(30, 50), 128, 1);
  EXPECT_EQ(cross.red(100, 50), cross.red(30, 50));
  EXPECT_NEAR(ink(cross), 0.5 * (1600.0 + 800.0 - 100.0), 10.0);
}

TEST(Stroke, LayersWithOpacityDarkenEachOther) {
  Sheet sheet = sheet_with(Cap::butt, Join::round);
  sheet.layers[0].opacity = 0.5;
  sheet.layers.push_back(sheet.layers[0]);
  const Pixels cross = pixels(sheet, [](PathSink& to) {
    if (draw_line(to, {{2.0, 5.0}, {18.0, 5.0}}) == Flow::stop) return Flow::stop;
    return draw_line(to, {{10.0, 1.0}, {10.0, 9.0}}, false, Paint::stroke, 1);
  });
  EXPECT_NEAR(cross.red(30, 50), 128, 1);
  EXPECT_NEAR(cross.red(100, 50), 64, 2);
}

TEST(Stroke, LaterLayersLieOnTop) {
  Sheet sheet = sheet_with(Cap::butt, Join::round);
  sheet.pens.push_back({.name = "red", .colour = {255, 0, 0}, .width_mm = 2.0});
  sheet.layers.push_back({.name = "red", .pen = 1, .cap = Cap::butt});
  const Pixels cross = pixels(sheet, [](PathSink& to) {
    if (draw_line(to, {{2.0, 5.0}, {18.0, 5.0}}) == Flow::stop) return Flow::stop;
    return draw_line(to, {{10.0, 1.0}, {10.0, 9.0}}, false, Paint::stroke, 1);
  });
  EXPECT_EQ(cross.red(100, 50), 255);
  EXPECT_EQ(cross.green(100, 50), 0);
  EXPECT_EQ(cross.red(91, 20), 255);
  EXPECT_EQ(cross.green(91, 20), 0);
  EXPECT_EQ(cross.red(30, 50), 0);
}

TEST(Stroke, MasksAreNotDrawn) {
  const Pixels nothing = pixels(small_sheet(), [](PathSink& to) {
    if (to.begin({.role = Role::mask, .paint = Paint::fill_nonzero, .closed = true}) == Flow::stop) return Flow::stop;
    const std::vector<Vec2> triangle = {{1.0, 1.0}, {9.0, 1.0}, {9.0, 9.0}};
    if (to.points(triangle) == Flow::stop || to.contour() == Flow::stop) return Flow::stop;
    if (to.points(triangle) == Flow::stop) return Flow::stop;
    return to.end();
  });
  EXPECT_EQ(ink(nothing), 0.0);
}

TEST(FarStroke, IsTheSameAsANearOneOnThePage) {
  const Sheet sheet = sheet_with(Cap::square, Join::miter);
  const Pixels near = pixels(sheet, line({{-10.0, 0.0}, {30.0, 10.0}}));
  for (const double far : {1e3, 9e5, 1e6, 1e9}) {
    EXPECT_EQ(differing(near, pixels(sheet, line({{10.0 - 4.0 * far, 5.0 - far}, {10.0 + 4.0 * far, 5.0 + far}})), 4),
              0)
        << far;
  }
  const Pixels level = pixels(sheet, line({{-10.0, 4.0}, {30.0, 4.0}}));
  EXPECT_NEAR(ink(level), 2000.0, 0.1);
  EXPECT_EQ(differing(level, pixels(sheet, line({{-1e308, 4.0}, {1e308, 4.0}})), 0), 0);
}

TEST(FarStroke, ComesAndGoesWithItsCornersOnThePage) {
  const Sheet sheet = sheet_with(Cap::round, Join::miter);
  const std::vector<Vec2> near = {{5.0, -50.0}, {5.0, 5.0}, {10.0, 5.0}, {10.0, 60.0}, {15.0, 60.0}, {15.0, 3.0}};
  std::vector<Vec2> far = near;
  far[0].y = -1e7;
  far[3].y = far[4].y = 1e7;
  EXPECT_EQ(differing(pixels(sheet, line(near)), pixels(sheet, line(far)), 1), 0);
  EXPECT_EQ(
      differing(
          pixels(sheet, line(near, true)),
          pixels(sheet, line({{5.0, -50.0}, {5.0, 5.0}, {10.0, 5.0}, {10.0, 1e7}, {15.0, 1e7}, {15.0, 3.0}}, true)), 1),
      0);
}

TEST(FarStroke, AClosedOneThatLeavesThePageHasTheJoinWhereItCloses) {
  const Sheet sheet = sheet_with(Cap::butt, Join::miter);
  // Closes at the corner (5, 5) on the page; its far side is off the page.
  const Pixels closed = pixels(sheet, line({{5.0, 5.0}, {1e6, 5.0}, {1e6, 1e6}, {5.0, 1e6}}, true));
  EXPECT_EQ(closed.red(45, 45), 0);  // the outer corner of the miter
  EXPECT_NEAR(ink(closed), 100.0 * (15.5 + 5.5 - 1.0), 0.1);
}

TEST(FarStroke, AMiterReachesOntoThePageFromOutside) {
  Sheet sheet = sheet_with(Cap::butt, Join::miter);
  sheet.layers[0].miter_limit = 20.0;
  // The tip of this spike lies about 5 mm to the right of its vertex, which is off the page.
  const Pixels spike = pixels(sheet, line({{-22.0, 3.0}, {-2.0, 5.0}, {-22.0, 7.0}}));
  EXPECT_EQ(spike.red(5, 50), 0);
  EXPECT_GT(ink(spike), 50.0);
}

TEST(FarStroke, BesideThePageIsNothing) {
  const Sheet sheet = sheet_with(Cap::round, Join::round);
  // These would wrap onto the page: Cairo keeps 24 bits before the point.
  EXPECT_EQ(ink(pixels(sheet, line({{1677721.6, 5.0}, {1677730.0, 5.0}}))), 0.0);
  EXPECT_EQ(ink(pixels(sheet, line({{1677725.0, 5.0}}))), 0.0);
  EXPECT_EQ(ink(pixels(sheet, line({{1677721.6, 2.0}, {1677725.0, 5.0}, {1677721.6, 8.0}}, true))), 0.0);
}

TEST(FarStroke, AnEnormousPenCoversThePage) {
  EXPECT_EQ(ink(pixels(sheet_with(Cap::round, Join::round, 1e9), line({{5.0, 5.0}, {6.0, 5.0}}))), 20000.0);
}

TEST(Dashes, StartAtTheOffsetAndRepeat) {
  Sheet sheet = sheet_with(Cap::butt, Join::round);
  sheet.layers[0].dashes_mm = {2.0, 1.0};
  sheet.layers[0].dash_offset_mm = 1.0;
  const Pixels dashes = pixels(sheet, line({{1.0, 5.0}, {19.0, 5.0}}));
  for (int x = 10; x < 190; ++x) EXPECT_EQ(dashes.red(x, 50), x % 30 < 20 ? 0 : 255) << x;
}

TEST(Dashes, AreTheSameWhenTheLineIsCut) {
  for (const Cap cap : {Cap::butt, Cap::square, Cap::round}) {
    Sheet sheet = sheet_with(cap, Join::miter, 0.4);
    // Odd: on 0.8 off 0.7 on 0.6 off 0.8 on 0.7 off 0.6.
    sheet.layers[0].dashes_mm = {0.8, 0.7, 0.6};
    sheet.layers[0].dash_offset_mm = -0.3;
    const std::vector<Vec2> corners = {{1.0, 2.0}, {18.0, 2.0}, {18.0, 5.0}, {2.0, 5.0}, {2.0, 8.0}, {19.0, 8.0}};
    // Edges of 1/256 pixels: Cairo adds the lengths up that it sees.
    const Pixels whole = pixels(sheet, line(corners));
    EXPECT_GT(ink(whole), 500.0);
    EXPECT_EQ(differing(whole, pixels(sheet, line(subdivided(corners, 640, false))), 8), 0);
  }
}

TEST(Dashes, GoOnWhereTheyWouldBeAfterAWayOffThePage) {
  Sheet sheet = sheet_with(Cap::butt, Join::round);
  sheet.layers[0].dashes_mm = {2.0, 1.0};
  const Pixels near = pixels(sheet, line({{-3.0, 5.0}, {25.0, 5.0}}));
  EXPECT_EQ(differing(near, pixels(sheet, line({{-3e6, 5.0}, {25.0, 5.0}})), 2), 0);
  // Out and back in: 3e6 mm each way are whole periods.
  const Pixels out_and_in = pixels(sheet, line({{1.0, 2.0}, {1.0 + 3e6, 2.0}, {1.0 + 3e6, 8.0}, {1.0, 8.0}}));
  for (int x = 12; x < 198; ++x) EXPECT_EQ(out_and_in.red(x, 80), (x - 10) % 30 < 10 ? 255 : 0) << x;
}

TEST(Fill, RulesDifferWhereContoursOverlap) {
  const auto squares = [](Paint paint) {
    return pixels(small_sheet(), [paint](PathSink& to) {
      if (to.begin({.paint = paint, .closed = true}) == Flow::stop) return Flow::stop;
      const std::vector<Vec2> outer = {{2.0, 1.0}, {10.0, 1.0}, {10.0, 9.0}, {2.0, 9.0}};
      const std::vector<Vec2> inner = {{4.0, 3.0}, {8.0, 3.0}, {8.0, 7.0}, {4.0, 7.0}};
      if (to.points(outer) == Flow::stop || to.contour() == Flow::stop) return Flow::stop;
      if (to.points(inner) == Flow::stop) return Flow::stop;
      return to.end();
    });
  };
  EXPECT_EQ(ink(squares(Paint::fill_nonzero)), 6400.0);
  EXPECT_EQ(ink(squares(Paint::fill_evenodd)), 6400.0 - 1600.0);
}

TEST(Fill, FarCornersFillThePageAsNearOnesDo) {
  const auto fill = [](const std::vector<Vec2>& points) {
    return pixels(small_sheet(), [&](PathSink& to) { return draw_line(to, points, true, Paint::fill_nonzero); });
  };
  const Pixels near = fill({{-20.0, -10.0}, {40.0, 20.0}, {-20.0, 20.0}});
  EXPECT_NEAR(ink(near), 10000.0, 5.0);
  for (const double far : {1e5, 1e7, 1e12}) {
    EXPECT_EQ(differing(near, fill({{-2.0 * far, -far}, {2.0 * far, far}, {-2.0 * far, far}}), 2), 0) << far;
  }
  EXPECT_EQ(ink(fill({{-1e300, -1e300}, {1e300, -1e300}, {1e300, 1e300}, {-1e300, 1e300}})), 20000.0);
  EXPECT_EQ(ink(fill({{1677721.6, 0.0}, {1677731.6, 0.0}, {1677731.6, 10.0}})), 0.0);
}

}  // namespace
}  // namespace burin::test
