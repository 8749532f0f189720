#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/line_art/space_region.hpp>
#include <burin/params/number_list.hpp>

/// How regions in space are written in presets.
namespace burin::curves::line_art {

namespace {

/// The keys of a region written as a table.
struct SpaceRegionSpec {
  std::optional<Vec3> point;
  std::optional<std::array<double, 6>> segment;
  std::optional<std::array<double, 6>> box;
  std::optional<std::array<double, 4>> ball;
  std::optional<std::array<double, 4>> sphere;
  std::optional<SpaceBase> polygon;
  std::optional<SpaceBase> along;

  static constexpr auto fields() {
    using params::field;
    return std::tuple{
        field("point", &SpaceRegionSpec::point, "[x, y, z]"),
        field("segment", &SpaceRegionSpec::segment, "[x0, y0, z0, x1, y1, z1]: its two ends"),
        field("box", &SpaceRegionSpec::box, "[x0, y0, z0, x1, y1, z1]: two opposite corners"),
        field("ball", &SpaceRegionSpec::ball, "[x, y, z, radius]: all of it"),
        field("sphere", &SpaceRegionSpec::sphere, "[x, y, z, radius]: its surface"),
        field("polygon", &SpaceRegionSpec::polygon,
              "the inside of one plane polygon: { points = [[x, y, z], ...] }, or a base in the plane z = 0"),
        field("along", &SpaceRegionSpec::along,
              "the line of a base, by its length: { knot = [2, 3], n = 400 }, { solid = \"cube\" }")};
  }
};
static_assert(params::ParamStruct<SpaceRegionSpec>);

/// Twice the area of a polygon as a vector across it (Newell). Pre: not empty.
Vec3 area_vector(const std::vector<Vec3>& points) {
  Vec3 sum{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum = sum + cross(points[i] - points.front(), points[(i + 1) % points.size()] - points.front());
  }
  return sum;
}

std::optional<PlanarRegion> planar_of(const SpaceBase& base, const Where& where, params::ReadContext& context) {
  constexpr double rounding = 1e-6;
  const auto fail = [&](const char* message) {
    context.report(where, message);
    return std::nullopt;
  };
  if (!base.is_in_space()) {
    const std::optional<AreaRegion> area = area_of(base.plane, where, context);
    if (!area) return std::nullopt;
    return PlanarRegion{*area, {}, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  }
  if (base.space.size() != 1) return fail("a region needs one polygon");
  const std::vector<Vec3>& points = base.space.front().points;
  const Vec3 normal = unit(area_vector(points));
  if (normal == Vec3{}) return fail("the polygon has no area");
  PlanarRegion planar{{}, points.front(), across(normal, {0.0, 0.0, 1.0})};
  BaseShape flat{{{{}, true}}, {}};
  double size = 0.0;
  for (const Vec3 p : points) size = std::max(size, distance(p, planar.origin));
  for (const Vec3 p : points) {
    const Vec3 d = p - planar.origin;
    if (std::abs(dot(normal, d)) > rounding * size) return fail("the points of the polygon do not lie in one plane");
    flat.polylines.front().points.push_back({dot(planar.axes.right, d), dot(planar.axes.up, d)});
  }
  const std::optional<AreaRegion> area = area_of(flat, where, context);
  if (!area) return std::nullopt;
  planar.area = *area;
  return planar;
}

bool read_ball(const std::array<double, 4>& numbers, bool is_hollow, const Where& where, SpaceRegion& region,
               params::ReadContext& context) {
  const auto [x, y, z, radius] = numbers;
  if (!(radius > 0.0)) {
    context.report(where, fmt::format("a radius is above 0, found {}", shortest_text(radius)));
    return false;
  }
  region.shape = BallRegion{{x, y, z}, radius, is_hollow};
  return true;
}

bool read_spec(const params::Table& table, const Where& where, SpaceRegion& region, params::ReadContext& context) {
  SpaceRegionSpec spec;
  if (!params::read_fields(table, spec, "region in space", context)) return false;
  if (!check_one_key(table, "a region in space", space_region_fields(), where, context)) return false;
  const Where& at = table.entries.front().value.where;
  if (spec.ball) return read_ball(*spec.ball, false, at, region, context);
  if (spec.sphere) return read_ball(*spec.sphere, true, at, region, context);
  if (spec.point) {
    region.shape = SpaceSpotRegion{*spec.point};
  } else if (spec.segment) {
    const auto [x0, y0, z0, x1, y1, z1] = *spec.segment;
    region.shape = SpaceSegmentRegion{{x0, y0, z0}, {x1, y1, z1}};
  } else if (spec.box) {
    const auto [x0, y0, z0, x1, y1, z1] = *spec.box;
    region.shape = BoxRegion{{x0, y0, z0}, {x1, y1, z1}};
  } else if (spec.polygon) {
    std::optional<PlanarRegion> planar = planar_of(*spec.polygon, at, context);
    if (!planar) return false;
    region.shape = *std::move(planar);
  } else {
    SpaceTrackRegion track{spec.along->lifted(), {}};
    track.lengths = lengths_along(track.polylines, at, context);
    if (track.lengths.empty()) return false;
    region.shape = std::move(track);
  }
  return true;
}

/// Holds a region to `farthest`, so that no place is out of range.
bool check_reach(const SpaceRegion& region, const Where& where, params::ReadContext& context) {
  const SpaceBox box = box_of(region);
  for (const Vec3 corner : {box.low, box.high}) {
    for (const double coordinate : {corner.x, corner.y, corner.z}) {
      if (std::abs(coordinate) <= farthest) continue;
      context.report(where, "the region reaches beyond 1e12");
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<params::FieldInfo> space_region_fields() {
  return params::field_infos<SpaceRegionSpec>();
}

}  // namespace burin::curves::line_art

namespace burin::params {

using curves::line_art::SpaceRegion;

bool ValueType<SpaceRegion>::read(const Value& value, SpaceRegion& region, ReadContext& context) {
  const Value* written = &value;
  if (const std::string* word = value.text()) written = context.defined(*word);
  if (written != nullptr && written->array() != nullptr) {
    curves::line_art::SpaceSpotRegion spot{};
    if (!ValueType<Vec3>::read(*written, spot.at, context)) return false;
    region.shape = spot;
  } else if (written != nullptr && written->table() != nullptr) {
    if (!curves::line_art::read_spec(*written->table(), written->where, region, context)) return false;
  } else {
    return report_kind(value,
                       "a region in space: [x, y, z], a table such as { ball = [0, 0, 0, 1] }, or the name of a define",
                       context);
  }
  return curves::line_art::check_reach(region, written->where, context);
}

std::string ValueType<SpaceRegion>::text(const SpaceRegion& region) {
  const auto* spot = std::get_if<curves::line_art::SpaceSpotRegion>(&region.shape);
  return spot == nullptr ? std::string() : ValueType<Vec3>::text(spot->at);
}

}  // namespace burin::params
