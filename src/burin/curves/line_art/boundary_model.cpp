#include <cmath>
#include <utility>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/boundary_model.hpp>
#include <burin/curves/line_art/counts.hpp>
#include <burin/curves/line_art/draws.hpp>

namespace burin::curves::line_art {

BoundaryModel::BoundaryModel(const LineArtBoundaryParams& params, std::uint64_t seed)
    : params_(params), seed_(seed), ends_(params, seed), wander_(params.wander) {}

std::size_t BoundaryModel::point_count(std::uint64_t) const {
  return refined_count(params_.levels, params_.markers.size());
}

Box2 BoundaryModel::reach() const {
  Box2 box = params_.from.box();
  for (const Region& region : params_.to.all) box.add(region.box());
  return box.grown(refined_reach(params_, length(Vec2{box.width(), box.height()})));
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
  const std::uint64_t bundle = ends_.bundle_of(line);
  const Vec2 start = ends_.start_of(bundle);
  points.assign({start, ends_.end_of(bundle, start)});
  for (int level = 1; level <= params_.levels; ++level) {
    spare_.clear();
    refine(line, level, points, spare_);
    std::swap(points, spare_);
  }
}

}  // namespace burin::curves::line_art
