#include <algorithm>
#include <bit>
#include <utility>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

namespace burin {

namespace {

/// FNV-1a over 64-bit words: tells drawings apart, which are then compared.
std::uint64_t hash_of(const Recording& drawing) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Vec2 p : drawing.all_points()) {
    for (const double coordinate : {p.x, p.y}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x100000001b3U;
      hash ^= hash >> 32U;
    }
  }
  return hash;
}

}  // namespace

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

Figure::Figure(Recording drawing)
    : drawing_(std::move(drawing)), bounds_(drawing_.bounds()), fingerprint_(hash_of(drawing_)) {}

bool Figure::looks_like(const Figure& other) const {
  if (this == &other) return true;
  if (fingerprint_ != other.fingerprint_ || drawing_.all_points() != other.drawing_.all_points()) return false;
  const auto same_contours = [&](const Recording::Path& p, const Recording::Path& q) {
    return std::ranges::equal(drawing_.contours(p), other.drawing_.contours(q), [](const auto& c, const auto& d) {
      return c.first_point == d.first_point && c.point_count == d.point_count;
    });
  };
  return std::ranges::equal(
      drawing_.paths(), other.drawing_.paths(), [&](const Recording::Path& p, const Recording::Path& q) {
        return p.head.paint == q.head.paint && p.head.closed == q.head.closed && same_contours(p, q);
      });
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

Vec2* PathSink::room_for(std::size_t) {
  return nullptr;
}

Flow PathSink::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  Relabelled relabelled(*this, head);
  Mapped mapped(relabelled, at);
  return replay(figure.drawing(), mapped);
}

}  // namespace burin
