#include <cmath>
#include <numeric>
#include <utility>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/boundary_model.hpp>
#include <burin/curves/line_art/draws.hpp>

namespace burin::curves::line_art {

BoundaryModel::BoundaryModel(const LineArtBoundaryParams& params, std::uint64_t seed)
    : params_(params), seed_(seed), wander_(params.wander) {
  const auto per_start = static_cast<std::uint64_t>(params.lines_per_start);
  places_ = (static_cast<std::uint64_t>(params.lines) + per_start - 1) / per_start;
}

std::size_t BoundaryModel::point_count(std::uint64_t) const {
  std::size_t edges = 1;
  for (int level = 0; level < params_.levels; ++level) edges *= params_.markers.size() + 1;
  return edges + 1;
}

Box2 BoundaryModel::reach() const {
  Box2 box = params_.from.box();
  for (const Region& region : params_.to.all) box.add(region.box());
  // An edge moves by one offset at most, and its parts are as long as itself and two offsets.
  double moved = 0.0;
  double longest = length({box.width(), box.height()});
  double bound = params_.offset;
  for (int level = 1; level <= params_.levels; ++level) {
    const double offset = params_.unit == Offset::relative ? bound * longest : bound;
    moved += offset;
    longest += 2.0 * offset;
    bound *= params_.decay;
  }
  return box.grown(moved + longest);  // rounding stays within an edge of the polyline
}

const Region& BoundaryModel::target_of(std::uint64_t bundle) const {
  const std::vector<Region>& targets = params_.to.all;
  if (targets.size() == 1) return targets.front();
  const double u = uniform(seed_, draws::target, bundle);
  if (params_.weights.empty()) return targets[static_cast<std::size_t>(u * static_cast<double>(targets.size()))];
  double left = u * std::accumulate(params_.weights.begin(), params_.weights.end(), 0.0);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (params_.weights[i] == 0.0) continue;
    chosen = i;
    left -= params_.weights[i];
    if (left < 0.0) break;
  }
  return targets[chosen];
}

Vec2 BoundaryModel::end_of(std::uint64_t bundle, Vec2 start) const {
  const Region& target = target_of(bundle);
  PlaceKey key{.seed = seed_,
               .x_draw = draws::end_x,
               .y_draw = draws::end_y,
               .index = bundle,
               .count = places_,
               .places = params_.places};
  switch (params_.pairing) {
    case Pairing::random:
      // Of places in a sequence, only the first region's are taken in turn: else they would be paired in order.
      key.places = Places::random;
      return place_in(target, key);
    case Pairing::ordered:
    case Pairing::crossed:
      key.x_draw = draws::start_x;
      key.y_draw = draws::start_y;
      key.turned_round = params_.pairing == Pairing::crossed;
      return place_in(target, key);
    case Pairing::nearest:
      break;
  }
  constexpr std::uint64_t candidates = 16;
  key.places = Places::random;
  Vec2 nearest = place_in(target, key);
  for (key.candidate = 1; key.candidate < candidates; ++key.candidate) {
    const Vec2 place = place_in(target, key);
    if (length_squared(place - start) < length_squared(nearest - start)) nearest = place;
  }
  return nearest;
}

void BoundaryModel::refine(std::uint64_t line, int level, const std::vector<Vec2>& from, std::vector<Vec2>& to) const {
  const draws::Keyed betas(seed_, draws::beta, line, level);
  double bound = params_.offset;
  for (int l = 1; l < level; ++l) bound *= params_.decay;
  Spot spot{.line = static_cast<double>(line),
            .chance = wander_.uses_chance() ? uniform(seed_, draws::chance, line) : 0.0};
  for (std::size_t k = 1; k < from.size(); ++k) {
    const Vec2 d = from[k] - from[k - 1];
    Vec2 rho{d.y, -d.x};
    if (params_.unit == Offset::absolute) {
      const double edge = length(d);
      rho = edge > 0.0 ? Vec2{rho.x / edge, rho.y / edge} : Vec2{};
    }
    to.push_back(from[k - 1]);
    for (std::size_t q = 1; q <= params_.markers.size(); ++q) {
      const Vec2 marker = from[k - 1] + params_.markers[q - 1] * d;
      double beta = bound * betas.symmetric(k, q);
      if (wander_) {
        spot.at = marker;
        spot.along = (static_cast<double>(k - 1) + params_.markers[q - 1]) / static_cast<double>(from.size() - 1);
        const double factor = wander_(spot);
        beta = std::isfinite(factor) ? beta * factor : 0.0;
      }
      to.push_back(marker + beta * rho);
    }
  }
  to.push_back(from.back());
}

void BoundaryModel::trace(std::uint64_t line, std::vector<Vec2>& points) {
  const std::uint64_t bundle = line / static_cast<std::uint64_t>(params_.lines_per_start);
  const Vec2 start = place_in(params_.from, {.seed = seed_,
                                             .x_draw = draws::start_x,
                                             .y_draw = draws::start_y,
                                             .index = bundle,
                                             .count = places_,
                                             .places = params_.places});
  points.clear();
  points.push_back(start);
  points.push_back(end_of(bundle, start));
  for (int level = 1; level <= params_.levels; ++level) {
    spare_.clear();
    refine(line, level, points, spare_);
    std::swap(points, spare_);
  }
}

}  // namespace burin::curves::line_art
