#include <algorithm>
#include <utility>

#include <burin/passes/region_filter.hpp>
#include <burin/path/recording.hpp>

namespace burin::passes {

Flow RegionFilter::begin(const PathHead& head) {
  head_ = head;
  first_item_ = item_ == nullptr ? 0 : *item_ + 1;
  strokes_.set_head(head);
  has_point_ = false;
  contours_.assign(1, {});
  return Flow::go;
}

Flow RegionFilter::points(std::span<const Vec2> points) {
  if (head_.paint != Paint::stroke) {
    contours_.back().insert(contours_.back().end(), points.begin(), points.end());
    return Flow::go;
  }
  for (const Vec2 point : points) {
    if (!has_point_) {
      const bool covered = regions_.covers(point, first_item_, border_, query_);
      strokes_.start(point, covered == (keep_ == Keep::inside));
      has_point_ = true;
    } else if (stroke_to(point) == Flow::stop) {
      return Flow::stop;
    }
  }
  return Flow::go;
}

Flow RegionFilter::contour() {
  if (head_.paint == Paint::stroke) return finish_stroke();
  contours_.emplace_back();
  return Flow::go;
}

Flow RegionFilter::end() {
  return head_.paint == Paint::stroke ? finish_stroke() : fill();
}

Flow RegionFilter::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return PathSink::place(head, figure, at);
}

Flow RegionFilter::stroke_to(Vec2 to) {
  const Vec2 last = strokes_.last();
  regions_.cover(last, to, first_item_, border_, query_);
  left_.clear();
  const auto point_at = [&](double t) { return t == 0.0 ? last : t == 1.0 ? to : lerp(last, to, t); };
  if (keep_ == Keep::inside) {
    for (const Part& part : query_.parts()) left_.push_back({point_at(part.from), point_at(part.to)});
  } else {
    double from = 0.0;
    for (const Part& part : query_.parts()) {
      if (part.from > from) left_.push_back({point_at(from), point_at(part.from)});
      from = part.to;
    }
    if (from < 1.0) left_.push_back({point_at(from), to});
  }
  return strokes_.line_to(to, left_);
}

Flow RegionFilter::finish_stroke() {
  has_point_ = false;
  if (strokes_.needs_closing() && stroke_to(strokes_.first()) == Flow::stop) return Flow::stop;
  return strokes_.finish();
}

Flow RegionFilter::fill() {
  Box2 box;
  for (const std::vector<Vec2>& contour : contours_) {
    for (const Vec2 p : contour) box.add(p);
  }
  std::vector<Area> others;
  for (const std::size_t shape : regions_.near(box, first_item_, query_)) {
    others.push_back({regions_.contours(shape), regions_.rule(shape)});
  }
  PathHead head = head_;
  if (keep_ == Keep::inside) {
    contours_ = common({std::exchange(contours_, {}), head.paint}, others);
  } else if (!others.empty()) {
    contours_ = difference({std::exchange(contours_, {}), head.paint}, others);
  }
  std::erase_if(contours_, [](const std::vector<Vec2>& contour) { return contour.empty(); });
  if (contours_.empty()) return Flow::go;
  head.closed = true;  // a fill closes its contours anyway
  if (next().begin(head) == Flow::stop) return Flow::stop;
  for (std::size_t i = 0; i < contours_.size(); ++i) {
    if (i > 0 && next().contour() == Flow::stop) return Flow::stop;
    if (next().points(contours_[i]) == Flow::stop) return Flow::stop;
  }
  return next().end();
}

}  // namespace burin::passes
