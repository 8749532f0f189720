#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <burin/data/flatten.hpp>

namespace burin::data {
namespace {

double distance_to_chord(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double squared = length_squared(d);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

double distance_to_polyline(Vec2 p, Vec2 start, const std::vector<Vec2>& points) {
  double least = distance(p, start);
  Vec2 from = start;
  for (const Vec2 to : points) {
    least = std::min(least, distance_to_chord(p, from, to));
    from = to;
  }
  return least;
}

Vec2 cubic_at(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double t) {
  const double s = 1.0 - t;
  return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
}

class Random {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  Vec2 point() { return {(*this)(-10, 10), (*this)(-10, 10)}; }

 private:
  std::mt19937_64 engine_{7};
};

TEST(Flatten, CubicKeepsToItsTolerance) {
  Random random;
  for (int n = 0; n < 200; ++n) {
    const Vec2 a = random.point(), b = random.point(), c = random.point(), d = random.point();
    const double tolerance = random(0.0005, 1.0);
    std::vector<Vec2> points;
    flatten_cubic(a, b, c, d, tolerance, points);
    ASSERT_EQ(points.back(), d);
    for (int i = 0; i <= 200; ++i) {
      ASSERT_LE(distance_to_polyline(cubic_at(a, b, c, d, i / 200.0), a, points), tolerance * (1 + 1e-9));
    }
  }
}

TEST(Flatten, QuadraticIsTheCubicOfTheSameCurve) {
  Random random;
  for (int n = 0; n < 200; ++n) {
    const Vec2 a = random.point(), q = random.point(), d = random.point();
    const double tolerance = random(0.0005, 1.0);
    std::vector<Vec2> points;
    flatten_quadratic(a, q, d, tolerance, points);
    ASSERT_EQ(points.back(), d);
    for (int i = 0; i <= 200; ++i) {
      const Vec2 p = cubic_at(a, lerp(a, q, 2.0 / 3.0), lerp(d, q, 2.0 / 3.0), d, i / 200.0);
      ASSERT_LE(distance_to_polyline(p, a, points), tolerance * (1 + 1e-9));
    }
  }
}

TEST(Flatten, StraightCurvesAreOneChord) {
  std::vector<Vec2> points;
  flatten_cubic({0, 0}, {1, 1}, {2, 2}, {3, 3}, 1e-6, points);
  flatten_quadratic({3, 3}, {4, 3}, {5, 3}, 1e-6, points);
  EXPECT_EQ(points, (std::vector<Vec2>{{3, 3}, {5, 3}}));
}

TEST(Flatten, HalfCircleEitherWay) {
  for (const bool sweep : {false, true}) {
    std::vector<Vec2> points;
    flatten_arc({-5, 0}, {{5, 5}, 0.0, false, sweep}, {5, 0}, 0.001, points);
    EXPECT_EQ(points.back(), (Vec2{5, 0}));
    double lowest = 0.0, highest = 0.0;
    for (const Vec2 p : points) {
      EXPECT_NEAR(length(p), 5.0, 1e-12);
      lowest = std::min(lowest, p.y);
      highest = std::max(highest, p.y);
    }
    // SVG: sweep 1 runs towards positive angles, over negative y from the left to the right with y down.
    EXPECT_NEAR(sweep ? lowest : highest, sweep ? -5.0 : 5.0, 0.001);
    EXPECT_EQ(sweep ? highest : lowest, 0.0);
  }
}

TEST(Flatten, TheFourArcsBetweenTwoPoints) {
  // Circles of radius 5 through (0, 0) and (6, 0): centers (3, 4) and (3, -4).
  struct Case {
    bool large, sweep;
    Vec2 center;
    double angle;
  };
  const double small = 2.0 * std::asin(0.6);
  for (const Case& c : {Case{false, false, {3, -4}, small}, Case{false, true, {3, 4}, small},
                        Case{true, false, {3, 4}, 2 * std::numbers::pi - small},
                        Case{true, true, {3, -4}, 2 * std::numbers::pi - small}}) {
    std::vector<Vec2> points;
    flatten_arc({0, 0}, {{5, 5}, 0.0, c.large, c.sweep}, {6, 0}, 1e-5, points);
    double travelled = 0.0;
    Vec2 before{0, 0};
    for (const Vec2 p : points) {
      EXPECT_NEAR(distance(p, c.center), 5.0, 1e-12);
      travelled += distance(before, p);
      before = p;
    }
    EXPECT_NEAR(travelled, 5.0 * c.angle, 1e-3);
  }
}

TEST(Flatten, TurnedEllipseKeepsItsEquationAndTolerance) {
  Random random;
  for (int n = 0; n < 300; ++n) {
    const double turn = random(-400, 400), tolerance = random(0.001, 0.5);
    const Vec2 radii{random(0.5, 20), random(0.5, 20)}, start = random.point(), end = random.point();
    const bool large = random(0, 1) < 0.5, sweep = random(0, 1) < 0.5;
    std::vector<Vec2> coarse, fine;
    flatten_arc(start, {radii, turn, large, sweep}, end, tolerance, coarse);
    flatten_arc(start, {radii, turn, large, sweep}, end, 0.0, fine);
    ASSERT_EQ(coarse.back(), end);
    ASSERT_EQ(fine.size(), static_cast<std::size_t>(max_chords));
    for (const Vec2 p : fine) ASSERT_LE(distance_to_polyline(p, start, coarse), tolerance * (1 + 1e-9) + 1e-9);
  }
}

TEST(Flatten, ArcsThatAreNone) {
  std::vector<Vec2> points;
  flatten_arc({1, 1}, {{5, 5}, 0, true, true}, {1, 1}, 0.1, points);
  EXPECT_TRUE(points.empty()) << "ends where it starts";
  flatten_arc({1, 1}, {{0, 5}, 0, true, true}, {2, 3}, 0.1, points);
  flatten_arc({1, 1}, {{5, 1e-300}, 0, true, true}, {3, 3}, 0.1, points);
  EXPECT_EQ(points, (std::vector<Vec2>{{2, 3}, {3, 3}}));
}

TEST(Flatten, SmallRadiiGrowToAHalfCircle) {
  std::vector<Vec2> points;
  flatten_arc({0, 0}, {{-1e-6, 1e-6}, 30, false, true}, {8, 0}, 0.001, points);
  for (const Vec2 p : points) EXPECT_NEAR(distance(p, {4, 0}), 4.0, 1e-9);
}

TEST(Flatten, AnArcOfAHugeCircleIsAStraightLine) {
  std::vector<Vec2> points;
  flatten_arc({0, 0}, {{1e12, 1e12}, 17, false, true}, {8, 6}, 1e-15, points);
  for (const Vec2 p : points) EXPECT_LE(distance_to_chord(p, {0, 0}, {8, 6}), 1e-9);
}

TEST(Flatten, ChordsAreBoundedWhateverTheTolerance) {
  for (const double tolerance : {0.0, 1e-300, -1.0}) {
    std::vector<Vec2> points;
    flatten_cubic({0, 0}, {1e12, 0}, {0, 1e12}, {1e12, 1e12}, tolerance, points);
    flatten_quadratic({0, 0}, {1e12, 0}, {1e12, 1e12}, tolerance, points);
    flatten_arc({0, 0}, {{1e12, 1e-99}, 3, true, true}, {1e12, 1e12}, tolerance, points);
    EXPECT_LE(points.size(), 3U * max_chords);
    for (const Vec2 p : points) EXPECT_TRUE(is_finite(p));
  }
}

}  // namespace
}  // namespace burin::data
