#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <burin/passes/items.hpp>
#include <burin/passes/region_filter.hpp>
#include <burin/path/recording.hpp>

#include "support/polygons.hpp"
#include "support/random_paths.hpp"
#include "support/trace_sink.hpp"

namespace burin::passes {
namespace {

using test::contours_of;
using test::DrawnPath;
using test::signed_area;
using test::stroke_length;

using Contours = std::vector<std::vector<Vec2>>;

Contours square(Vec2 low, double side) {
  return {{low, {low.x + side, low.y}, {low.x + side, low.y + side}, {low.x, low.y + side}}};
}

Contours polygon(Vec2 centre, double radius, int corners) {
  Contours contours(1);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners + 0.1;
    contours[0].push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return contours;
}

/// Closed shapes of every kind: convex ones, stars that cross themselves, many corners, several contours.
Contours random_shape(test::Dice& dice) {
  const Vec2 centre{dice.between(0, 200), dice.between(0, 200)};
  const double radius = dice.between(1.0, dice.below(5) == 0 ? 120.0 : 20.0);
  if (dice.below(3) == 0) return polygon(centre, radius, 3 + static_cast<int>(dice.below(40)));
  Contours contours(1 + dice.below(3));
  for (std::vector<Vec2>& contour : contours) {
    for (std::size_t i = 3 + dice.below(dice.below(4) == 0 ? 100 : 8); i-- > 0;) {
      contour.push_back(centre + Vec2{dice.between(-radius, radius), dice.between(-radius, radius)});
    }
  }
  return contours;
}

Regions regions_of(const std::vector<Contours>& shapes, Paint rule = Paint::fill_nonzero) {
  Regions regions;
  for (std::size_t i = 0; i < shapes.size(); ++i) regions.add(i + 1, shapes[i], rule);
  regions.build_index();
  return regions;
}

Recording filtered(const std::vector<DrawnPath>& paths, const Regions& regions, Keep keep,
                   Border border = Border::is_outside, std::size_t span = SIZE_MAX) {
  Recorder recorder;
  Checked checked(recorder);
  RegionFilter filter(checked, regions, keep, border);
  EXPECT_EQ(test::draw(paths, filter, span), Flow::go);
  return recorder.take();
}

DrawnPath line(std::vector<Vec2> points, bool closed = false) {
  return {{.closed = closed}, {std::move(points)}};
}

TEST(RegionFilter, ALineThroughASquareIsCutAtItsBorders) {
  const Regions regions = regions_of({square({10, 10}, 10)});
  const DrawnPath path = line({{0, 15}, {30, 15}});
  EXPECT_EQ(contours_of(filtered({path}, regions, Keep::outside)),
            (Contours{{{0, 15}, {10, 15}}, {{20, 15}, {30, 15}}}));
  EXPECT_EQ(contours_of(filtered({path}, regions, Keep::inside)), (Contours{{{10, 15}, {20, 15}}}));
}

TEST(RegionFilter, TheRuleSaysWhatIsInside) {
  Contours ring = square({0, 0}, 30);
  ring.push_back(square({10, 10}, 10)[0]);
  const DrawnPath path = line({{-5, 15}, {35, 15}});
  EXPECT_NEAR(stroke_length(filtered({path}, regions_of({ring}, Paint::fill_nonzero), Keep::inside)), 30.0, 1e-12);
  EXPECT_NEAR(stroke_length(filtered({path}, regions_of({ring}, Paint::fill_evenodd), Keep::inside)), 20.0, 1e-12);
}

TEST(RegionFilter, BothHalvesMakeTheWholeAndLieWhereTheyShould) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::Dice dice(seed);
    std::vector<Contours> shapes(1 + dice.below(30));
    for (Contours& shape : shapes) shape = random_shape(dice);
    const Paint rule = dice.below(2) == 0 ? Paint::fill_nonzero : Paint::fill_evenodd;
    const Regions regions = regions_of(shapes, rule);
    const auto is_covered = [&](Vec2 at) {
      return std::any_of(shapes.begin(), shapes.end(), [&](const Contours& shape) {
        const int turns = test::winding(shape, at);
        return rule == Paint::fill_evenodd ? turns % 2 != 0 : turns != 0;
      });
    };
    for (DrawnPath& path : test::random_paths(seed, 1, 4)) {
      path.head.paint = Paint::stroke;
      Recorder whole;
      (void)test::draw({path}, whole);
      const Recording seen = filtered({path}, regions, Keep::outside);
      const Recording hidden = filtered({path}, regions, Keep::inside);
      EXPECT_NEAR(stroke_length(seen) + stroke_length(hidden), stroke_length(whole.recording()),
                  1e-9 * (1.0 + stroke_length(whole.recording())));
      for (const auto& [part, covered] : {std::pair(&seen, false), std::pair(&hidden, true)}) {
        for (const std::vector<Vec2>& points : contours_of(*part)) {
          for (std::size_t i = 1; i < points.size(); ++i) {
            if (distance(points[i - 1], points[i]) < 1e-6) continue;
            EXPECT_EQ(is_covered(lerp(points[i - 1], points[i], 0.5)), covered) << "seed " << seed;
          }
        }
      }
    }
  }
}

TEST(RegionFilter, ShapesWithACommonBorderLeaveNothingBetweenThem) {
  std::vector<Contours> tiles;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) tiles.push_back(square({i * 0.7, j * 0.7}, 0.7));
  }
  const Regions regions = regions_of(tiles);
  test::Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const DrawnPath path = line(
        {{dice.between(0.01, 6.99), dice.between(0.01, 6.99)}, {dice.between(0.01, 6.99), dice.between(0.01, 6.99)}});
    EXPECT_TRUE(filtered({path}, regions, Keep::outside).empty());
  }
}

TEST(RegionFilter, ALineAlongABorderGoesToTheSideThatIsSaid) {
  const Regions regions = regions_of({square({0, 0}, 10), polygon({40, 0}, 7, 5)});
  const DrawnPath along = line({{0, 0}, {10, 0}, {10, 10}});
  const DrawnPath outline = line(polygon({40, 0}, 7, 5)[0], true);
  for (const DrawnPath& path : {along, outline}) {
    for (const auto& [keep, border] :
         {std::pair(Keep::outside, Border::is_outside), std::pair(Keep::inside, Border::is_inside)}) {
      const Recording kept = filtered({path}, regions, keep, border);
      ASSERT_EQ(kept.paths().size(), 1U);
      EXPECT_EQ(kept.paths()[0].head.closed, path.head.closed);
      EXPECT_EQ(contours_of(kept), path.contours);
    }
    EXPECT_TRUE(filtered({path}, regions, Keep::outside, Border::is_inside).empty());
    EXPECT_TRUE(filtered({path}, regions, Keep::inside, Border::is_outside).empty());
  }
}

TEST(RegionFilter, AClosedStrokeCutOnceIsOnePiece) {
  const Regions regions = regions_of({square({5, -2}, 4)});
  const Recording kept = filtered({line(square({0, 0}, 20)[0], true)}, regions, Keep::outside);
  ASSERT_EQ(kept.paths().size(), 1U);
  EXPECT_FALSE(kept.paths()[0].head.closed);
  EXPECT_EQ(contours_of(kept), (Contours{{{9, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}, {5, 0}}}));
}

TEST(RegionFilter, ADotIsThereOrNot) {
  const Regions regions = regions_of({square({0, 0}, 10)});
  EXPECT_EQ(contours_of(filtered({line({{5, 5}}), line({{15, 5}})}, regions, Keep::outside)), (Contours{{{15, 5}}}));
  EXPECT_EQ(contours_of(filtered({line({{5, 5}}), line({{15, 5}})}, regions, Keep::inside)), (Contours{{{5, 5}}}));
}

TEST(RegionFilter, WithoutRegionsAllIsOutside) {
  const Regions none = regions_of({});
  for (const DrawnPath& path : test::random_paths(3, 1, 12)) {
    EXPECT_EQ(contours_of(filtered({path}, none, Keep::outside)), path.contours);
    EXPECT_TRUE(filtered({path}, none, Keep::inside).empty());
  }
}

TEST(RegionFilter, SpansDoNotMatter) {
  test::Dice dice(8);
  std::vector<Contours> shapes(12);
  for (Contours& shape : shapes) shape = random_shape(dice);
  const Regions regions = regions_of(shapes);
  const auto paths = test::random_paths(8, 1, 10);
  const Recording whole = filtered(paths, regions, Keep::outside);
  EXPECT_EQ(contours_of(filtered(paths, regions, Keep::outside, Border::is_outside, 1)), contours_of(whole));
  EXPECT_EQ(contours_of(filtered(paths, regions, Keep::outside, Border::is_outside, 7)), contours_of(whole));
}

TEST(RegionFilter, StopsWhenTheSinkDoes) {
  const Regions regions = regions_of({square({10, 10}, 10), square({30, 10}, 10)});
  std::vector<DrawnPath> paths{line({{0, 15}, {50, 15}}), line(square({5, 5}, 50)[0], true)};
  paths.push_back(line(square({5, 5}, 50)[0], true));
  paths.back().head.paint = Paint::fill_nonzero;
  const auto trace = [&](std::size_t calls, Flow expected) {
    test::TraceSink sink(calls);
    RegionFilter filter(sink, regions, Keep::outside, Border::is_outside);
    EXPECT_EQ(test::draw(paths, filter), expected) << calls;
    return sink.trace();
  };
  const std::string whole = trace(SIZE_MAX, Flow::go);
  const auto calls = static_cast<std::size_t>(std::count(whole.begin(), whole.end(), ';'));
  ASSERT_GT(calls, 12U);
  for (std::size_t call = 1; call <= calls; ++call) {
    const std::string stopped = trace(call, Flow::stop);
    EXPECT_EQ(static_cast<std::size_t>(std::count(stopped.begin(), stopped.end(), ';')), call);
    EXPECT_TRUE(whole.starts_with(stopped));
  }
}

TEST(RegionFilter, FillsBecomeWhatIsLeftOfTheirArea) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    test::Dice dice(seed);
    std::vector<Contours> shapes(1 + dice.below(6));
    for (Contours& shape : shapes) shape = random_shape(dice);
    const Regions regions = regions_of(shapes);
    const DrawnPath path{{.paint = dice.below(2) == 0 ? Paint::fill_nonzero : Paint::fill_evenodd, .closed = true},
                         random_shape(dice)};
    const auto is_in = [&](const Contours& contours, Vec2 at) {
      const int turns = test::winding(contours, at);
      return path.head.paint == Paint::fill_evenodd ? turns % 2 != 0 : turns != 0;
    };
    const Contours left = contours_of(filtered({path}, regions, Keep::outside));
    const Contours under = contours_of(filtered({path}, regions, Keep::inside));
    for (int i = 0; i < 300; ++i) {
      const Vec2 at{dice.between(0, 200), dice.between(0, 200)};
      const bool covered = std::any_of(shapes.begin(), shapes.end(),
                                       [&](const Contours& shape) { return test::winding(shape, at) != 0; });
      EXPECT_EQ(is_in(left, at), is_in(path.contours, at) && !covered) << "seed " << seed;
      EXPECT_EQ(is_in(under, at), is_in(path.contours, at) && covered) << "seed " << seed;
    }
  }
}

TEST(RegionFilter, AFillThatNothingTouchesStaysAsItIs) {
  const Regions regions = regions_of({square({50, 50}, 10)});
  DrawnPath path{{.paint = Paint::fill_evenodd, .closed = true}, polygon({10, 10}, 5, 7)};
  EXPECT_EQ(contours_of(filtered({path}, regions, Keep::outside)), path.contours);
}

/// Draws the closed paths and lines as they hide one another, each an item.
Recording occluded(const std::vector<DrawnPath>& paths, Keep keep) {
  Regions regions;
  {
    Regions::Item item = 0;
    RegionRecorder recorder(regions, item);
    ClosedPaths areas(recorder, Paint::fill_nonzero);
    ItemCounter counter(areas, item);
    EXPECT_EQ(test::draw(paths, counter), Flow::go);
  }
  regions.build_index();
  Recorder recorder;
  Checked checked(recorder);
  Regions::Item item = 0;
  RegionFilter filter(checked, regions, keep, Border::is_outside, item);
  ItemCounter counter(filter, item);
  EXPECT_EQ(test::draw(paths, counter), Flow::go);
  return recorder.take();
}

TEST(Occlusion, WhatComesLaterHidesWhatCameBefore) {
  const std::vector<DrawnPath> paths{line({{-5, 5}, {30, 5}}), line(square({0, 0}, 10)[0], true),
                                     line(square({5, 5}, 10)[0], true), line({{-5, 7}, {30, 7}})};
  EXPECT_EQ(contours_of(occluded(paths, Keep::outside)), (Contours{{{-5, 5}, {0, 5}},
                                                                   {{10, 5}, {30, 5}},
                                                                   {{5, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 5}},
                                                                   paths[2].contours[0],
                                                                   paths[3].contours[0]}));
  EXPECT_EQ(contours_of(occluded(paths, Keep::inside)), (Contours{{{0, 5}, {10, 5}}, {{10, 5}, {10, 10}, {5, 10}}}));
}

TEST(Occlusion, AFigureIsOneItemAndDoesNotHideItsOwnVeins) {
  Recorder leaf;
  ASSERT_EQ(test::draw({line({{0, -3}, {0, 3}}), line(square({-2, -2}, 4)[0], true)}, leaf), Flow::go);
  const Figure figure(leaf.take());
  const auto draw_two = [&](PathSink& sink) {
    EXPECT_EQ(sink.place({}, figure, {}), Flow::go);
    EXPECT_EQ(sink.place({}, figure, {1, 0, 0, 1, 2, 0}), Flow::go);
  };
  Regions regions;
  Regions::Item item = 0;
  RegionRecorder masks(regions, item);
  ClosedPaths areas(masks, Paint::fill_nonzero);
  ItemCounter first_run(areas, item);
  draw_two(first_run);
  regions.build_index();
  EXPECT_EQ(regions.size(), 2U);
  item = 0;
  Recorder recorder;
  RegionFilter filter(recorder, regions, Keep::outside, Border::is_outside, item);
  ItemCounter second_run(filter, item);
  draw_two(second_run);
  // The second leaf covers x from 0 to 4: along its border run the first one's vein and parts of its outline.
  EXPECT_EQ(contours_of(recorder.recording()), (Contours{{{0, -3}, {0, 3}},
                                                         {{2, 2}, {-2, 2}, {-2, -2}, {2, -2}},
                                                         {{2, -3}, {2, 3}},
                                                         {{0, -2}, {4, -2}, {4, 2}, {0, 2}}}));
}

}  // namespace
}  // namespace burin::passes
