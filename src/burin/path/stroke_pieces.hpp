#pragma once

#include <burin/path/point_buffer.hpp>

namespace burin {

/// Draws the parts of a stroke that are left of it, each as an open path of its own. O(1) memory.
class StrokePieces {
 public:
  explicit StrokePieces(PathSink& sink) : sink_(sink), buffer_(sink) {}

  /// Whether a piece is begun and not ended.
  bool down() const { return down_; }

  /// A segment that goes on where the last one ended, or begins a piece after a lift.
  Flow draw(const PathHead& head, Vec2 from, Vec2 to) {
    if (!down_) {
      PathHead piece = head;
      piece.closed = false;
      if (sink_.begin(piece) == Flow::stop || buffer_.add(from) == Flow::stop) return Flow::stop;
      down_ = true;
    }
    return buffer_.add(to);
  }

  /// Ends the piece, if one is begun.
  Flow lift() {
    if (!down_) return Flow::go;
    down_ = false;
    return buffer_.finish(false) == Flow::stop ? Flow::stop : sink_.end();
  }

 private:
  PathSink& sink_;
  PointBuffer buffer_;
  bool down_ = false;
};

}  // namespace burin
