#include <algorithm>
#include <array>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/pen_bands.hpp>

namespace burin::preset {

namespace {

constexpr std::uint64_t band_purpose = 3;
constexpr double degrees_per_radian = 180.0 / math::pi;

/// Half-open bands; NaN falls into the first.
std::size_t band_of(double value, const std::vector<double>& at) {
  std::size_t band = 0;
  while (band < at.size() && value >= at[band]) ++band;
  return band;
}

double angle_degrees(Vec2 v) {
  return math::atan2(v.y, v.x) * degrees_per_radian;
}

}  // namespace

PenBand::PenBand(PathSink& next, const PenChoice& choice, std::size_t band, const Copy& copy, const SlotFrame& frame,
                 const DrawContext& context)
    : Decorator(next),
      choice_(choice),
      band_(band),
      copy_(copy),
      frame_(frame),
      seed_(context.seed),
      origin_(context.origin),
      pieces_(next) {}

bool PenBand::inside(Vec2 from_origin, Vec2 direction) {
  const Vec2 point = origin_ + from_origin;
  const Vec2 p = copy_.slot_from_model(point);
  std::array<double, band_variables.size()> values{};
  // In the order of band_variables; angles cost most and are seldom asked for.
  values = {point.x,
            point.y,
            choice_.by.uses(2) ? length(point) : 0.0,
            choice_.by.uses(3) ? angle_degrees(point) : 0.0,
            p.x,
            p.y,
            choice_.by.uses(6) ? length(p) : 0.0,
            0.5 + p.x / frame_.width_mm,
            0.5 + p.y / frame_.height_mm,
            static_cast<double>(head_.level),
            static_cast<double>(edge_index_),
            choice_.by.uses(11) ? angle_degrees(direction) : 0.0,
            static_cast<double>(copy_.column),
            static_cast<double>(copy_.row),
            static_cast<double>(copy_.index),
            choice_.by.uses(15) ? uniform(seed_, band_purpose, copy_.index, edge_index_) : 0.0};
  return band_of(choice_.by(values), choice_.at) == band_;
}

Flow PenBand::begin(const PathHead& head) {
  head_ = head;
  edge_index_ = 0;
  contour_points_ = 0;
  return Flow::go;
}

Flow PenBand::points(std::span<const Vec2> points) {
  for (const Vec2 p : points) {
    if (contour_points_++ == 0) {
      first_ = p;
    } else if (edge(last_, p) == Flow::stop) {
      return Flow::stop;
    }
    last_ = p;
  }
  return Flow::go;
}

Flow PenBand::edge(Vec2 from, Vec2 to) {
  constexpr double step_mm = 0.5;
  constexpr double most_steps = 10000.0;
  constexpr int bisections = 30;
  const Vec2 direction = to - from;
  const double edge_mm = length(copy_.slot_from_model.linear(direction));
  const auto steps = static_cast<int>(std::clamp(std::ceil(edge_mm / step_mm), 1.0, most_steps));
  const auto at = [&](double t) { return t == 1.0 ? to : from + t * direction; };
  bool was_inside = inside(from, direction);
  double begun = 0.0;
  double before = 0.0;
  for (int step = 1; step <= steps; ++step) {
    const double here = static_cast<double>(step) / steps;
    const bool is_inside = inside(at(here), direction);
    if (is_inside != was_inside) {
      double low = before;
      double high = here;
      for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (low + high);
        (inside(at(middle), direction) == was_inside ? low : high) = middle;
      }
      if (was_inside && (pieces_.draw(head_, at(begun), at(high)) == Flow::stop || pieces_.lift() == Flow::stop))
        return Flow::stop;
      begun = high;
      was_inside = is_inside;
    }
    before = here;
  }
  ++edge_index_;
  return was_inside ? pieces_.draw(head_, at(begun), to) : pieces_.lift();
}

Flow PenBand::finish_contour() {
  if (contour_points_ == 1) {
    if (inside(first_, {}) && pieces_.draw(head_, first_, first_) == Flow::stop) return Flow::stop;
  } else if (head_.closed && edge(last_, first_) == Flow::stop) {
    return Flow::stop;
  }
  contour_points_ = 0;
  return pieces_.lift();
}

Flow PenBand::contour() {
  return finish_contour();
}

Flow PenBand::end() {
  return finish_contour();
}

Flow PenBand::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  return PathSink::place(head, figure, at);
}

}  // namespace burin::preset
