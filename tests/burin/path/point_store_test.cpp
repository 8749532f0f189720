#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/point_buffer.hpp>
#include <burin/path/point_store.hpp>
#include <burin/path/recording.hpp>

namespace burin {
namespace {

constexpr Vec2 untouched{-7.0, -7.0};

std::vector<Vec2> numbered(std::size_t count) {
  std::vector<Vec2> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {static_cast<double>(i), 0.25};
  return points;
}

std::vector<Vec2> stored(const PointStore& store) {
  return {store.stored().begin(), store.stored().end()};
}

TEST(PointStore, KeepsContourAfterContour) {
  std::vector<Vec2> memory(6, untouched);
  PointStore store(memory);
  const std::vector<Vec2> points = numbered(5);
  ASSERT_EQ(store.begin({}), Flow::go);
  ASSERT_EQ(store.points(std::span(points).first(2)), Flow::go);
  ASSERT_EQ(store.contour(), Flow::go);
  ASSERT_EQ(store.points(std::span(points).last(3)), Flow::go);
  ASSERT_EQ(store.end(), Flow::go);
  EXPECT_EQ(stored(store), points);
  EXPECT_EQ(store.stored().data(), memory.data());
  EXPECT_EQ(memory.back(), untouched);
}

TEST(PointStore, StopsWhenItIsFullWithWhatFits) {
  std::vector<Vec2> memory(4, untouched);
  PointStore store{std::span(memory).first(3)};
  const std::vector<Vec2> points = numbered(4);
  ASSERT_EQ(store.begin({}), Flow::go);
  ASSERT_EQ(store.points(std::span(points).first(2)), Flow::go);
  EXPECT_EQ(store.points(std::span(points).last(2)), Flow::stop);
  EXPECT_EQ(stored(store), numbered(3));
  EXPECT_EQ(memory.back(), untouched);

  PointStore none({});
  EXPECT_EQ(none.room_for(1), nullptr);
  EXPECT_EQ(none.points(points), Flow::stop);
  EXPECT_TRUE(none.stored().empty());
}

TEST(PointStore, LendsWhatIsFree) {
  std::vector<Vec2> memory(4, untouched);
  PointStore store(memory);
  EXPECT_EQ(store.room_for(5), nullptr);
  Vec2* room = store.room_for(4);
  ASSERT_EQ(room, memory.data());
  room[0] = {1, 1};
  ASSERT_EQ(store.points({room, 1}), Flow::go);
  EXPECT_EQ(store.room_for(4), nullptr);
  room = store.room_for(3);
  ASSERT_EQ(room, memory.data() + 1);
  // Not from its start: moved there.
  room[1] = {2, 2};
  room[2] = {3, 3};
  ASSERT_EQ(store.points({room + 1, 2}), Flow::go);
  EXPECT_EQ(stored(store), (std::vector<Vec2>{{1, 1}, {2, 2}, {3, 3}}));
}

/// Two contours through a buffer, the first by single points, the second in runs; each leaves out its last point.
Flow draw_buffered(std::size_t count, std::size_t run, PathSink& sink) {
  const std::vector<Vec2> points = numbered(count + 1);
  PointBuffer buffer(sink);
  if (sink.begin({}) == Flow::stop) return Flow::stop;
  for (const Vec2 p : points) {
    if (buffer.add(p) == Flow::stop) return Flow::stop;
  }
  if (buffer.finish(true) == Flow::stop || sink.contour() == Flow::stop) return Flow::stop;
  for (std::size_t i = 0; i < points.size(); i += run) {
    const std::size_t length = std::min(run, points.size() - i);
    Vec2* room = buffer.reserve(length);
    if (room == nullptr) return Flow::stop;
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(i), length, room);
  }
  return buffer.finish(true) == Flow::stop ? Flow::stop : sink.end();
}

TEST(PointStore, ABufferWritesIntoItWhatItSendsToOthers) {
  constexpr std::size_t full = PointBuffer::capacity;
  for (const std::size_t count : {std::size_t{1}, full - 2, full - 1, full, full + 1, 2 * full - 1, 3 * full}) {
    for (const std::size_t run : {std::size_t{1}, full / 2, full - 1}) {
      Recorder recorder;
      Checked checked(recorder);
      ASSERT_EQ(draw_buffered(count, run, checked), Flow::go);
      const std::vector<Vec2>& expected = recorder.recording().all_points();
      ASSERT_EQ(expected.size(), 2 * count);
      // From any start, and with as little room as may be.
      for (const std::size_t start : {0U, 1U}) {
        std::vector<Vec2> memory(start + 2 * count + 1, untouched);
        PointStore store{std::span(memory).subspan(start, 2 * count)};
        ASSERT_EQ(draw_buffered(count, run, store), Flow::go);
        EXPECT_EQ(stored(store), expected) << count << ' ' << run;
        EXPECT_EQ(memory.back(), untouched);
        EXPECT_TRUE(start == 0 || memory.front() == untouched);

        PointStore small{std::span(memory).subspan(start, 2 * count - 1)};
        EXPECT_EQ(draw_buffered(count, run, small), Flow::stop);
        EXPECT_EQ(stored(small), std::vector<Vec2>(expected.begin(), expected.end() - 1)) << count << ' ' << run;
      }
    }
  }
}

/// Lends its memory again and again, and counts the points that come from elsewhere.
class Lender final : public PathSink {
 public:
  Flow begin(const PathHead&) override { return Flow::go; }
  Flow points(std::span<const Vec2> points) override {
    if (points.data() != memory_.data()) elsewhere_ += points.size();
    return Flow::go;
  }
  Flow contour() override { return Flow::go; }
  Flow end() override { return Flow::go; }
  Vec2* room_for(std::size_t count) override {
    memory_.resize(count);
    return memory_.data();
  }
  std::size_t elsewhere() const { return elsewhere_; }

 private:
  std::vector<Vec2> memory_;
  std::size_t elsewhere_ = 0;
};

TEST(PointStore, ABufferUsesWhatItIsLent) {
  Lender lender;
  EXPECT_EQ(draw_buffered(3 * PointBuffer::capacity, 100, lender), Flow::go);
  EXPECT_EQ(lender.elsewhere(), 0U);
}

TEST(Decorators, LendWhatTheNextOneLendsIfTheyHandOnThePointsThatTheyTake) {
  std::vector<Vec2> memory(3000);
  PointStore store(memory);
  Relabelled relabelled(store, {});
  Painted painted(relabelled, 0, Paint::stroke);
  Counted counted(painted);
  Stoppable stoppable(counted, {});
  Checked checked(stoppable);
  EXPECT_EQ(checked.room_for(3000), memory.data());
  EXPECT_EQ(checked.room_for(3001), nullptr);
  Decorator other(store);
  EXPECT_EQ(other.room_for(1), nullptr);
  Mapped mapped(store, translation({1, 0}));
  EXPECT_EQ(mapped.room_for(1), nullptr);
}

TEST(Mapped, WritesIntoTheRoomThatIsLent) {
  const std::vector<Vec2> points = numbered(2500);
  Lender lender;
  Mapped into_lender(lender, translation({1, 0}));
  ASSERT_EQ(into_lender.points(points), Flow::go);
  EXPECT_EQ(lender.elsewhere(), 0U);

  std::vector<Vec2> memory(points.size());
  PointStore store(memory);
  Mapped mapped(store, translation({1, 0}));
  ASSERT_EQ(mapped.points(points), Flow::go);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(memory[i], points[i] + (Vec2{1, 0}));
}

}  // namespace
}  // namespace burin
