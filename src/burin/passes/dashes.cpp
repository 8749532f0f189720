#include <optional>

#include <burin/passes/dashes.hpp>

namespace burin::passes {

namespace {

constexpr double shortest_period_mm = 1e-3;

}  // namespace

bool Dashes::passes_on() const {
  return head_.paint != Paint::stroke || walk_.period() < shortest_period_mm;
}

Flow Dashes::begin(const PathHead& head) {
  head_ = head;
  has_point_ = false;
  if (passes_on()) return next().begin(head);
  strokes_.set_head(head);
  return Flow::go;
}

Flow Dashes::points(std::span<const Vec2> points) {
  if (passes_on()) return next().points(points);
  for (const Vec2 point : points) {
    if (!has_point_) {
      has_point_ = true;
      walk_.restart();
      strokes_.start(point, true);
    } else if (stroke_to(point) == Flow::stop) {
      return Flow::stop;
    }
  }
  return Flow::go;
}

Flow Dashes::contour() {
  return passes_on() ? next().contour() : finish_stroke();
}

Flow Dashes::end() {
  return passes_on() ? next().end() : finish_stroke();
}

Flow Dashes::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return PathSink::place(head, figure, at);
}

Flow Dashes::stroke_to(Vec2 to) {
  const Vec2 last = strokes_.last();
  if (to == last) return Flow::go;
  left_.clear();
  const double size_mm = distance(last, to);
  const std::optional<Segment> seen = clip_segment(last, to, box_);
  const double begin_mm = seen ? distance(last, seen->from) : size_mm;
  const double seen_mm = seen ? distance(seen->from, seen->to) : 0.0;
  walk_.skip(begin_mm);
  walk_.go(seen_mm, [&](double from_mm, double to_mm) {
    const auto point_at = [&](double at_mm) {
      return at_mm == 0.0 ? seen->from : at_mm == seen_mm ? seen->to : lerp(seen->from, seen->to, at_mm / seen_mm);
    };
    left_.push_back({point_at(from_mm), point_at(to_mm)});
  });
  if (seen && seen->to != to) walk_.skip(size_mm - begin_mm - seen_mm);
  return strokes_.line_to(to, left_);
}

Flow Dashes::finish_stroke() {
  if (!has_point_) return Flow::go;
  has_point_ = false;
  if (strokes_.needs_closing() && strokes_.first() != strokes_.last() && stroke_to(strokes_.first()) == Flow::stop) {
    return Flow::stop;
  }
  return strokes_.finish();
}

}  // namespace burin::passes
