#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

namespace burin {

std::span<const Recording::Contour> Recording::contours(const Path& path) const {
  return std::span(contours_).subspan(path.first_contour, path.contour_count);
}

std::span<const Vec2> Recording::points(const Contour& contour) const {
  return std::span(points_).subspan(contour.first_point, contour.point_count);
}

Box2 Recording::bounds() const {
  Box2 box;
  for (const Vec2 p : points_) box.add(p);
  return box;
}

Flow Recorder::begin(const PathHead& head) {
  recording_.paths_.push_back({head, recording_.contours_.size(), 1});
  recording_.contours_.push_back({recording_.points_.size(), 0});
  return Flow::go;
}

Flow Recorder::points(std::span<const Vec2> points) {
  recording_.points_.insert(recording_.points_.end(), points.begin(), points.end());
  recording_.contours_.back().point_count += points.size();
  return Flow::go;
}

Flow Recorder::contour() {
  ++recording_.paths_.back().contour_count;
  recording_.contours_.push_back({recording_.points_.size(), 0});
  return Flow::go;
}

Flow Recorder::end() {
  return Flow::go;
}

Flow replay(const Recording& recording, PathSink& sink) {
  for (const Recording::Path& path : recording.paths()) {
    if (sink.begin(path.head) == Flow::stop) return Flow::stop;
    bool first = true;
    for (const Recording::Contour& contour : recording.contours(path)) {
      if (!first && sink.contour() == Flow::stop) return Flow::stop;
      first = false;
      if (sink.points(recording.points(contour)) == Flow::stop) return Flow::stop;
    }
    if (sink.end() == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow PathSink::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  Relabelled relabelled(*this, head);
  Mapped mapped(relabelled, at);
  return replay(figure.drawing(), mapped);
}

}  // namespace burin
