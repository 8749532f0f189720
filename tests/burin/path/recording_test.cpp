#include <vector>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

#include "support/trace_sink.hpp"

namespace burin {
namespace {

using test::TraceSink;

constexpr PathHead ring_head{2, Role::ink_and_mask, Paint::fill_evenodd, true, 7};

/// A ring of two contours, its first in two spans, and a dot.
Flow draw_ring_and_dot(PathSink& sink) {
  const std::vector<Vec2> outer{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Vec2> inner{{1, 1}, {2, 1}, {2, 2}};
  const std::vector<Vec2> dot{{9, -1.5}};
  if (sink.begin(ring_head) == Flow::stop) return Flow::stop;
  if (sink.points(std::span(outer).first(3)) == Flow::stop) return Flow::stop;
  if (sink.points(std::span(outer).last(1)) == Flow::stop) return Flow::stop;
  if (sink.contour() == Flow::stop) return Flow::stop;
  if (sink.points(inner) == Flow::stop) return Flow::stop;
  if (sink.end() == Flow::stop) return Flow::stop;
  if (sink.begin({3}) == Flow::stop) return Flow::stop;
  if (sink.points(dot) == Flow::stop) return Flow::stop;
  return sink.end();
}

constexpr const char* ring_and_dot_trace =
    "begin 2 ink_and_mask fill_evenodd closed 7; points 0,0 4,0 4,4 0,4; contour; points 1,1 2,1 2,2; end; "
    "begin 3 ink stroke open 0; points 9,-1.5; end; ";

TEST(Recording, ReplayGivesTheDrawingBack) {
  Recorder recorder;
  EXPECT_EQ(draw_ring_and_dot(recorder), Flow::go);
  TraceSink trace;
  Checked checked(trace);
  EXPECT_EQ(replay(recorder.recording(), checked), Flow::go);
  EXPECT_EQ(trace.trace(), ring_and_dot_trace);
}

TEST(Recording, KnowsPathsContoursAndBounds) {
  Recorder recorder;
  ASSERT_EQ(draw_ring_and_dot(recorder), Flow::go);
  const Recording recording = recorder.take();
  ASSERT_EQ(recording.paths().size(), 2U);
  EXPECT_EQ(recording.paths()[0].head, ring_head);
  const auto contours = recording.contours(recording.paths()[0]);
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(recording.points(contours[0]).size(), 4U);
  EXPECT_EQ(recording.points(contours[1])[2], (Vec2{2, 2}));
  EXPECT_EQ(recording.all_points().size(), 8U);
  EXPECT_EQ(recording.bounds(), (Box2{{0, -1.5}, {9, 4}}));
}

TEST(Recording, EmptyOneIsSilent) {
  const Recording recording;
  EXPECT_TRUE(recording.empty());
  EXPECT_TRUE(recording.bounds().empty());
  TraceSink trace;
  EXPECT_EQ(replay(recording, trace), Flow::go);
  EXPECT_EQ(trace.trace(), "");
}

TEST(Recording, ReplayEndsAtTheFirstStop) {
  Recorder recorder;
  ASSERT_EQ(draw_ring_and_dot(recorder), Flow::go);
  const std::string whole = ring_and_dot_trace;
  for (std::size_t calls = 1; calls <= 8; ++calls) {
    TraceSink trace(calls);
    Checked checked(trace);
    EXPECT_EQ(replay(recorder.recording(), checked), Flow::stop);
    EXPECT_EQ(whole.substr(0, trace.trace().size()), trace.trace());
    EXPECT_EQ(std::ranges::count(trace.trace(), ';'), static_cast<std::ptrdiff_t>(calls));
  }
}

TEST(Figure, LooksAreToldApartByPointsContoursAndPaint) {
  const auto figure_of = [](const PathHead& head, const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
    Recorder recorder;
    EXPECT_EQ(recorder.begin(head), Flow::go);
    EXPECT_EQ(recorder.points(first), Flow::go);
    EXPECT_EQ(recorder.contour(), Flow::go);
    EXPECT_EQ(recorder.points(second), Flow::go);
    EXPECT_EQ(recorder.end(), Flow::go);
    return Figure(recorder.take());
  };
  const Figure figure = figure_of({}, {{0, 0}, {1, 0}, {2, 5}}, {{3, 3}});
  EXPECT_EQ(figure.bounds(), (Box2{{0, 0}, {3, 5}}));
  const Figure on_another_layer = figure_of({.layer = 3, .level = 2}, {{0, 0}, {1, 0}, {2, 5}}, {{3, 3}});
  EXPECT_TRUE(figure.looks_like(on_another_layer));
  EXPECT_EQ(figure.fingerprint(), on_another_layer.fingerprint());
  EXPECT_FALSE(figure.looks_like(figure_of({}, {{0, 0}, {1, 0}}, {{2, 5}, {3, 3}})));
  EXPECT_FALSE(figure.looks_like(figure_of({.closed = true}, {{0, 0}, {1, 0}, {2, 5}}, {{3, 3}})));
  EXPECT_FALSE(figure.looks_like(figure_of({.paint = Paint::fill_nonzero}, {{0, 0}, {1, 0}, {2, 5}}, {{3, 3}})));
  const Figure moved = figure_of({}, {{0, 0}, {1, 0}, {2, 5}}, {{3, 3.5}});
  EXPECT_FALSE(figure.looks_like(moved));
  EXPECT_NE(figure.fingerprint(), moved.fingerprint());
}

TEST(Place, ExpandsIntoTheFiguresPathsWithTheHeadsLabels) {
  Recorder recorder;
  ASSERT_EQ(draw_ring_and_dot(recorder), Flow::go);
  const Figure figure(recorder.take());
  TraceSink trace;
  PathSink& sink = trace;
  EXPECT_EQ(sink.place({5, Role::mask, Paint::stroke, false, 4}, figure, translation({10, 20}) * scaling(2, -1)),
            Flow::go);
  EXPECT_EQ(trace.trace(),
            "begin 5 mask fill_evenodd closed 4; points 10,20 18,20 18,16 10,16; contour; points 12,19 14,19 14,18; "
            "end; begin 5 mask stroke open 4; points 28,21.5; end; ");
}

TEST(Place, EndsAtTheFirstStop) {
  Recorder recorder;
  ASSERT_EQ(draw_ring_and_dot(recorder), Flow::go);
  const Figure figure(recorder.take());
  TraceSink trace(2);
  PathSink& sink = trace;
  EXPECT_EQ(sink.place({0}, figure, {}), Flow::stop);
  EXPECT_EQ(trace.trace(), "begin 0 ink fill_evenodd closed 0; points 0,0 4,0 4,4 0,4; ");
}

}  // namespace
}  // namespace burin
