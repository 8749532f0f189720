#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/passes/crop.hpp>
#include <burin/passes/items.hpp>
#include <burin/passes/region_filter.hpp>
#include <burin/path/recording.hpp>

#include "renderers/programs.hpp"
#include "support/polygons.hpp"
#include "support/random_paths.hpp"

/// Hidden lines against shapely, an independent library of polygons.
namespace burin::test {
namespace {

/// A polygon that does not cross itself: star-shaped about its centre.
std::vector<Vec2> random_polygon(Dice& dice) {
  const Vec2 centre{dice.between(0, 200), dice.between(0, 200)};
  const double radius = dice.between(1.0, 40.0);
  std::vector<Vec2> points;
  const std::size_t corners = 3 + dice.below(40);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back(centre + dice.between(0.3, 1.0) * radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

std::vector<DrawnPath> random_scene(std::uint64_t seed, std::size_t count) {
  Dice dice(seed);
  std::vector<DrawnPath> paths;
  for (std::size_t i = 0; i < count; ++i) {
    if (dice.below(3) == 0) {
      paths.push_back({{.closed = true}, {random_polygon(dice)}});
      continue;
    }
    std::vector<Vec2> points;
    for (std::size_t p = 2 + dice.below(4); p-- > 0;) points.push_back({dice.between(0, 200), dice.between(0, 200)});
    paths.push_back({{}, {points}});
  }
  return paths;
}

std::vector<double> lengths_by_shapely(const TemporaryFolder& folder, const std::vector<DrawnPath>& paths) {
  std::ofstream scene(folder.file("scene"));
  for (const DrawnPath& path : paths) {
    scene << (path.head.closed ? "shape" : "line");
    for (const Vec2 p : path.contours[0]) scene << fmt::format(" {:.17g} {:.17g}", p.x, p.y);
    scene << '\n';
  }
  scene.close();
  std::istringstream out(
      run_in(folder, {"sh", "-c", "/usr/bin/python3 '" BURIN_SOURCE_DIR "/tests/renderers/shapely_lengths.py' < scene"})
          .out);
  return {std::istream_iterator<double>(out), {}};
}

/// The lengths of the open paths as they are seen or hidden.
std::vector<double> our_lengths(const std::vector<DrawnPath>& paths, passes::Keep keep) {
  passes::Regions regions;
  passes::Regions::Item item = 0;
  passes::RegionRecorder masks(regions, item);
  passes::ClosedPaths areas(masks, Paint::fill_nonzero);
  passes::ItemCounter first_run(areas, item);
  EXPECT_EQ(draw(paths, first_run), Flow::go);
  regions.build_index();
  std::vector<double> lengths;
  item = 0;
  for (const DrawnPath& path : paths) {
    Recorder recorder;
    passes::RegionFilter filter(recorder, regions, keep, passes::Border::is_outside, item);
    passes::ItemCounter counter(filter, item);
    EXPECT_EQ(draw({path}, counter), Flow::go);
    if (!path.head.closed) lengths.push_back(stroke_length(recorder.recording()));
  }
  return lengths;
}

double length_of(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

TEST(Shapely, SeesTheSameLengthsOfThousandsOfLines) {
  const TemporaryFolder folder;
  std::size_t lines = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const auto paths = random_scene(seed, 200);
    const auto theirs = lengths_by_shapely(folder, paths);
    const auto seen = our_lengths(paths, passes::Keep::outside);
    const auto hidden = our_lengths(paths, passes::Keep::inside);
    ASSERT_EQ(theirs.size(), seen.size());
    std::size_t line = 0;
    for (const DrawnPath& path : paths) {
      if (path.head.closed) continue;
      EXPECT_NEAR(seen[line], theirs[line], 1e-6) << "seed " << seed << ", line " << line;
      EXPECT_NEAR(seen[line] + hidden[line], length_of(path.contours[0]), 1e-6);
      ++line;
    }
    lines += line;
  }
  EXPECT_GT(lines, 3000U);
}

TEST(Shapely, CropsToTheSameLengths) {
  const TemporaryFolder folder;
  const Box2 box{{40, 50}, {150, 120}};
  const std::vector<Vec2> outline{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  std::vector<DrawnPath> paths = random_scene(99, 2000);
  std::erase_if(paths, [](const DrawnPath& path) { return path.head.closed; });
  auto with_box = paths;
  with_box.push_back({{.closed = true}, {outline}});
  const auto outside = lengths_by_shapely(folder, with_box);
  ASSERT_EQ(outside.size(), paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Recorder recorder;
    passes::Crop crop(recorder, box);
    EXPECT_EQ(draw({paths[i]}, crop), Flow::go);
    EXPECT_NEAR(stroke_length(recorder.recording()), length_of(paths[i].contours[0]) - outside[i], 1e-6);
  }
}

}  // namespace
}  // namespace burin::test
