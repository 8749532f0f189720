#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>

#include <burin/passes/items.hpp>
#include <burin/passes/region_filter.hpp>

#include "support/polygons.hpp"
#include "support/random_paths.hpp"

/// What it costs to hide lines behind shapes, in the library.
namespace burin::test {
namespace {

/// Polygons all over a page of A4, each over those before it.
std::vector<DrawnPath> scales(std::size_t count, int corners, double radius_mm) {
  Dice dice(count);
  std::vector<DrawnPath> paths;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 centre{dice.between(0, 210), dice.between(0, 297)};
    DrawnPath path{{.closed = true}, {{}}};
    for (int corner = 0; corner < corners; ++corner) {
      const double angle = 2.0 * std::numbers::pi * corner / corners;
      path.contours[0].push_back(centre + radius_mm * Vec2{std::cos(angle), std::sin(angle)});
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

/// Seconds to hide the paths behind one another; the visible length goes to `seen_mm`.
double occlusion_s(const std::vector<DrawnPath>& paths, double& seen_mm) {
  const auto begin = std::chrono::steady_clock::now();
  passes::Regions regions;
  passes::Regions::Item item = 0;
  {
    passes::RegionRecorder recorder(regions, item);
    passes::ClosedPaths areas(recorder, Paint::fill_nonzero);
    passes::ItemCounter counter(areas, item);
    EXPECT_EQ(draw(paths, counter), Flow::go);
  }
  regions.build_index();
  item = 0;
  Recorder recorder;
  passes::RegionFilter filter(recorder, regions, passes::Keep::outside, passes::Border::is_outside, item);
  passes::ItemCounter counter(filter, item);
  EXPECT_EQ(draw(paths, counter), Flow::go);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  seen_mm = stroke_length(recorder.recording());
  return taken.count();
}

TEST(OcclusionBench, TwentyThousandPolygonsTakeLessThanThreeSeconds) {
  for (const double radius_mm : {1.0, 3.0, 8.0}) {
    const auto paths = scales(20'000, 36, radius_mm);
    double seen_mm = 0.0;
    const double seconds = occlusion_s(paths, seen_mm);
    std::printf("20,000 36-gons of radius %3.0f mm: %6.3f s, %9.0f mm seen\n", radius_mm, seconds, seen_mm);
    EXPECT_LE(seconds, 3.0);
    EXPECT_GT(seen_mm, 1000.0);
  }
}

TEST(OcclusionBench, OneShapeOfManyCornersCostsLittleMore) {
  // A hundred thousand short lines behind one polygon of 100,000 corners.
  std::vector<DrawnPath> paths;
  Dice dice(7);
  for (int i = 0; i < 100'000; ++i) {
    const Vec2 at{dice.between(0, 210), dice.between(0, 297)};
    paths.push_back({{}, {{at, at + Vec2{dice.between(-1, 1), dice.between(-1, 1)}}}});
  }
  auto shape = scales(1, 100'000, 60.0);
  paths.push_back(std::move(shape.front()));
  double seen_mm = 0.0;
  const double seconds = occlusion_s(paths, seen_mm);
  std::printf("100,000 lines behind 100,000 corners: %6.3f s\n", seconds);
  EXPECT_LE(seconds, 3.0);
}

}  // namespace
}  // namespace burin::test
