#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/line_art/region_keys.hpp>
#include <burin/geom/box2.hpp>

namespace burin::curves::line_art {

struct SpotRegion {
  Vec2 at;
};

struct SegmentRegion {
  Vec2 from;
  Vec2 to;
};

struct RectangleRegion {
  Vec2 low;
  Vec2 high;  ///< may lie below `low`: places run from low to high
};

/// A disc when inner is 0.
struct RingRegion {
  Vec2 centre;
  double inner = 0.0;
  double outer = 1.0;
};

/// What closed polylines enclose by the even-odd rule.
struct AreaRegion {
  std::vector<Polyline> outlines;
  Box2 box;
};

/// Polylines by arc length, one after another.
struct TrackRegion {
  std::vector<Polyline> polylines;
  std::vector<double> lengths;  ///< from the beginning to the end of each edge
};

struct PointsRegion {
  std::vector<Vec2> points;
};

/// Where lines of line art begin or end; model units.
struct Region {
  std::variant<SpotRegion, SegmentRegion, RectangleRegion, RingRegion, AreaRegion, TrackRegion, PointsRegion> shape;

  /// Holds every place of it.
  Box2 box() const;
  /// Whether it has an inside: rectangle, ring and area.
  bool is_area() const;
  /// Whether it holds the point, borders included up to rounding. Pre: is_area().
  bool contains(Vec2 p) const;
  /// Where the segment from a to b meets the border, as parts of it in (0, 1], added to `crossings` in no order. Pre:
  /// is_area().
  void add_crossings(Vec2 a, Vec2 b, std::vector<double>& crossings) const;
};

/// Regions reach no farther from the origin than this, in either coordinate.
inline constexpr double farthest = 1e12;

/// How the places in a region follow each other.
enum class Places : std::uint8_t {
  random,
  even,  ///< a sequence that leaves no gaps: multiples of the golden or the plastic ratio
  steps  ///< at equal steps from one end to the other; in discs by the golden angle
};

constexpr auto words(Places) {
  return std::array<params::Word<Places>, 3>{
      {{"random", Places::random}, {"even", Places::even}, {"steps", Places::steps}}};
}

/// Which place of a region is meant: a function of these alone.
struct PlaceKey {
  std::uint64_t seed = 0;
  std::uint64_t x_draw = 0;  ///< what the draws are for
  std::uint64_t y_draw = 0;
  std::uint64_t z_draw = 0;     ///< in space only
  std::uint64_t index = 0;      ///< of the place
  std::uint64_t count = 1;      ///< how many places there are, for steps
  std::uint64_t candidate = 0;  ///< another draw for the same index
  Places places = Places::random;
  bool turned_round = false;  ///< counts from the other end
};

/// Two numbers in [0, 1) that say which place of a region is meant. `attempt`: the next ones, when a place fell
/// outside.
Vec2 chances(const PlaceKey& key, bool has_area, std::uint64_t attempt);

/// The place: uniform in the region's area, in its length, or over its points. Random places are the reference's
/// (curves G.2), with X and Y the two draws.
Vec2 place_in(const Region& region, const PlaceKey& key);

/// The inside of a base; nothing after reporting that it is too thin for places in it to be found.
std::optional<AreaRegion> area_of(const BaseShape& base, const Where& where, params::ReadContext& context);

/// The keys of a region written as a table, for help and docs.
std::vector<params::FieldInfo> region_fields();

using Regions = OneOrSeveral<Region>;

}  // namespace burin::curves::line_art

/// [x, y]: a point; [x0, y0, x1, y1]: a rectangle; a table with one of point, segment, rectangle, disc, ring, polygon,
/// along, points; or the name of such a table in [define].
template <>
struct burin::params::ValueType<burin::curves::line_art::Region> {
  static std::string name() { return "region"; }
  static bool read(const Value& value, burin::curves::line_art::Region& region, ReadContext& context);
  static std::string text(const burin::curves::line_art::Region& region);
};
