#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/counts.hpp>
#include <burin/curves/line_art/draws.hpp>
#include <burin/curves/line_art/polyline_model.hpp>
#include <burin/geom/direction.hpp>

namespace burin::curves::line_art {

namespace {

/// The turn from one heading to another, in [-pi, pi].
double turn_between(double from, double to) {
  const double turn = to - from;
  return turn - math::tau * std::floor(turn / math::tau + 0.5);
}

}  // namespace

/// Where a polyline has come to.
struct PolylineModel::Walk {
  Spot spot;
  double heading = 0.0;    ///< radians
  double flow_turn = 0.0;  ///< pi when it goes against the flow
  std::size_t segments = 1;
};

PolylineModel::PolylineModel(const LineArtParams& params, std::uint64_t seed)
    : params_(params), seed_(seed), flow_(params.flow), stretch_(params.stretch) {}

std::size_t PolylineModel::point_count(std::uint64_t line) const {
  return segment_count(params_.segments, seed_, line) + 1;
}

Box2 PolylineModel::reach() const {
  // Four-point rounding may overshoot an edge by an eighth of its neighbours; two lengths more are plenty.
  return params_.start.box().grown((params_.segments.high + 2.0) * params_.length.high);
}

Vec2 PolylineModel::start_of(std::uint64_t line) const {
  const auto per_start = static_cast<std::uint64_t>(params_.lines_per_start);
  const auto lines = static_cast<std::uint64_t>(line_count());
  return place_in(params_.start, {.seed = seed_,
                                  .x_draw = draws::start_x,
                                  .y_draw = draws::start_y,
                                  .index = line / per_start,
                                  .count = (lines + per_start - 1) / per_start,
                                  .places = params_.places});
}

double PolylineModel::first_heading(std::uint64_t line, const Spot& spot) const {
  const bool is_given = flow_ || params_.heading || params_.spread > 0.0;
  if (!is_given) return math::tau * uniform(seed_, draws::heading, line);
  double heading = 0.0;
  if (flow_) {
    heading = flow_(spot) * math::radians_per_degree;
  } else if (params_.heading) {
    heading = *params_.heading * math::radians_per_degree;
  } else {
    const auto bundle = line / static_cast<std::uint64_t>(params_.lines_per_start);
    heading = math::tau * uniform(seed_, draws::bundle, bundle);
  }
  if (params_.spread == 0.0) return heading;
  return heading + params_.spread * math::radians_per_degree * uniform_symmetric(seed_, draws::heading, line);
}

void PolylineModel::grow(Walk walk, std::size_t first_segment, std::size_t end_segment,
                         std::vector<Vec2>& points) const {
  const auto line = static_cast<std::uint64_t>(walk.spot.line);
  const draws::Keyed turns(seed_, draws::turn, line);
  const draws::Keyed lengths(seed_, draws::length, line);
  const double turn = params_.turn * math::radians_per_degree;
  const auto [shortest, longest] = params_.length;
  for (std::size_t s = first_segment; s < end_segment; ++s) {
    walk.spot.along = static_cast<double>(s) / static_cast<double>(walk.segments);
    if (s > first_segment) {
      if (flow_ && params_.follow > 0.0) {
        const double flow = flow_(walk.spot) * math::radians_per_degree + walk.flow_turn;
        walk.heading += params_.follow * turn_between(walk.heading, flow);
      }
      walk.heading += turn * turns.symmetric(s);
    }
    double length = shortest + (longest - shortest) * lengths.uniform(s);
    if (stretch_) {
      const double factor = stretch_(walk.spot);
      if (!(factor > 0.0)) return;
      length *= factor;
    }
    const Vec2 next = walk.spot.at + length * direction(walk.heading);
    if (!is_finite(next)) return;
    points.push_back(next);
    walk.spot.at = next;
  }
}

void PolylineModel::trace(std::uint64_t line, std::vector<Vec2>& points) const {
  points.clear();
  Walk walk;
  walk.spot = {.at = start_of(line),
               .line = static_cast<double>(line),
               .chance = flow_.uses_chance() || stretch_.uses_chance() ? uniform(seed_, draws::chance, line) : 0.0};
  walk.heading = first_heading(line, walk.spot);
  walk.segments = point_count(line) - 1;
  const std::size_t forward = params_.grow == Grow::both ? (walk.segments + 1) / 2 : walk.segments;
  if (forward < walk.segments) {
    Walk back = walk;
    back.heading += math::pi;
    back.flow_turn = math::pi;
    grow(back, forward, walk.segments, points);
    std::reverse(points.begin(), points.end());
  }
  points.push_back(walk.spot.at);
  grow(walk, 0, forward, points);
}

}  // namespace burin::curves::line_art
