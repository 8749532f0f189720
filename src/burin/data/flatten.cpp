#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/data/flatten.hpp>

namespace burin::data {
namespace {

constexpr double smallest_radius = 1e-100;
constexpr double smallest_chord_squared = 1e-200;

/// How many chords keep to the tolerance when one misses by `error_of_one`: the error falls with their square.
int chords_for(double error_of_one, double tolerance) {
  if (!(error_of_one > 0.0)) return 1;
  const double chords = std::ceil(std::sqrt(error_of_one / tolerance));
  return chords < max_chords ? std::max(1, static_cast<int>(chords)) : max_chords;
}

}  // namespace

void flatten_quadratic(Vec2 start, Vec2 control, Vec2 end, double tolerance, std::vector<Vec2>& points) {
  const Vec2 bend = start - 2.0 * control + end;
  const int chords = chords_for(0.25 * length(bend), tolerance);
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    points.push_back(lerp(lerp(start, control, t), lerp(control, end, t), t));
  }
  points.push_back(end);
}

void flatten_cubic(Vec2 start, Vec2 control_1, Vec2 control_2, Vec2 end, double tolerance, std::vector<Vec2>& points) {
  const double bend = std::max(length(start - 2.0 * control_1 + control_2), length(control_1 - 2.0 * control_2 + end));
  const int chords = chords_for(0.75 * bend, tolerance);
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    const Vec2 middle = lerp(control_1, control_2, t);
    points.push_back(lerp(lerp(lerp(start, control_1, t), middle, t), lerp(middle, lerp(control_2, end, t), t), t));
  }
  points.push_back(end);
}

/// The ellipse is taken to the unit circle, where the chord from start to end has half length |h| and the start is at
/// `from`. Everything is told from the start and not from the center, which keeps nearly straight arcs exact.
void flatten_arc(Vec2 start, const EllipticArc& arc, Vec2 end, double tolerance, std::vector<Vec2>& points) {
  if (start == end) return;
  Vec2 radii{std::abs(arc.radii.x), std::abs(arc.radii.y)};
  const double cosine = math::cos_degrees(arc.turn_degrees);
  const double sine = math::sin_degrees(arc.turn_degrees);
  const Vec2 half = 0.5 * (start - end);
  Vec2 h;
  if (std::min(radii.x, radii.y) >= smallest_radius) {
    h = {(cosine * half.x + sine * half.y) / radii.x, (cosine * half.y - sine * half.x) / radii.y};
  }
  double squared = length_squared(h);
  if (!(squared > smallest_chord_squared)) {
    points.push_back(end);
    return;
  }
  if (squared > 1.0) {
    const double grow = std::sqrt(squared);
    radii = grow * radii;
    h = (1.0 / grow) * h;
    squared = 1.0;
  }
  const double to_center = (arc.large == arc.sweep ? -1.0 : 1.0) * std::sqrt((1.0 - squared) / squared);
  const Vec2 from{h.x - to_center * h.y, h.y + to_center * h.x};
  const double small_turn = 2.0 * math::asin(std::min(1.0, std::sqrt(squared)));
  const double turn = (arc.large ? math::tau - small_turn : small_turn) * (arc.sweep ? 1.0 : -1.0);

  // A chord over the angle a misses a circle of radius r by r (1 - cos(a / 2)) <= r a^2 / 8.
  const int chords = chords_for(std::max(radii.x, radii.y) * turn * turn / 8.0, tolerance);
  for (int i = 1; i < chords; ++i) {
    const double angle = turn * i / chords;
    const double half_sine = math::sin(0.5 * angle);
    const Vec2 step = complex_product(from, {-2.0 * half_sine * half_sine, math::sin(angle)});
    const Vec2 along{radii.x * step.x, radii.y * step.y};
    points.push_back(start + Vec2{cosine * along.x - sine * along.y, sine * along.x + cosine * along.y});
  }
  points.push_back(end);
}

}  // namespace burin::data
