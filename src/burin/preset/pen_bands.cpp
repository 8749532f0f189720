#include <algorithm>
#include <cmath>

#include <burin/path/recording.hpp>
#include <burin/preset/pen_bands.hpp>

namespace burin::preset {

PenBand::PenBand(PathSink& next, const PenChoice& choice, std::size_t band, const primitives::Setting& setting)
    : Decorator(next), choice_(choice), band_(band), setting_(setting), used_(choice.used()), pieces_(next) {}

bool PenBand::inside(Vec2 point, Vec2 direction) const {
  const primitives::Frame frame{point, direction, direction, edge_index_};
  return choice_.pick(primitives::position_values(setting_, place_, frame, used_)) == band_;
}

Flow PenBand::begin(const PathHead& head) {
  head_ = head;
  place_ = {head.level, next_path_++};
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
  const double edge_mm = length(setting_.slot_from_model.linear(direction));
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
