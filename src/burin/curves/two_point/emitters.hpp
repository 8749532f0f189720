#pragma once

#include <cstddef>
#include <span>

#include <burin/curves/two_point/placed_points.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/path/point_buffer.hpp>

/// What a trace of the curve does with the points it finds: two answers to the same calls, so that a forecast walks the
/// very tree that the drawing will.
namespace burin::curves::two_point {

/// Sends them to a sink.
class PointEmitter {
 public:
  explicit PointEmitter(PathSink& sink) : buffer_(sink) {}

  Flow point(Vec2 p) { return buffer_.add(p); }

  /// The points of a table (but the first) placed on the edge from p along d; the last one is exactly q.
  Flow block(std::span<const Vec2> table, Vec2 p, Vec2 d, Vec2 q) {
    const std::size_t count = table.size() - 1;
    Vec2* room = buffer_.reserve(count);
    if (room == nullptr) return Flow::stop;
    place_points(table.subspan(1, count - 1), p, d, room);
    room[count - 1] = q;
    return Flow::go;
  }

  Flow finish(bool drop_last) { return buffer_.finish(drop_last); }

 private:
  PointBuffer buffer_;
};

/// Counts them, and gives up above `enough`.
class PointCounter {
 public:
  explicit PointCounter(double enough) : enough_(enough) {}

  Flow point(Vec2) { return add(1.0); }
  Flow block(std::span<const Vec2> table, Vec2, Vec2, Vec2) { return add(static_cast<double>(table.size() - 1)); }
  double count() const { return count_; }

 private:
  Flow add(double points) {
    count_ += points;
    return count_ > enough_ ? Flow::stop : Flow::go;
  }

  double enough_;
  double count_ = 0.0;
};

}  // namespace burin::curves::two_point
