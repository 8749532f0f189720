#pragma once

#include <string>
#include <variant>
#include <vector>

#include <burin/curves/line_art/region.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/geom/vec3.hpp>

namespace burin::curves::line_art {

struct SpaceSpotRegion {
  Vec3 at;
};

struct SpaceSegmentRegion {
  Vec3 from;
  Vec3 to;
};

struct BoxRegion {
  Vec3 low;
  Vec3 high;  ///< may lie below `low`: places run from low to high
};

/// What lies about a centre: all of it, or its surface.
struct BallRegion {
  Vec3 centre;
  double radius = 1.0;
  bool is_hollow = false;
};

/// An area in a plane of space: the point (x, y) of it lies at origin + x right + y up.
struct PlanarRegion {
  AreaRegion area;
  Vec3 origin;
  Across axes;
};

/// Polylines in space by arc length, one after another.
struct SpaceTrackRegion {
  std::vector<SpacePolyline> polylines;
  std::vector<double> lengths;  ///< from the beginning to the end of each edge
};

/// Where lines of line art in space begin or end; model units.
struct SpaceRegion {
  std::variant<SpaceSpotRegion, SpaceSegmentRegion, BoxRegion, BallRegion, PlanarRegion, SpaceTrackRegion> shape;

  bool is_spot() const { return std::holds_alternative<SpaceSpotRegion>(shape); }
};

/// All places of regions lie in this box.
struct SpaceBox {
  Vec3 low;
  Vec3 high;

  void add(const SpaceBox& other);
  Vec3 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return length(high - low); }
};
SpaceBox box_of(const SpaceRegion& region);

/// The place: uniform in volume, on the sphere, in the polygon's area, by length. Source: reference curves G.3.
Vec3 place_in(const SpaceRegion& region, const PlaceKey& key);

/// The keys of a region in space written as a table, for help and docs.
std::vector<params::FieldInfo> space_region_fields();

using SpaceRegions = OneOrSeveral<SpaceRegion>;

}  // namespace burin::curves::line_art

/// [x, y, z]: a point; a table with one of point, segment, box, ball, sphere, polygon, along; or the name of such a
/// table in [define].
template <>
struct burin::params::ValueType<burin::curves::line_art::SpaceRegion> {
  static std::string name() { return "region in space"; }
  static bool read(const Value& value, burin::curves::line_art::SpaceRegion& region, ReadContext& context);
  static std::string text(const burin::curves::line_art::SpaceRegion& region);
};
