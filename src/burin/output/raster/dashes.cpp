#include <cmath>

#include <burin/geom/clip.hpp>
#include <burin/output/raster/dashes.hpp>

namespace burin::output::raster {

void Dashes::set_pattern(const std::vector<double>& lengths, double offset) {
  lengths_ = lengths;
  if (lengths.size() % 2 == 1) lengths_.insert(lengths_.end(), lengths.begin(), lengths.end());
  period_ = 0.0;
  for (const double length : lengths_) period_ += length;
  offset_ = offset;
  constexpr double shortest = 1.0 / 256.0;
  if (!(period_ >= shortest) || !std::isfinite(period_)) period_ = 0.0;
}

void Dashes::begin(bool closed) {
  closed_ = closed;
  started_ = moved_ = down_ = keeps_first_ = false;
  first_dash_.clear();
  if (is_full_line()) stroker_.begin(closed);
}

void Dashes::to(Vec2 p) {
  if (is_full_line()) return stroker_.to(p);
  if (!started_) {
    started_ = true;
    first_ = last_ = p;
    length_ = 0.0;
    restart_pattern(0.0);
    return;
  }
  if (p == last_) return;
  if (!moved_) {
    moved_ = true;
    if (dash_ % 2 == 0) {
      down_ = true;
      keeps_first_ = closed_;
      if (!keeps_first_) stroker_.begin(false);
      draw_to(first_);
    }
  }
  const Box2& box = stroker_.box();
  const double length = distance(last_, p);
  if (box.contains(last_) && box.contains(p)) {
    walk(last_, p);
  } else if (const auto part = clip_segment(last_, p, box)) {
    // The dashes out of sight are not drawn one by one.
    const double before = distance(last_, part->from);
    const Vec2 direction = p - last_;
    if (part->from != last_) {
      lift(direction);
      restart_pattern(length_ + before);
    }
    walk(part->from, part->to);
    if (part->to != p) {
      lift(direction);
      restart_pattern(length_ + length);
    }
  } else {
    lift(p - last_);
    restart_pattern(length_ + length);
  }
  length_ += length;
  last_ = p;
}

void Dashes::to(std::span<const Vec2> points, double scale) {
  if (is_full_line()) return stroker_.to(points, scale);
  for (const Vec2 p : points) to(device_point(p, scale));
}

void Dashes::end() {
  if (is_full_line()) return stroker_.end();
  if (!moved_) {
    stroker_.begin(false);
    stroker_.to(first_);
    stroker_.end();
    return;
  }
  const Vec2 back = first_ - last_;
  if (closed_) to(first_);
  if (keeps_first_) {
    // All of the line is one dash.
    stroker_.begin(true);
    for (const Vec2 p : first_dash_) stroker_.to(p);
    stroker_.end();
    return;
  }
  if (!first_dash_.empty()) {
    // The last dash, if one ends here, goes on in the first.
    if (!down_) {
      stroker_.begin(false);
      down_ = true;
    }
    for (const Vec2 p : first_dash_) stroker_.to(p);
  }
  lift(back == Vec2{} ? Vec2{1.0, 0.0} : back);
}

/// Goes to where the pattern is `along` a line from its start.
void Dashes::restart_pattern(double along) {
  double phase = std::fmod(offset_ + along, period_);
  if (!std::isfinite(phase)) phase = 0.0;
  if (phase < 0.0) phase += period_;
  dash_ = 0;
  while (phase > 0.0 && phase >= lengths_[dash_] && dash_ + 1 < lengths_.size()) phase -= lengths_[dash_++];
  left_ = std::fmax(0.0, lengths_[dash_] - phase);
}

/// Draws the dashes of a segment in sight.
void Dashes::walk(Vec2 from, Vec2 to) {
  const double length = distance(from, to);
  if (length == 0.0) return;
  if (!down_ && dash_ % 2 == 0) {
    // The line comes into sight within a dash.
    stroker_.begin(false);
    stroker_.to(from);
    down_ = true;
  }
  double at = 0.0;
  while (left_ <= length - at) {
    at += left_;
    next_dash(lerp(from, to, at / length), to - from);
  }
  left_ -= length - at;
  if (down_) draw_to(to);
}

/// A dash or a gap ends.
void Dashes::next_dash(Vec2 at, Vec2 direction) {
  if (down_) {
    draw_to(at);
    lift(direction);
  }
  dash_ = dash_ + 1 < lengths_.size() ? dash_ + 1 : 0;
  left_ = lengths_[dash_];
  if (dash_ % 2 == 1) return;
  stroker_.begin(false);
  stroker_.to(at);
  down_ = true;
}

void Dashes::lift(Vec2 direction) {
  if (down_ && !keeps_first_) stroker_.end(direction);
  down_ = keeps_first_ = false;
}

void Dashes::draw_to(Vec2 p) {
  if (keeps_first_) {
    first_dash_.push_back(p);
  } else {
    stroker_.to(p);
  }
}

}  // namespace burin::output::raster
