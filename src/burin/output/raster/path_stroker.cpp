#include <algorithm>
#include <array>
#include <cmath>

#include <burin/geom/clip.hpp>
#include <burin/output/raster/path_stroker.hpp>

namespace burin::output::raster {

namespace {

constexpr double most_pixels = 131072.0;
constexpr std::size_t most_at_once = 128;

double cross_of(Point a, Point b) {
  return static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
}
double dot_of(Point a, Point b) {
  return static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y;
}

}  // namespace

void PathStroker::set_style(const StrokeStyle& style) {
  style_ = style;
  style_.width = std::clamp(style.width, 0.0, most_pixels);
  half_width_ = 0.5 * style_.width * units_per_pixel;
  pen_ = RoundPen(half_width_);
  const double corner = style_.join == Join::miter ? std::max(1.5, style_.miter_limit) : 1.5;
  const Box2 sight = page_.grown(std::min(0.5 * style_.width * corner, most_pixels) + 2.0);
  const auto in_units = [](double pixels, double round_up) {
    return static_cast<int>(std::floor(units_per_pixel * pixels + round_up));
  };
  sight_ = {in_units(sight.low.x, 0.0), in_units(sight.low.y, 0.0), in_units(sight.high.x, 1.0),
            in_units(sight.high.y, 1.0)};
  // To cut a line off moves it by up to a unit: only where it must be.
  constexpr double far_away = 16384.0;
  box_ = sight.grown(far_away);
}

void PathStroker::begin(bool closed) {
  closed_ = closed;
  started_ = false;
}

void PathStroker::to(Vec2 p) {
  if (!started_) {
    started_ = true;
    moved_ = has_second_ = false;
    exact_first_ = exact_ = p;
    inside_ = run_is_first_ = box_.contains(p);
    run_length_ = 0;
    if (inside_) {
      enter(p);
      first_ = last_;
    }
    return;
  }
  const bool p_inside = box_.contains(p);
  if (inside_ && p_inside) {
    step(nearest_point(p));
  } else if (p != exact_) {
    moved_ = true;
    if (const auto part = clip_segment(exact_, p, box_)) {
      if (!inside_) {
        run_is_first_ = false;
        enter(part->from);
      }
      step(nearest_point(part->to));
    }
  }
  inside_ = p_inside;
  if (!inside_) run_length_ = 0;
  exact_ = p;
}

void PathStroker::to(std::span<const Vec2> points, double scale) {
  while (!points.empty()) {
    const std::size_t count = std::min(points.size(), most_at_once);
    const std::span<const Vec2> next = points.first(count);
    if (!round_line_to(next, scale)) {
      for (const Vec2 p : next) to(device_point(p, scale));
    }
    points = points.subspan(count);
  }
}

/// to() for a few points of a line with round joins and caps that are all in the box; false, and nothing, for others.
bool PathStroker::round_line_to(std::span<const Vec2> points, double scale) {
  if (!started_ || !inside_ || !is_round()) return false;
  Box2 reach;
  reach.add(exact_);
  for (const Vec2 p : points) reach.add(scale * p);
  if (!(box_.contains(reach.low) && box_.contains(reach.high))) return false;
  if (nearest_point(reach.low) != last_ || nearest_point(reach.high) != last_) {
    moved_ = true;
    run_length_ = 2;
  }
  const double around = 0.5 * style_.width + 1.0;
  if (ink_.shows(reach.low.y - around, reach.high.y + around)) {
    std::array<Point, 1 + most_at_once> line;
    line[0] = last_;
    for (std::size_t k = 0; k < points.size(); ++k) line[k + 1] = nearest_point(scale * points[k]);
    ink_.add(pen_, std::span(line).first(points.size() + 1));
  }
  last_ = nearest_point(scale * points.back());
  exact_ = scale * points.back();
  return true;
}

void PathStroker::end(Vec2 direction) {
  if (!moved_) {
    if (inside_) dot(last_, direction);
  } else if (closed_) {
    close();
  } else if (run_length_ == 2) {
    cap(last_, before_);
  }
}

void PathStroker::enter(Vec2 at) {
  last_ = nearest_point(at);
  run_length_ = 1;
}

void PathStroker::step(Point p) {
  if (p == last_) return;
  moved_ = true;
  if (can_show(last_, p)) {
    if (is_round()) {
      ink_.add(pen_, std::array{last_, p});
    } else {
      ink_.add(segment_body(last_, p, half_width_));
    }
  }
  if (run_length_ == 2) {
    if (!is_round()) join(before_, last_, p);
  } else if (run_is_first_) {
    second_ = p;
    has_second_ = true;
    if (!closed_ && !is_round()) cap(last_, p);
  }
  before_ = last_;
  last_ = p;
  run_length_ = 2;
}

void PathStroker::close() {
  to(exact_first_);
  if (has_second_ && run_length_ == 2 && !is_round()) join(before_, last_, second_);
}

bool PathStroker::can_show(Point a, Point b) const {
  return std::max(a.x, b.x) >= sight_.left && std::min(a.x, b.x) <= sight_.right && std::max(a.y, b.y) >= sight_.top &&
         std::min(a.y, b.y) <= sight_.bottom;
}

void PathStroker::cap(Point end, Point inner) {
  if (style_.cap == Cap::round) ink_.add(disc(end, half_width_));
  if (style_.cap == Cap::square) ink_.add(square_cap(inner, end, half_width_));
}

void PathStroker::join(Point before, Point corner, Point after) {
  if (!can_show(corner, corner)) return;
  const Point in = corner - before;
  const Point out = after - corner;
  const double turn = cross_of(in, out);
  const double ahead = dot_of(in, out);
  if (turn == 0.0 && ahead > 0.0) return;
  if (style_.join == Join::round) {
    ink_.add(join_sector(corner, in, out, half_width_));
    return;
  }
  if (turn == 0.0) return;
  // The miter is as long as 1 / sin(angle / 2) widths, and 2 sin^2(angle / 2) = 1 + cos(turn).
  const double cosine = ahead / std::sqrt(dot_of(in, in) * dot_of(out, out));
  const bool is_miter = style_.join == Join::miter && style_.miter_limit * style_.miter_limit * (1.0 + cosine) >= 2.0;
  ink_.add(is_miter ? join_miter(corner, in, out, half_width_) : join_bevel(corner, in, out, half_width_));
}

void PathStroker::dot(Point at, Vec2 direction) {
  if (style_.cap == Cap::round) ink_.add(disc(at, half_width_));
  if (style_.cap == Cap::square) ink_.add(square(at, direction, half_width_));
}

}  // namespace burin::output::raster
