#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <burin/path/path_sink.hpp>

namespace burin {

/// Collects the points of one contour into spans of about 1000 for a sink. The last point stays in the buffer until the
/// contour ends, so that a closed curve can take back its repeated first point.
class PointBuffer {
 public:
  static constexpr std::size_t capacity = 2048;

  explicit PointBuffer(PathSink& sink) : sink_(sink) {}

  Flow add(Vec2 point) {
    if (size_ == capacity && flush_all_but_last() == Flow::stop) return Flow::stop;
    points_[size_++] = point;
    return Flow::go;
  }

  /// Room for `count` points to be written in place; null after a stop. Pre: count < capacity.
  Vec2* reserve(std::size_t count) {
    if (size_ + count > capacity && flush_all_but_last() == Flow::stop) return nullptr;
    Vec2* room = points_.data() + size_;
    size_ += count;
    return room;
  }

  /// Hands over what is left; without the last point if `drop_last`.
  Flow finish(bool drop_last) {
    if (drop_last) --size_;
    const std::size_t count = size_;
    size_ = 0;
    return count == 0 ? Flow::go : sink_.points(std::span<const Vec2>(points_).first(count));
  }

 private:
  Flow flush_all_but_last() {
    const Vec2 last = points_[size_ - 1];
    const Flow flow = sink_.points(std::span<const Vec2>(points_).first(size_ - 1));
    points_[0] = last;
    size_ = 1;
    return flow;
  }

  PathSink& sink_;
  std::size_t size_ = 0;
  std::array<Vec2, capacity> points_;
};

}  // namespace burin
