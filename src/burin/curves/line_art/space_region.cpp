#include <algorithm>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/line_art/space_region.hpp>
#include <burin/geom/direction.hpp>

namespace burin::curves::line_art {

namespace {

/// The third number that says which place is meant.
double third_chance(const PlaceKey& key) {
  return key.candidate == 0 ? uniform(key.seed, key.z_draw, key.index)
                            : uniform(key.seed, key.z_draw, key.index, key.candidate);
}

/// A unit vector from two numbers in [0, 1): uniform on the sphere when they are.
Vec3 direction_of(Vec2 uv) {
  const double z = 2.0 * uv.x - 1.0;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double azimuth = math::tau * uv.y;
  const Vec2 around = r * direction(azimuth);
  return {around.x, around.y, z};
}

Vec3 on_track(const SpaceTrackRegion& track, double u) {
  const double target = u * track.lengths.back();
  const auto found = std::upper_bound(track.lengths.begin(), track.lengths.end(), target);
  std::size_t edge =
      std::min<std::size_t>(static_cast<std::size_t>(found - track.lengths.begin()), track.lengths.size() - 1);
  const double before = edge == 0 ? 0.0 : track.lengths[edge - 1];
  const double edge_length = track.lengths[edge] - before;
  const double share = edge_length > 0.0 ? std::min((target - before) / edge_length, 1.0) : 0.0;
  for (const SpacePolyline& polyline : track.polylines) {
    if (edge < polyline.edge_count()) return lerp(polyline.edge_begin(edge), polyline.edge_end(edge), share);
    edge -= polyline.edge_count();
  }
  contract_broken("an edge of the track");
}

struct PlaceInSpace {
  const PlaceKey& key;

  Vec3 operator()(const SpaceSpotRegion& spot) const { return spot.at; }
  Vec3 operator()(const SpaceSegmentRegion& segment) const {
    return lerp(segment.from, segment.to, chances(key, false, 0).x);
  }
  Vec3 operator()(const BoxRegion& box) const {
    const Vec2 uv = chances(key, true, 0);
    const Vec3 d = box.high - box.low;
    return {box.low.x + d.x * uv.x, box.low.y + d.y * uv.y, box.low.z + d.z * third_chance(key)};
  }
  Vec3 operator()(const BallRegion& ball) const {
    const double share = ball.is_hollow ? 1.0 : math::cbrt(third_chance(key));
    return ball.centre + (share * ball.radius) * direction_of(chances(key, true, 0));
  }
  Vec3 operator()(const PlanarRegion& planar) const {
    const Vec2 p = place_in(Region{planar.area}, key);
    return planar.origin + p.x * planar.axes.right + p.y * planar.axes.up;
  }
  Vec3 operator()(const SpaceTrackRegion& track) const { return on_track(track, chances(key, false, 0).x); }
};

SpaceBox around(const std::vector<Vec3>& points) {
  SpaceBox box{points.front(), points.front()};
  for (const Vec3 p : points) box.add({p, p});
  return box;
}

struct SpaceBoxOf {
  SpaceBox operator()(const SpaceSpotRegion& spot) const { return {spot.at, spot.at}; }
  SpaceBox operator()(const SpaceSegmentRegion& segment) const { return around({segment.from, segment.to}); }
  SpaceBox operator()(const BoxRegion& box) const { return around({box.low, box.high}); }
  SpaceBox operator()(const BallRegion& ball) const {
    const Vec3 r{ball.radius, ball.radius, ball.radius};
    return {ball.centre - r, ball.centre + r};
  }
  SpaceBox operator()(const PlanarRegion& planar) const {
    std::vector<Vec3> corners;
    for (const Polyline& outline : planar.area.outlines) {
      for (const Vec2 p : outline.points) {
        corners.push_back(planar.origin + p.x * planar.axes.right + p.y * planar.axes.up);
      }
    }
    return around(corners);
  }
  SpaceBox operator()(const SpaceTrackRegion& track) const {
    SpaceBox box = around(track.polylines.front().points);
    for (const SpacePolyline& polyline : track.polylines) box.add(around(polyline.points));
    return box;
  }
};

}  // namespace

void SpaceBox::add(const SpaceBox& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
}

SpaceBox box_of(const SpaceRegion& region) {
  return std::visit(SpaceBoxOf{}, region.shape);
}

Vec3 place_in(const SpaceRegion& region, const PlaceKey& key) {
  return std::visit(PlaceInSpace{key}, region.shape);
}

}  // namespace burin::curves::line_art
