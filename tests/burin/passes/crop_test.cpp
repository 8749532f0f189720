#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <burin/passes/crop.hpp>
#include <burin/path/recording.hpp>

#include "support/polygons.hpp"
#include "support/random_paths.hpp"
#include "support/trace_sink.hpp"

namespace burin::passes {
namespace {

using test::contours_of;
using test::DrawnPath;
using test::winding;

const Box2 window{{20, 30}, {120, 90}};

Recording cropped(const std::vector<DrawnPath>& paths, const Box2& box, std::size_t span = SIZE_MAX) {
  Recorder recorder;
  Checked checked(recorder);
  Crop crop(checked, box);
  EXPECT_EQ(test::draw(paths, crop, span), Flow::go);
  return recorder.take();
}

/// The length of a segment inside the box: it is cut at every line of the border, and each part asked for its middle.
double length_inside(const Box2& box, Vec2 p, Vec2 q) {
  std::vector<double> cuts{0.0, 1.0};
  for (const double x : {box.low.x, box.high.x}) cuts.push_back((x - p.x) / (q.x - p.x));
  for (const double y : {box.low.y, box.high.y}) cuts.push_back((y - p.y) / (q.y - p.y));
  std::erase_if(cuts, [](double t) { return !(t >= 0.0 && t <= 1.0); });
  std::sort(cuts.begin(), cuts.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (box.contains(p + 0.5 * (cuts[i - 1] + cuts[i]) * (q - p))) sum += (cuts[i] - cuts[i - 1]) * distance(p, q);
  }
  return sum;
}

TEST(Crop, KeepsTheLengthInsideAndNothingElse) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    for (DrawnPath& path : test::random_paths(seed, 1, 6)) {
      path.head.paint = Paint::stroke;
      double expected = 0.0;
      double whole = 0.0;
      for (const std::vector<Vec2>& contour : path.contours) {
        for (std::size_t i = 0; i + (path.head.closed ? 0 : 1) < contour.size(); ++i) {
          expected += length_inside(window, contour[i], contour[(i + 1) % contour.size()]);
          whole += distance(contour[i], contour[(i + 1) % contour.size()]);
        }
      }
      const Recording kept = cropped({path}, window);
      double length = 0.0;
      for (const Recording::Path& piece : kept.paths()) {
        EXPECT_EQ(piece.contour_count, 1U);
        const auto points = kept.points(kept.contours(piece).front());
        for (std::size_t i = 0; i < points.size(); ++i) {
          EXPECT_TRUE(window.contains(points[i]));
          if (i > 0 || piece.head.closed) length += distance(points[i == 0 ? points.size() - 1 : i - 1], points[i]);
        }
      }
      EXPECT_NEAR(length, expected, 1e-9 * (1.0 + whole)) << "seed " << seed;
    }
  }
}

TEST(Crop, FillsKeepTheirWindingsInside) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Dice dice(seed);
    for (DrawnPath& path : test::random_paths(seed, 1, 4)) {
      path.head.paint = Paint::fill_nonzero;
      const Recording kept = cropped({path}, window);
      for (const Vec2 point : kept.all_points()) EXPECT_TRUE(window.grown(1e-9).contains(point));
      const auto contours = contours_of(kept);
      for (int i = 0; i < 40; ++i) {
        const Vec2 at{dice.between(window.low.x, window.high.x), dice.between(window.low.y, window.high.y)};
        EXPECT_EQ(winding(contours, at), winding(path.contours, at)) << "seed " << seed;
      }
    }
  }
}

TEST(Crop, SpansDoNotMatter) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto paths = test::random_paths(seed, 2, 8);
    const Recording whole = cropped(paths, window);
    for (const std::size_t span : {1U, 7U}) {
      const Recording parts = cropped(paths, window, span);
      EXPECT_EQ(parts.all_points(), whole.all_points());
      EXPECT_EQ(parts.paths().size(), whole.paths().size());
    }
  }
}

TEST(Crop, WhatLiesInsideStaysAsItIs) {
  const Box2 everything{{-1e9, -1e9}, {1e9, 1e9}};
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const DrawnPath& path : test::random_paths(seed, 1, 6)) {
      const Recording kept = cropped({path}, everything);
      EXPECT_EQ(contours_of(kept), path.contours);
      for (const Recording::Path& piece : kept.paths()) {
        EXPECT_EQ(piece.head.closed, path.head.closed || path.head.paint != Paint::stroke);
      }
    }
  }
}

std::string trace(const DrawnPath& path, std::size_t calls = SIZE_MAX) {
  test::TraceSink sink(calls);
  Crop crop(sink, {{0, 0}, {10, 10}});
  (void)test::draw({path}, crop);
  return sink.trace();
}

TEST(Crop, AClosedStrokeIsNotCutWhereItBegan) {
  const DrawnPath square{{.closed = true}, {{{5, 5}, {5, 20}, {-5, 20}, {-5, 5}}}};
  EXPECT_EQ(trace(square), "begin 0 ink stroke open 0; points 0,5 5,5 5,10; end; ");
  const DrawnPath cross{{.closed = true}, {{{5, 5}, {15, 5}, {15, 8}, {-5, 8}, {-5, 5}}}};
  EXPECT_EQ(trace(cross),
            "begin 0 ink stroke open 0; points 10,8 0,8; end; begin 0 ink stroke open 0; points 0,5 5,5 10,5; end; ");
}

TEST(Crop, DotsAndNeighboursOfTheBox) {
  EXPECT_EQ(trace({{}, {{{5, 5}}}}), "begin 0 ink stroke open 0; points 5,5; end; ");
  EXPECT_EQ(trace({{.closed = true}, {{{5, 5}}}}), "begin 0 ink stroke closed 0; points 5,5; end; ");
  EXPECT_EQ(trace({{}, {{{15, 5}}}}), "");
  EXPECT_EQ(trace({{}, {{{-5, 15}, {15, 15}, {15, -5}}}}), "");
  EXPECT_EQ(trace({{.paint = Paint::fill_evenodd}, {{{11, 5}, {20, 5}, {20, 9}}}}), "");
  EXPECT_EQ(trace({{.paint = Paint::fill_evenodd}, {{{-9, -9}, {30, -9}, {30, 30}, {-9, 30}}}}),
            "begin 0 ink fill_evenodd closed 0; points 10,0 10,10 0,10 0,0; end; ");
}

TEST(Crop, StopsWhenItIsToldTo) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (std::size_t calls = 1; calls < 9; ++calls) {
      const auto paths = test::random_paths(seed, 1, 8);
      test::TraceSink all;
      Crop whole(all, window);
      EXPECT_EQ(test::draw(paths, whole), Flow::go);
      test::TraceSink some(calls);
      Crop crop(some, window);
      const Flow flow = test::draw(paths, crop);
      EXPECT_EQ(all.trace().substr(0, some.trace().size()), some.trace());
      const auto made = std::count(some.trace().begin(), some.trace().end(), ';');
      EXPECT_EQ(flow == Flow::stop, made == static_cast<std::ptrdiff_t>(calls));
    }
  }
}

}  // namespace
}  // namespace burin::passes
