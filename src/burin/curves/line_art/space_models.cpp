#include <cmath>
#include <utility>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/counts.hpp>
#include <burin/curves/line_art/space_models.hpp>
#include <burin/geom/direction.hpp>

namespace burin::curves::line_art {

namespace {

/// The axes that azimuths are counted in, about d: unit(d x up), and unit(d) x that, up being z. Pre: d is not zero.
struct Frame {
  Vec3 first;
  Vec3 second;
};

Frame frame_across(Vec3 d) {
  const Across axes = across(d, {0.0, 0.0, 1.0});
  return {axes.right, -axes.up};
}

Vec3 at_azimuth(const Frame& frame, double radians) {
  const Vec2 at = direction(radians);
  return at.x * frame.first + at.y * frame.second;
}

/// The unit vector h turned by an angle about an axis across it.
Vec3 turned(Vec3 h, double radians, Vec3 axis) {
  const Vec2 at = direction(radians);
  return unit(at.x * h + at.y * cross(axis, h));
}

}  // namespace

SpacePolylineModel::SpacePolylineModel(const LineArt3dParams& params, std::uint64_t seed)
    : params_(params), seed_(seed), camera_(params.camera.camera()) {}

std::size_t SpacePolylineModel::point_count(std::uint64_t line) const {
  return segment_count(params_.segments, seed_, line) + 1;
}

Box2 SpacePolylineModel::reach() const {
  const SpaceBox box = box_of(params_.start);
  // Four-point rounding may overshoot an edge by an eighth of its neighbours; two lengths more are plenty.
  const double grown = (params_.segments.high + 2.0) * params_.length.high;
  return picture_of(camera_, {box.centre(), 0.5 * box.diagonal() + grown});
}

Vec3 SpacePolylineModel::first_heading(std::uint64_t line) const {
  const double azimuth = math::tau * uniform(seed_, draws::heading, line, 1);
  if (!params_.heading) {
    const double z = uniform_symmetric(seed_, draws::heading, line, 0);
    const double r = std::sqrt(1.0 - z * z);
    const Vec2 around = r * direction(azimuth);
    return {around.x, around.y, z};
  }
  const double off = params_.spread * math::radians_per_degree * uniform(seed_, draws::heading, line, 0);
  const Vec3 heading = unit(*params_.heading);
  return turned(heading, off, at_azimuth(frame_across(heading), azimuth));
}

void SpacePolylineModel::trace(std::uint64_t line, std::vector<Vec2>& points) {
  const auto per_start = static_cast<std::uint64_t>(params_.lines_per_start);
  const auto lines = static_cast<std::uint64_t>(params_.lines);
  Vec3 at = place_in(params_.start, {.seed = seed_,
                                     .x_draw = draws::start_x,
                                     .y_draw = draws::start_y,
                                     .z_draw = draws::start_z,
                                     .index = line / per_start,
                                     .count = (lines + per_start - 1) / per_start,
                                     .places = params_.places});
  Vec3 heading = first_heading(line);
  const draws::Keyed turns(seed_, draws::turn, line);
  const draws::Keyed lengths(seed_, draws::length, line);
  const double turn = params_.turn * math::radians_per_degree;
  const auto [shortest, longest] = params_.length;
  polyline_.assign(1, at);
  const std::size_t segments = point_count(line) - 1;
  for (std::size_t s = 0; s < segments; ++s) {
    if (s > 0) {
      const Vec3 axis = at_azimuth(frame_across(heading), math::tau * turns.uniform(s, 1));
      heading = turned(heading, turn * turns.uniform(s, 0), axis);
    }
    at = at + (shortest + (longest - shortest) * lengths.uniform(s)) * heading;
    polyline_.push_back(at);
  }
  depth_ = show(camera_, polyline_, points);
}

SpaceBoundaryModel::SpaceBoundaryModel(const LineArtBoundary3dParams& params, std::uint64_t seed)
    : params_(params), seed_(seed), ends_(params, seed), camera_(params.camera.camera()) {}

std::size_t SpaceBoundaryModel::point_count(std::uint64_t) const {
  return refined_count(params_.levels, params_.markers.size());
}

Box2 SpaceBoundaryModel::reach() const {
  SpaceBox box = box_of(params_.from);
  for (const SpaceRegion& region : params_.to.all) box.add(box_of(region));
  const double grown = refined_reach(params_, box.diagonal());
  return picture_of(camera_, {box.centre(), 0.5 * box.diagonal() + grown});
}

void SpaceBoundaryModel::refine(std::uint64_t line, int level, const std::vector<Vec3>& from,
                                std::vector<Vec3>& to) const {
  const draws::Keyed betas(seed_, draws::beta, line, level);
  double bound = params_.offset;
  for (int l = 1; l < level; ++l) bound *= params_.decay;
  for (std::size_t k = 1; k < from.size(); ++k) {
    const Vec3 d = from[k] - from[k - 1];
    const double edge = length(d);
    const Frame frame = edge > 0.0 ? frame_across(d) : Frame{};
    const double unit_length = params_.unit == Offset::absolute ? 1.0 : edge;
    to.push_back(from[k - 1]);
    for (std::size_t q = 1; q <= params_.markers.size(); ++q) {
      const double beta = bound * unit_length * betas.symmetric(k, q);
      const Vec3 e = at_azimuth(frame, math::tau * betas.uniform(k, q, 1));
      to.push_back(from[k - 1] + params_.markers[q - 1] * d + beta * e);
    }
  }
  to.push_back(from.back());
}

void SpaceBoundaryModel::trace(std::uint64_t line, std::vector<Vec2>& points) {
  const std::uint64_t bundle = ends_.bundle_of(line);
  const Vec3 start = ends_.start_of(bundle);
  polyline_.assign({start, ends_.end_of(bundle, start)});
  for (int level = 1; level <= params_.levels; ++level) {
    spare_.clear();
    refine(line, level, polyline_, spare_);
    std::swap(polyline_, spare_);
  }
  depth_ = show(camera_, polyline_, points);
  if (points.size() < polyline_.size()) points.clear();
}

}  // namespace burin::curves::line_art
