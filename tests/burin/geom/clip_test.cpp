#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <burin/geom/clip.hpp>

namespace burin {
namespace {

const Box2 box{{0.0, 0.0}, {10.0, 5.0}};

double area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

std::vector<Vec2> clipped(std::vector<Vec2> polygon) {
  std::vector<Vec2> spare;
  clip_polygon(polygon, spare, box);
  return polygon;
}

TEST(Clip, SegmentInsideIsUnchanged) {
  const auto part = clip_segment({1.0, 1.0}, {9.0, 0.1}, box);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, (Vec2{1.0, 1.0}));
  EXPECT_EQ(part->to, (Vec2{9.0, 0.1}));
}

TEST(Clip, SegmentThroughTheBoxIsCutAtItsBorders) {
  const auto part = clip_segment({-5.0, 0.0}, {15.0, 5.0}, box);
  ASSERT_TRUE(part);
  EXPECT_DOUBLE_EQ(part->from.x, 0.0);
  EXPECT_DOUBLE_EQ(part->from.y, 1.25);
  EXPECT_DOUBLE_EQ(part->to.x, 10.0);
  EXPECT_DOUBLE_EQ(part->to.y, 3.75);
}

TEST(Clip, SegmentBesideTheBoxIsNothing) {
  EXPECT_FALSE(clip_segment({-5.0, -1.0}, {15.0, -1.0}, box));
  EXPECT_FALSE(clip_segment({-3.0, 1.0}, {1.0, -3.0}, box));
  EXPECT_FALSE(clip_segment({11.0, 4.0}, {9.0, 7.0}, box));
}

TEST(Clip, TheLargestNumbersDoNotOverflow) {
  const auto part = clip_segment({-1.7e308, 2.0}, {1.7e308, 2.0}, box);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, (Vec2{0.0, 2.0}));
  EXPECT_EQ(part->to, (Vec2{10.0, 2.0}));
  EXPECT_DOUBLE_EQ(area(clipped({{-1.7e308, -1.7e308}, {1.7e308, -1.7e308}, {1.7e308, 1.7e308}, {-1.7e308, 1.7e308}})),
                   50.0);
}

// Each point of the segment that lies in the box lies in the part, and the other way round.
TEST(Clip, RandomSegmentsAgreeWithTheirPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-15.0, 20.0);
  for (int run = 0; run < 2000; ++run) {
    const Vec2 a{any(random), any(random)};
    const Vec2 b{any(random), any(random)};
    const auto part = clip_segment(a, b, box);
    for (int i = 0; i <= 100; ++i) {
      const Vec2 p = lerp(a, b, i / 100.0);
      const bool in_part = part && dot(p - part->from, part->to - part->from) >= -1e-9 &&
                           dot(p - part->to, part->from - part->to) >= -1e-9;
      if (box.grown(-1e-6).contains(p)) {
        ASSERT_TRUE(in_part) << run;
      }
      if (!box.grown(1e-6).contains(p)) {
        ASSERT_FALSE(in_part) << run;
      }
    }
  }
}

TEST(Clip, PolygonKeepsTheAreaInsideTheBox) {
  EXPECT_DOUBLE_EQ(area(clipped({{-10.0, -10.0}, {5.0, -10.0}, {5.0, 20.0}, {-10.0, 20.0}})), 25.0);
  EXPECT_DOUBLE_EQ(area(clipped({{0.0, 0.0}, {20.0, 0.0}, {0.0, 10.0}})), 50.0 - 0.0);
  EXPECT_DOUBLE_EQ(area(clipped({{20.0, 0.0}, {30.0, 0.0}, {30.0, 5.0}})), 0.0);
}

TEST(Clip, PolygonAroundTheBoxTwiceCoversItTwice) {
  const std::vector<Vec2> once = {{-1.0, -1.0}, {11.0, -1.0}, {11.0, 6.0}, {-1.0, 6.0}};
  std::vector<Vec2> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  EXPECT_DOUBLE_EQ(area(clipped(twice)), 100.0);
}

}  // namespace
}  // namespace burin
