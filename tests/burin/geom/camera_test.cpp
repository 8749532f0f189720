#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/geom/camera.hpp>

namespace burin {
namespace {

Vec3 random_point(std::uint64_t seed, std::uint64_t i) {
  return {uniform_symmetric(seed, i, 1), uniform_symmetric(seed, i, 2), uniform_symmetric(seed, i, 3)};
}

void expect_near(Vec2 p, Vec2 expected, double tolerance = 1e-12) {
  EXPECT_NEAR(p.x, expected.x, tolerance);
  EXPECT_NEAR(p.y, expected.y, tolerance);
}

TEST(Across, IsRightHandedAndFallsBackOnAnAxis) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Vec3 d = random_point(1, i);
    const Vec3 up = i % 3 == 0 ? 2.5 * d : i % 3 == 1 ? Vec3{} : random_point(2, i);
    const auto [right, above] = across(d, up);
    EXPECT_NEAR(length(right), 1.0, 1e-12);
    EXPECT_NEAR(length(above), 1.0, 1e-12);
    EXPECT_NEAR(dot(right, d), 0.0, 1e-12);
    EXPECT_NEAR(dot(cross(right, above), d), -length(d), 1e-12);
  }
  EXPECT_EQ(across({0, 0, 5}, {0, 0, 1}).right, (Vec3{0, 1, 0})) << "of equals the first axis: z x x = y";
}

TEST(Camera, SeesThePlaneFromAboveAsItIs) {
  const Camera camera({.eye = {0, 0, 7}, .target = {}, .up = {0, 0, 1}});
  expect_near(camera({3, -4, 100}), {3, -4});
  const Camera front({.eye = {0, -2, 0}, .target = {}, .up = {0, 0, 1}, .scale = 2});
  expect_near(front({3, 9, -4}), {6, -8});
}

/// As the reference's program computes them (forms3d.json, camera), with scale 200 / (2 tan 17.5 degrees) and 200 / 4.
TEST(Camera, IsTheReferences) {
  const Vec3 eye{3, 2.2, 4};
  const double distance = std::sqrt(9 + 2.2 * 2.2 + 16);
  const double tan_half = std::tan(17.5 * 3.14159265358979323846 / 180);
  const Camera perspective({Projection::perspective, eye, {}, {0, 1, 0}, 200 / (2 * tan_half) / distance});
  expect_near(perspective({.05, .1, .02}), {1.6505760992383316, 4.303613498409157}, 1e-9);
  expect_near(perspective({-.25, .1, .1}), {-15.03016374078813, 6.9209976668186215}, 1e-9);
  EXPECT_NEAR(1 / perspective.depth({-.25, .1, .1}), 0.1822689393893582, 1e-12);
  const Camera parallel({Projection::orthographic, eye, {}, {0, 1, 0}, 50});
  expect_near(parallel({.1, -.45, -.2}), {10.000000000000032, -18.580895158182166}, 1e-9);
}

TEST(Camera, PerspectiveShowsTheTargetsDistanceAtItsScale) {
  const Camera camera({Projection::perspective, {0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 3});
  expect_near(camera({1, 0, 2}), {3, 6});
  expect_near(camera({1, 10, 2}), {1.5, 3});
}

TEST(Camera, PicturesOfBallsLieInTheirDiscs) {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Camera camera({projection, {1, -3, 2}, {0, 0.5, 0}, {0, 0, 1}, 0.7});
    double fullest = 0.0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Vec3 centre = random_point(3, i);
      const double radius = 1.5 * uniform(4, i);
      const double disc = camera.picture_radius(centre, radius);
      if (!std::isfinite(disc)) {
        EXPECT_LE(camera.depth(centre), radius);
        continue;
      }
      for (std::uint64_t k = 0; k < 50; ++k) {
        const Vec3 p = centre + radius * unit(random_point(5 + i, k));
        const double away = distance(camera(p), camera(centre));
        ASSERT_LE(away, disc * (1 + 1e-12));
        fullest = std::max(fullest, away / disc);
      }
    }
    EXPECT_GT(fullest, 0.95) << "the bound is not a loose one";
  }
}

TEST(Camera, PicturesOfWhatIsNearAChordAreNearItsPicture) {
  const Camera camera({Projection::perspective, {1, -3, 2}, {}, {0, 0, 1}, 1});
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Vec3 a = random_point(6, i);
    const Vec3 b = random_point(7, i);
    const double error = 0.1 * uniform(8, i);
    const double bound = camera.picture_error(a, b, 0.1, error);
    for (std::uint64_t k = 0; k < 20; ++k) {
      const Vec3 on_chord = lerp(a, b, uniform(9, i, k));
      const Vec3 p = on_chord + error * unit(random_point(10 + i, k));
      EXPECT_LE(distance(camera(p), camera(on_chord)), bound * (1 + 1e-12));
    }
  }
  EXPECT_EQ(camera.picture_error({1, -3, 2}, {}, 0.1, 0.1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace burin
