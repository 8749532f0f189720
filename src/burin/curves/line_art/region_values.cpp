#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/line_art/region.hpp>
#include <burin/params/number_list.hpp>

/// How regions are written in presets.
namespace burin::curves::line_art {

namespace {

/// The keys of a region written as a table.
struct RegionSpec {
  std::optional<Vec2> point;
  std::optional<std::array<double, 4>> segment;
  std::optional<std::array<double, 4>> rectangle;
  std::optional<std::array<double, 3>> disc;
  std::optional<std::array<double, 4>> ring;
  std::optional<BaseShape> polygon;
  std::optional<BaseShape> along;
  std::optional<BaseShape> points;

  static constexpr auto fields() {
    using params::field;
    return std::tuple{
        field("point", &RegionSpec::point, "[x, y]"),
        field("segment", &RegionSpec::segment, "[x0, y0, x1, y1]: its two ends"),
        field("rectangle", &RegionSpec::rectangle, "[x0, y0, x1, y1]: two opposite corners"),
        field("disc", &RegionSpec::disc, "[x, y, radius]"),
        field("ring", &RegionSpec::ring, "[x, y, inner radius, outer radius]"),
        field("polygon", &RegionSpec::polygon,
              "the inside of a base: \"triangle\", { points = ... }, { path = \"M0 0 ...\" }, { csv = ... }"),
        field("along", &RegionSpec::along, "the line of a base, by its length"),
        field("points", &RegionSpec::points, "the corners of a base, such as { csv = \"file\" }")};
  }
};

static_assert(params::ParamStruct<RegionSpec>);

/// Whether random places in the area's box hit it often enough to be found.
bool can_be_hit(const AreaRegion& area) {
  constexpr std::uint64_t tries = 8192;
  constexpr int enough = 8;
  const Region region{area};
  int hits = 0;
  for (std::uint64_t i = 0; i < tries && hits < enough; ++i) {
    const Vec2 p{area.box.low.x + area.box.width() * uniform(i, 1), area.box.low.y + area.box.height() * uniform(i, 2)};
    if (region.contains(p)) ++hits;
  }
  return hits == enough;
}

}  // namespace

std::optional<AreaRegion> area_of(const BaseShape& base, const Where& where, params::ReadContext& context) {
  AreaRegion area{base.polylines, {}};
  for (Polyline& outline : area.outlines) {
    outline.closed = true;
    for (const Vec2 p : outline.points) area.box.add(p);
  }
  if (can_be_hit(area)) return area;
  context.report(where, "the polygon fills less than a thousandth of its box; give it as 'along' or in thicker parts");
  return std::nullopt;
}

namespace {

bool read_ring(const std::array<double, 4>& ring, const Where& where, Region& region, params::ReadContext& context) {
  const auto [x, y, inner, outer] = ring;
  if (!(inner >= 0.0 && inner < outer)) {
    context.report(where, fmt::format("a ring's radii are 0 <= inner < outer, found {} and {}", shortest_text(inner),
                                      shortest_text(outer)));
    return false;
  }
  region.shape = RingRegion{{x, y}, inner, outer};
  return true;
}

bool read_spec(const params::Table& table, const Where& where, Region& region, params::ReadContext& context) {
  RegionSpec spec;
  if (!params::read_fields(table, spec, "region", context)) return false;
  if (!check_one_key(table, "a region", region_fields(), where, context)) return false;
  const Where& at = table.entries.front().value.where;
  if (spec.point) {
    region.shape = SpotRegion{*spec.point};
  } else if (spec.segment) {
    const auto [x0, y0, x1, y1] = *spec.segment;
    region.shape = SegmentRegion{{x0, y0}, {x1, y1}};
  } else if (spec.rectangle) {
    const auto [x0, y0, x1, y1] = *spec.rectangle;
    region.shape = RectangleRegion{{x0, y0}, {x1, y1}};
  } else if (spec.disc) {
    const auto [x, y, radius] = *spec.disc;
    return read_ring({x, y, 0.0, radius}, at, region, context);
  } else if (spec.ring) {
    return read_ring(*spec.ring, at, region, context);
  } else if (spec.polygon) {
    std::optional<AreaRegion> area = area_of(*spec.polygon, at, context);
    if (!area) return false;
    region.shape = *std::move(area);
  } else if (spec.along) {
    TrackRegion track{spec.along->polylines, lengths_along(spec.along->polylines, at, context)};
    if (track.lengths.empty()) return false;
    region.shape = std::move(track);
  } else {
    PointsRegion set;
    for (const Polyline& polyline : spec.points->polylines) {
      set.points.insert(set.points.end(), polyline.points.begin(), polyline.points.end());
    }
    region.shape = std::move(set);
  }
  return true;
}

/// Holds a region to `farthest`, so that no place is out of range.
bool check_reach(const Region& region, const Where& where, params::ReadContext& context) {
  const Box2 box = region.box();
  if (Box2{{-farthest, -farthest}, {farthest, farthest}}.contains(box.low) && std::abs(box.high.x) <= farthest &&
      std::abs(box.high.y) <= farthest) {
    return true;
  }
  context.report(where, "the region reaches beyond 1e12");
  return false;
}

/// [x, y] or [x0, y0, x1, y1].
bool read_numbers(const params::Value& value, const params::Array& array, Region& region,
                  params::ReadContext& context) {
  if (array.size() != 2 && array.size() != 4) {
    context.report(value.where,
                   fmt::format("a region is [x, y], [x0, y0, x1, y1] or a table, found a list of {}", array.size()));
    return false;
  }
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (!params::read_number(array[i], numbers[i], context)) return false;
  }
  const auto [x0, y0, x1, y1] = numbers;
  if (array.size() == 2) {
    region.shape = SpotRegion{{x0, y0}};
  } else {
    region.shape = RectangleRegion{{x0, y0}, {x1, y1}};
  }
  return true;
}

}  // namespace

std::vector<params::FieldInfo> region_fields() {
  return params::field_infos<RegionSpec>();
}

}  // namespace burin::curves::line_art

namespace burin::params {

using curves::line_art::Region;

bool ValueType<Region>::read(const Value& value, Region& region, ReadContext& context) {
  if (const Table* table = value.table()) {
    return curves::line_art::read_spec(*table, value.where, region, context) &&
           curves::line_art::check_reach(region, value.where, context);
  }
  if (const Array* array = value.array()) {
    return curves::line_art::read_numbers(value, *array, region, context) &&
           curves::line_art::check_reach(region, value.where, context);
  }
  const std::string* word = value.text();
  const Value* defined = word == nullptr ? nullptr : context.defined(*word);
  if (defined == nullptr || defined->text() != nullptr) {
    return report_kind(value, "a region: [x, y], a table such as { disc = [0, 0, 1] }, or the name of a define",
                       context);
  }
  return read(*defined, region, context);
}

std::string ValueType<Region>::text(const Region& region) {
  const auto* spot = std::get_if<curves::line_art::SpotRegion>(&region.shape);
  return spot == nullptr ? std::string() : ValueType<Vec2>::text(spot->at);
}

}  // namespace burin::params
