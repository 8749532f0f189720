#include <cstddef>

#include <burin/passes/cut_strokes.hpp>

namespace burin::passes {

void CutStrokes::start(Vec2 point, bool is_left) {
  first_ = last_ = point;
  is_dot_ = true;
  first_is_left_ = is_left;
  opens_ = head_.closed && is_left;
  opening_.clear();
  if (opens_) opening_.push_back(point);
}

Flow CutStrokes::line_to(Vec2 to, std::span<const Segment> left) {
  is_dot_ = false;
  Vec2 drawn_to = last_;
  for (const Segment& part : left) {
    if (part.from != drawn_to && gap() == Flow::stop) return Flow::stop;
    if (draw(part) == Flow::stop) return Flow::stop;
    drawn_to = part.to;
  }
  last_ = to;
  return drawn_to == to && !left.empty() ? Flow::go : gap();
}

Flow CutStrokes::finish() {
  if (is_dot_) {
    if (!first_is_left_) return Flow::go;
    opening_ = {first_};
    return whole();
  }
  if (!head_.closed) return pieces_.lift();
  if (opens_) {
    if (opening_.back() == first_ && opening_.size() > 1) opening_.pop_back();
    return whole();
  }
  // The way back to the first point and the way from it are one stroke.
  for (std::size_t i = 1; i < opening_.size(); ++i) {
    if (pieces_.draw(head_, opening_[i - 1], opening_[i]) == Flow::stop) return Flow::stop;
  }
  return pieces_.lift();
}

Flow CutStrokes::gap() {
  opens_ = false;
  return pieces_.lift();
}

Flow CutStrokes::draw(const Segment& part) {
  if (!opens_) return pieces_.draw(head_, part.from, part.to);
  opening_.push_back(part.to);
  return Flow::go;
}

Flow CutStrokes::whole() {
  if (sink_.begin(head_) == Flow::stop || sink_.points(opening_) == Flow::stop) return Flow::stop;
  return sink_.end();
}

}  // namespace burin::passes
