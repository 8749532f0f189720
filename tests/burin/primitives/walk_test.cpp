#include <cmath>

#include <burin/primitives/walk.hpp>

#include "placing_support.hpp"

namespace burin::primitives {
namespace {

std::vector<Frame> visited(Stops stops, double step, const std::vector<Vec2>& points, bool closed) {
  std::vector<Frame> frames;
  Walk walk(stops, step, [&](const Frame& frame) {
    frames.push_back(frame);
    return Flow::go;
  });
  walk.begin(closed);
  for (const Vec2 p : points) EXPECT_EQ(walk.points(std::span(&p, 1)), Flow::go);
  EXPECT_EQ(walk.finish(), Flow::go);
  return frames;
}

TEST(Walk, FramesOfTheReferencesOpenLine) {
  // curves.json, H_placement: in, out, tangent angle, mean length at each of five points.
  const auto expected = testing::reference("curves.json")["H_placement"]["frames_open5"];
  const std::vector<Frame> frames = visited(Stops::points, 0.0, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 1}}, false);
  ASSERT_EQ(frames.size(), expected.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& frame = frames[i];
    EXPECT_EQ(frame.index, i);
    EXPECT_EQ(frame.in, (Vec2{expected[i][0], expected[i][1]}));
    EXPECT_EQ(frame.out, (Vec2{expected[i][2], expected[i][3]}));
    const Vec2 tangent = tangent_of(frame);
    EXPECT_NEAR(std::atan2(tangent.y, tangent.x), expected[i][4].get<double>(), 1e-12);
    EXPECT_NEAR(0.5 * (length(frame.in) + length(frame.out)), expected[i][5].get<double>(), 1e-12);
  }
}

TEST(Walk, AClosedPathsFirstPointComesLastWithBothItsEdges) {
  const std::vector<Frame> frames = visited(Stops::points, 0.0, {{0, 0}, {4, 0}, {0, 3}}, true);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].index, 1U);
  EXPECT_EQ(frames[1].out, (Vec2{0, -3}));
  EXPECT_EQ(frames[2].index, 0U);
  EXPECT_EQ(frames[2].point, (Vec2{0, 0}));
  EXPECT_EQ(frames[2].in, (Vec2{0, -3}));
  EXPECT_EQ(frames[2].out, (Vec2{4, 0}));
}

TEST(Walk, ATurnOfHalfACircleLooksAhead) {
  const std::vector<Frame> frames = visited(Stops::points, 0.0, {{0, 0}, {2, 0}, {1, 0}}, false);
  EXPECT_EQ(tangent_of(frames[1]), (Vec2{-1, 0}));
}

TEST(Walk, DotsHaveNoDirection) {
  for (const Stops stops : {Stops::points, Stops::midpoints, Stops::lengths}) {
    const std::vector<Frame> frames = visited(stops, 1.0, {{5, 6}}, false);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].point, (Vec2{5, 6}));
    EXPECT_EQ(frames[0].out, (Vec2{0, 0}));
  }
}

TEST(Walk, MidpointsAreOneAnEdge) {
  EXPECT_EQ(visited(Stops::midpoints, 0.0, {{0, 0}, {2, 0}, {2, 4}}, false).size(), 2U);
  const std::vector<Frame> closed = visited(Stops::midpoints, 0.0, {{0, 0}, {2, 0}, {2, 4}}, true);
  ASSERT_EQ(closed.size(), 3U);
  EXPECT_EQ(closed[2].point, (Vec2{1, 2}));
  EXPECT_EQ(closed[2].index, 2U);
  EXPECT_EQ(closed[2].in, closed[2].out);
}

TEST(Walk, LengthsGoAroundCorners) {
  // 10 long: at 0, 3, 6 and 9; the end of a closed line of 12 is its beginning.
  const std::vector<Vec2> line{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  const std::vector<Frame> open = visited(Stops::lengths, 3.0, line, false);
  ASSERT_EQ(open.size(), 4U);
  EXPECT_EQ(open[1].point, (Vec2{3, 0}));
  EXPECT_LT(distance(open[2].point, {4, 2}), 1e-12);
  EXPECT_LT(distance(open[3].point, {1, 2}), 1e-12);
  EXPECT_EQ(open[3].index, 3U);
  EXPECT_EQ(visited(Stops::lengths, 3.0, line, true).size(), 4U);
  EXPECT_EQ(visited(Stops::lengths, 0.1, line, true).size(), 120U);
  EXPECT_EQ(visited(Stops::lengths, 1000.0, line, true).size(), 1U);
}

TEST(Walk, LengthsAreEvenWhateverTheEdges) {
  std::vector<Vec2> wave;
  for (int i = 0; i <= 3000; ++i) wave.push_back({0.001 * i, 0.0});
  const std::vector<Frame> frames = visited(Stops::lengths, 0.0437, wave, false);
  ASSERT_EQ(frames.size(), 69U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_NEAR(frames[i].point.x, 0.0437 * static_cast<double>(i), 1e-11);
  }
}

TEST(Walk, EndsAtTheFirstStop) {
  int left = 2;
  Walk walk(Stops::points, 0.0, [&](const Frame&) { return --left == 0 ? Flow::stop : Flow::go; });
  walk.begin(false);
  const std::vector<Vec2> points(10, Vec2{1, 1});
  EXPECT_EQ(walk.points(points), Flow::stop);
  EXPECT_EQ(left, 0);
}

}  // namespace
}  // namespace burin::primitives
