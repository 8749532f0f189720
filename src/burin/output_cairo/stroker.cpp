#include <algorithm>
#include <cmath>

#include <burin/geom/clip.hpp>
#include <burin/output_cairo/stroker.hpp>

namespace burin::output_cairo {

namespace {

cairo_line_cap_t cairo_cap(Cap cap) {
  switch (cap) {
    case Cap::round:
      return CAIRO_LINE_CAP_ROUND;
    case Cap::butt:
      return CAIRO_LINE_CAP_BUTT;
    case Cap::square:
      return CAIRO_LINE_CAP_SQUARE;
  }
  return CAIRO_LINE_CAP_ROUND;
}

cairo_line_join_t cairo_join(Join join) {
  switch (join) {
    case Join::round:
      return CAIRO_LINE_JOIN_ROUND;
    case Join::miter:
      return CAIRO_LINE_JOIN_MITER;
    case Join::bevel:
      return CAIRO_LINE_JOIN_BEVEL;
  }
  return CAIRO_LINE_JOIN_ROUND;
}

/// How far the pieces of a cut contour lie over each other, in device units: enough to hide the cut, and not more,
/// since the soft edges there are drawn twice.
constexpr double overlap = 2.0;

/// How far from its points a stroke of this style can have ink.
double ink_reach(const StrokeStyle& style) {
  const double corner = style.join == Join::miter ? std::max(1.5, style.miter_limit) : 1.5;
  return std::min(0.5 * style.width * corner, farthest);
}

/// Leaves the end of `piece`, from `length` before its last point on: at most 16 segments.
void keep_tail(std::vector<Vec2>& piece, double length) {
  std::size_t first = piece.size() - 1;
  const std::size_t lowest = first - std::min<std::size_t>(first, 16);
  double left = length;
  while (first > lowest && left > 0.0) {
    const double edge = distance(piece[first], piece[first - 1]);
    --first;
    if (edge > left) piece[first] = lerp(piece[first + 1], piece[first], left / edge);
    left -= edge;
  }
  piece.erase(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(first));
}

/// The point `by` beyond `end`, coming from `before`.
Vec2 beyond(Vec2 before, Vec2 end, double by) {
  const double edge = distance(before, end);
  return edge > 0.0 ? end + (by / edge) * (end - before) : end;
}

}  // namespace

void Stroker::set_style(const StrokeStyle& style) {
  flush();
  style_ = style;
  style_.width = std::min(style.width, farthest);
  style_.miter_limit = std::clamp(style.miter_limit, 1.0, std::max(1.0, 2.0 * farthest / style_.width));
  box_ = page_.grown(ink_reach(style_) + 2.0);
  dash_period_ = 0.0;
  for (const double dash : style_.dashes) dash_period_ += dash;
  // An odd list of dashes is read twice: what was on is then off.
  if (style_.dashes.size() % 2 == 1) {
    style_.dashes.insert(style_.dashes.end(), style.dashes.begin(), style.dashes.end());
    dash_period_ *= 2.0;
  }
  cairo_set_line_width(to_, style_.width);
  cairo_set_line_join(to_, cairo_join(style_.join));
  cairo_set_miter_limit(to_, style_.miter_limit);
}

void Stroker::flush() {
  if (gathered_segments_ == 0) return;
  cairo_set_line_cap(to_, gathered_.cap);
  if (gathered_.dash_phase) {
    cairo_set_dash(to_, style_.dashes.data(), static_cast<int>(style_.dashes.size()), *gathered_.dash_phase);
  } else {
    cairo_set_dash(to_, nullptr, 0, 0.0);
  }
  cairo_stroke(to_);
  gathered_segments_ = 0;
}

/// What goes into Cairo's path next, and has this many segments, is to be stroked like this.
void Stroker::gather(const Gathered& as, std::size_t segments) {
  if (gathered_ != as || gathered_segments_ + segments > piece_segments) flush();
  gathered_ = as;
  gathered_segments_ += segments;
}

void Stroker::begin_contour(bool closed) {
  closed_ = closed;
  started_ = false;
}

void Stroker::add(std::span<const Vec2> points, double device_per_mm) {
  const double grain = dashed() ? 0.0 : grain_;  // leaving out points would move the dashes
  for (const Vec2 point : points) {
    newest_ = device_point(point, device_per_mm);
    if (!started_) {
      start(newest_);
    } else if (distance(newest_, last_) > grain) {
      step(newest_);
    }
  }
}

void Stroker::end_contour() {
  if (newest_ != last_ && !closed_) step(newest_);
  if (!moved_) {
    if (inside_) stroke_dot(first_);
  } else if (closed_) {
    close();
  } else {
    stroke_piece(Tail::real_end);
  }
}

void Stroker::start(Vec2 p) {
  started_ = true;
  moved_ = false;
  inside_ = whole_ = piece_starts_contour_ = box_.contains(p);
  first_ = last_ = p;
  length_ = piece_begin_ = 0.0;
  piece_.clear();
  if (inside_) piece_.push_back(p);
}

/// Goes on to p, which is not last_.
void Stroker::step(Vec2 p) {
  if (!moved_) second_ = p;
  moved_ = true;
  const bool p_inside = box_.contains(p);
  if (inside_ && p_inside) {
    piece_.push_back(p);
  } else {
    step_across_border(p, p_inside);
  }
  if (dashed()) length_ += distance(last_, p);
  inside_ = p_inside;
  last_ = p;
  if (piece_.size() > piece_segments) cut();
}

void Stroker::step_across_border(Vec2 p, bool p_inside) {
  whole_ = false;
  const auto part = clip_segment(last_, p, box_);
  if (!part) return;
  if (!inside_) {
    piece_.assign(1, part->from);
    piece_starts_contour_ = false;
    piece_begin_ = length_ + (dashed() ? distance(last_, part->from) : 0.0);
  }
  piece_.push_back(part->to);
  if (!p_inside) {
    stroke_piece(Tail::cut);
    piece_.clear();
  }
}

void Stroker::cut() {
  if (dashed() && !between_dashes(length_)) return;
  whole_ = false;
  stroke_piece(Tail::cut);
  keep_tail(piece_, dashed() ? 0.0 : overlap);
  piece_starts_contour_ = false;
  piece_begin_ = length_;
}

void Stroker::close() {
  if (whole_) {
    stroke_piece(Tail::real_end);
    return;
  }
  if (last_ != first_) step(first_);
  // Beyond the first point, so that the join there is drawn.
  const double edge = distance(first_, second_);
  if (!dashed()) step(edge > overlap ? lerp(first_, second_, overlap / edge) : second_);
  stroke_piece(Tail::cut);
}

void Stroker::stroke_piece(Tail tail) {
  if (piece_.size() < 2) return;
  const bool cap_at_front = piece_starts_contour_ && !closed_;
  const bool cap_at_back = tail == Tail::real_end && !closed_;
  if (whole_ || dashed() || style_.cap == Cap::butt) {
    Gathered as{.cap = cairo_cap(style_.cap)};
    if (dashed()) as.dash_phase = dash_phase(piece_begin_);
    gather(as, piece_.size());
    path_through_piece();
    if (closed_ && tail == Tail::real_end) cairo_close_path(to_);
  } else {
    stroke_piece_with_caps(cap_at_front, cap_at_back);
  }
}

/// Cairo would give both ends of the piece a cap: here they get their own, or none.
void Stroker::stroke_piece_with_caps(bool at_front, bool at_back) {
  if (style_.cap == Cap::square) {
    if (at_front) piece_.front() = beyond(piece_[1], piece_.front(), 0.5 * style_.width);
    if (at_back) piece_.back() = beyond(piece_[piece_.size() - 2], piece_.back(), 0.5 * style_.width);
  }
  gather({.cap = CAIRO_LINE_CAP_BUTT}, piece_.size());
  path_through_piece();
  if (style_.cap == Cap::round) {
    if (at_front) stroke_dot(piece_.front());
    if (at_back) stroke_dot(piece_.back());
  }
}

void Stroker::stroke_dot(Vec2 at) {
  if (style_.cap == Cap::butt) return;
  // Cairo draws no square about a point: it would not know its direction.
  const double half = style_.cap == Cap::square ? 0.5 * style_.width : 0.0;
  gather({.cap = style_.cap == Cap::square ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND}, 1);
  cairo_move_to(to_, at.x - half, at.y);
  cairo_line_to(to_, at.x + half, at.y);
}

void Stroker::path_through_piece() {
  cairo_move_to(to_, piece_.front().x, piece_.front().y);
  for (const Vec2 p : std::span(piece_).subspan(1)) cairo_line_to(to_, p.x, p.y);
}

/// Where in the pattern of dashes the contour is at `length`, in [0, period).
double Stroker::dash_phase(double length) const {
  const double along = std::fmod(style_.dash_offset + length, dash_period_);
  if (!std::isfinite(along)) return 0.0;
  return along < 0.0 ? along + dash_period_ : along;
}

bool Stroker::between_dashes(double length) const {
  double left = dash_phase(length);
  bool on = true;
  for (const double dash : style_.dashes) {
    if (left < dash) return !on;
    left -= dash;
    on = !on;
  }
  return false;
}

}  // namespace burin::output_cairo
