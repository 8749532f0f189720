#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <burin/path/path_sink.hpp>

namespace burin {

/// Collects the points of one contour into spans of about 1000 for a sink, in the sink's own memory where it lends
/// some. The last point stays in the buffer until the contour ends, so that a closed curve can take back its repeated
/// first point.
class PointBuffer {
 public:
  static constexpr std::size_t capacity = 2048;

  explicit PointBuffer(PathSink& sink) : sink_(sink) {}
  PointBuffer(const PointBuffer&) = delete;
  PointBuffer& operator=(const PointBuffer&) = delete;

  Flow add(Vec2 point) {
    if (size_ == limit_ && make_room() == Flow::stop) return Flow::stop;
    points_[size_++] = point;
    return Flow::go;
  }

  /// Room for `count` points to be written in place; null after a stop. Pre: count < capacity.
  Vec2* reserve(std::size_t count) {
    if (size_ + count > limit_ && make_room() == Flow::stop) return nullptr;
    Vec2* room = points_ + size_;
    size_ += count;
    return room;
  }

  /// Hands over what is left; without the last point if `drop_last`.
  Flow finish(bool drop_last) {
    if (drop_last) --size_;
    const std::size_t count = size_;
    size_ = 0;
    limit_ = 0;
    return count == 0 ? Flow::go : sink_.points({points_, count});
  }

 private:
  /// Room for `capacity` points, of which the last one so far, if there is one, is the first.
  Flow make_room() {
    if (size_ == 0) {
      take_room();
      return Flow::go;
    }
    const Vec2 last = points_[size_ - 1];
    if (sink_.points({points_, size_ - 1}) == Flow::stop) return Flow::stop;
    take_room();
    points_[0] = last;
    size_ = 1;
    return Flow::go;
  }

  void take_room() {
    Vec2* lent = sink_.room_for(capacity);
    points_ = lent != nullptr ? lent : own_.data();
    limit_ = capacity;
  }

  PathSink& sink_;
  Vec2* points_ = nullptr;
  std::size_t size_ = 0;
  std::size_t limit_ = 0;  ///< capacity, or 0 before a contour's first point
  std::array<Vec2, capacity> own_;
};

}  // namespace burin
