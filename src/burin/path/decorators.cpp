#include <algorithm>

#include <burin/base/check.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

namespace burin {

Flow Mapped::points(std::span<const Vec2> points) {
  constexpr std::size_t at_once = 1024;
  while (!points.empty()) {
    const std::size_t count = std::min(points.size(), at_once);
    Vec2* room = next().room_for(count);
    if (room == nullptr) {
      if (mapped_.size() < count) mapped_.resize(count);
      room = mapped_.data();
    }
    for (std::size_t i = 0; i < count; ++i) room[i] = map_(points[i]);
    if (next().points({room, count}) == Flow::stop) return Flow::stop;
    points = points.subspan(count);
  }
  return Flow::go;
}

PathHead Relabelled::relabelled(const PathHead& head) const {
  PathHead label = head_;
  label.closed = head.closed;
  label.paint = head.paint;
  return label;
}

Flow Relabelled::begin(const PathHead& head) {
  return next().begin(relabelled(head));
}

Flow Relabelled::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return next().place(relabelled(head), figure, at);
}

Flow Counted::begin(const PathHead& head) {
  ++paths_;
  return next().begin(head);
}

Flow Counted::points(std::span<const Vec2> points) {
  points_ += points.size();
  return next().points(points);
}

Flow Counted::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  paths_ += figure.drawing().paths().size();
  points_ += figure.drawing().all_points().size();
  return next().place(head, figure, at);
}

Flow Stoppable::begin(const PathHead& head) {
  return stop_.stop_requested() ? Flow::stop : next().begin(head);
}

Flow Stoppable::points(std::span<const Vec2> points) {
  return stop_.stop_requested() ? Flow::stop : next().points(points);
}

Flow Stoppable::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return stop_.stop_requested() ? Flow::stop : next().place(head, figure, at);
}

Checked::~Checked() {
  BURIN_EXPECT(stopped_ || !in_path_);
}

Flow Checked::noted(Flow flow) {
  if (flow == Flow::stop) stopped_ = true;
  return flow;
}

Flow Checked::begin(const PathHead& head) {
  BURIN_EXPECT(!stopped_ && !in_path_);
  BURIN_EXPECT(head.layer >= last_layer_);
  last_layer_ = head.layer;
  in_path_ = true;
  contour_points_ = 0;
  return noted(next().begin(head));
}

Flow Checked::points(std::span<const Vec2> points) {
  BURIN_EXPECT(!stopped_ && in_path_ && !points.empty());
  for (const Vec2 p : points) BURIN_EXPECT(is_finite(p));
  contour_points_ += points.size();
  return noted(next().points(points));
}

Flow Checked::contour() {
  BURIN_EXPECT(!stopped_ && in_path_ && contour_points_ > 0);
  contour_points_ = 0;
  return noted(next().contour());
}

Flow Checked::end() {
  BURIN_EXPECT(!stopped_ && in_path_ && contour_points_ > 0);
  in_path_ = false;
  return noted(next().end());
}

Flow Checked::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  BURIN_EXPECT(!stopped_ && !in_path_ && head.layer >= last_layer_);
  last_layer_ = head.layer;
  return noted(next().place(head, figure, at));
}

Flow BoundsSink::points(std::span<const Vec2> points) {
  for (const Vec2 p : points) {
    box_.add(p);
    finite_ = finite_ && is_finite(p);
  }
  return Flow::go;
}

/// Most figures lie within what is known already.
Flow BoundsSink::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  const Box2 around = image_box(at, figure.bounds());
  const bool nothing_new = box_.contains(around.low) && box_.contains(around.high);
  return nothing_new ? Flow::go : PathSink::place(head, figure, at);
}

}  // namespace burin
