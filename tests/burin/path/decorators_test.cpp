#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

#include "support/trace_sink.hpp"

namespace burin {
namespace {

using test::TraceSink;

const std::vector<Vec2> corner{{0, 0}, {1, 0}, {1, 2}};

Flow draw_corner(PathSink& sink, const PathHead& head = {}) {
  if (sink.begin(head) == Flow::stop) return Flow::stop;
  if (sink.points(corner) == Flow::stop) return Flow::stop;
  return sink.end();
}

Figure corner_figure() {
  Recorder recorder;
  EXPECT_EQ(draw_corner(recorder), Flow::go);
  return Figure(recorder.take());
}

TEST(Mapped, MapsPointsAndPlacedFigures) {
  const Affine2 map{0, 2, -2, 0, 10, 0};
  TraceSink trace;
  Mapped mapped(trace, map);
  EXPECT_EQ(draw_corner(mapped), Flow::go);
  EXPECT_EQ(trace.trace(), "begin 0 ink stroke open 0; points 10,0 10,2 6,2; end; ");

  TraceSink placed;
  Mapped mapped_figure(placed, map);
  EXPECT_EQ(mapped_figure.place({}, corner_figure(), translation({1, 1})), Flow::go);
  EXPECT_EQ(placed.trace(), "begin 0 ink stroke open 0; points 8,2 8,4 4,4; end; ");
}

TEST(Mapped, SpansLongerThanItsBufferArriveWhole) {
  std::vector<Vec2> points(5000);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {static_cast<double>(i), 0.5};
  Recorder recorder;
  Mapped mapped(recorder, translation({1, 0}));
  ASSERT_EQ(mapped.begin({}), Flow::go);
  ASSERT_EQ(mapped.points(points), Flow::go);
  ASSERT_EQ(mapped.end(), Flow::go);
  const std::vector<Vec2>& got = recorder.recording().all_points();
  ASSERT_EQ(got.size(), points.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], points[i] + (Vec2{1, 0}));
}

TEST(Relabelled, KeepsOnlyWhatTheFigureDecides) {
  TraceSink trace;
  Relabelled relabelled(trace, {4, Role::mask, Paint::stroke, false, 9});
  EXPECT_EQ(draw_corner(relabelled, {1, Role::ink, Paint::fill_nonzero, true, 2}), Flow::go);
  EXPECT_EQ(trace.trace(), "begin 4 mask fill_nonzero closed 9; points 0,0 1,0 1,2; end; ");

  TraceSink placed;
  Relabelled relabelled_figure(placed, {4, Role::mask, Paint::stroke, false, 9});
  EXPECT_EQ(relabelled_figure.place({1}, corner_figure(), {}), Flow::go);
  EXPECT_EQ(placed.trace(), "begin 4 mask stroke open 9; points 0,0 1,0 1,2; end; ");
}

TEST(Counted, CountsPathsPointsAndFigures) {
  TraceSink trace;
  Counted counted(trace);
  EXPECT_EQ(draw_corner(counted), Flow::go);
  EXPECT_EQ(counted.paths(), 1U);
  EXPECT_EQ(counted.point_count(), 3U);
  EXPECT_EQ(counted.place({}, corner_figure(), {}), Flow::go);
  EXPECT_EQ(counted.paths(), 2U);
  EXPECT_EQ(counted.point_count(), 6U);
}

TEST(Stoppable, StopsEveryCallOnceAsked) {
  std::stop_source source;
  TraceSink trace;
  Stoppable stoppable(trace, source.get_token());
  EXPECT_EQ(draw_corner(stoppable), Flow::go);
  const std::string before = trace.trace();
  source.request_stop();
  EXPECT_EQ(stoppable.begin({}), Flow::stop);
  EXPECT_EQ(stoppable.points(corner), Flow::stop);
  EXPECT_EQ(stoppable.place({}, corner_figure(), {}), Flow::stop);
  EXPECT_EQ(trace.trace(), before);
}

TEST(BoundsSink, HoldsWhatWasDrawn) {
  BoundsSink bounds;
  EXPECT_TRUE(bounds.box().empty());
  EXPECT_EQ(draw_corner(bounds), Flow::go);
  PathSink& sink = bounds;
  EXPECT_EQ(sink.place({}, corner_figure(), translation({-3, 0})), Flow::go);
  EXPECT_EQ(bounds.box(), (Box2{{-3, 0}, {1, 2}}));
}

TEST(Checked, LetsALawfulDrawingPass) {
  TraceSink trace;
  Checked checked(trace);
  EXPECT_EQ(draw_corner(checked, {1}), Flow::go);
  EXPECT_EQ(draw_corner(checked, {1}), Flow::go);
  EXPECT_EQ(checked.place({2}, corner_figure(), {}), Flow::go);
  EXPECT_EQ(draw_corner(checked, {3}), Flow::go);
}

TEST(Checked, ADrawingThatWasStoppedMayStayOpen) {
  TraceSink trace(2);
  Checked checked(trace);
  EXPECT_EQ(draw_corner(checked), Flow::stop);
}

/// A Checked in the middle of its first path.
struct OpenPath {
  TraceSink trace;
  std::optional<Checked> checked;
  OpenPath() {
    checked.emplace(trace);
    (void)checked->begin({1});
  }
};

TEST(CheckedDeathTest, CallsOutOfOrder) {
  TraceSink trace;
  Checked idle(trace);
  EXPECT_DEATH((void)idle.points(corner), "contract broken");
  EXPECT_DEATH((void)idle.contour(), "contract broken");
  EXPECT_DEATH((void)idle.end(), "contract broken");
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->begin({1});
      },
      "contract broken");
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->place({1}, corner_figure(), {});
      },
      "contract broken");
}

TEST(CheckedDeathTest, EmptyContoursAndSpans) {
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->end();
      },
      "contract broken");
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->contour();
      },
      "contract broken");
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->points({});
      },
      "contract broken");
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->points(corner);
        (void)open.checked->contour();
        (void)open.checked->end();
      },
      "contract broken");
}

TEST(CheckedDeathTest, PointsThatAreNoNumbers) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::vector<Vec2> points{{0, 0}, {0, bad}};
    EXPECT_DEATH(
        {
          OpenPath open;
          (void)open.checked->points(points);
        },
        "contract broken");
  }
}

TEST(CheckedDeathTest, LayersThatDescend) {
  EXPECT_DEATH(
      {
        OpenPath open;
        (void)open.checked->points(corner);
        (void)open.checked->end();
        (void)open.checked->begin({0});
      },
      "contract broken");
}

TEST(CheckedDeathTest, CallsAfterAStop) {
  EXPECT_DEATH(
      {
        TraceSink trace(1);
        Checked checked(trace);
        (void)checked.begin({});
        (void)checked.points(corner);
      },
      "contract broken");
}

TEST(CheckedDeathTest, APathLeftOpen) {
  EXPECT_DEATH(
      {
        OpenPath open;
        open.checked.reset();
      },
      "contract broken");
}

}  // namespace
}  // namespace burin
