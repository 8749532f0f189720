#include <algorithm>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/line_art/region.hpp>
#include <burin/geom/direction.hpp>

namespace burin::curves::line_art {

namespace {

double fraction(double x) {
  return x - std::floor(x);
}

}  // namespace

Vec2 chances(const PlaceKey& key, bool has_area, std::uint64_t attempt) {
  constexpr double golden = 0.61803398874989485;   // 1 / g, g^2 = g + 1
  constexpr double plastic = 0.75487766624669276;  // 1 / p, p^3 = p + 1
  const auto index = static_cast<double>(key.index);
  Vec2 uv;
  if (key.places == Places::random || attempt > 0) {
    uv = key.candidate == 0 && attempt == 0
             ? Vec2{uniform(key.seed, key.x_draw, key.index), uniform(key.seed, key.y_draw, key.index)}
             : Vec2{uniform(key.seed, key.x_draw, key.index, key.candidate, attempt),
                    uniform(key.seed, key.y_draw, key.index, key.candidate, attempt)};
  } else if (key.places == Places::even) {
    const double u = uniform(key.seed, key.x_draw);
    uv = has_area
             ? Vec2{fraction(u + plastic * index), fraction(uniform(key.seed, key.y_draw) + plastic * plastic * index)}
             : Vec2{fraction(u + golden * index), 0.0};
  } else {
    uv = {(index + 0.5) / static_cast<double>(key.count), fraction(golden * index)};
  }
  return key.turned_round ? Vec2{1.0 - uv.x, uv.y} : uv;
}

namespace {

bool inside_outlines(const AreaRegion& area, Vec2 p) {
  bool inside = false;
  for (const Polyline& outline : area.outlines) {
    for (std::size_t e = 0; e < outline.edge_count(); ++e) {
      const Vec2 a = outline.edge_begin(e);
      const Vec2 b = outline.edge_end(e);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
  }
  return inside;
}

/// Where a + t d meets the circle about the origin.
void add_circle_crossings(Vec2 a, Vec2 d, double radius, std::vector<double>& crossings) {
  const double dd = length_squared(d);
  const double ad = dot(a, d);
  const double root = ad * ad - dd * (length_squared(a) - radius * radius);
  if (!(dd > 0.0) || !(root > 0.0)) return;
  for (const double t : {(-ad - std::sqrt(root)) / dd, (-ad + std::sqrt(root)) / dd}) {
    if (t > 0.0 && t <= 1.0) crossings.push_back(t);
  }
}

/// Where a + t d meets the segment from p to q.
void add_segment_crossing(Vec2 a, Vec2 d, Vec2 p, Vec2 q, std::vector<double>& crossings) {
  const Vec2 e = q - p;
  const double denominator = cross(d, e);
  if (denominator == 0.0) return;
  const double t = cross(p - a, e) / denominator;
  const double s = cross(p - a, d) / denominator;
  if (t > 0.0 && t <= 1.0 && s >= 0.0 && s <= 1.0) crossings.push_back(t);
}

struct BoxOf {
  Box2 operator()(const SpotRegion& spot) const { return {spot.at, spot.at}; }
  Box2 operator()(const SegmentRegion& segment) const { return around({segment.from, segment.to}); }
  Box2 operator()(const RectangleRegion& rectangle) const { return around({rectangle.low, rectangle.high}); }
  Box2 operator()(const RingRegion& ring) const { return Box2{ring.centre, ring.centre}.grown(ring.outer); }
  Box2 operator()(const AreaRegion& area) const { return area.box; }
  Box2 operator()(const TrackRegion& track) const {
    Box2 box;
    for (const Polyline& polyline : track.polylines) box.add(around(polyline.points));
    return box;
  }
  Box2 operator()(const PointsRegion& set) const { return around(set.points); }

 private:
  static Box2 around(const std::vector<Vec2>& points) {
    Box2 box;
    for (const Vec2 p : points) box.add(p);
    return box;
  }
};

Vec2 on_track(const TrackRegion& track, double u) {
  const double target = u * track.lengths.back();
  const auto found = std::upper_bound(track.lengths.begin(), track.lengths.end(), target);
  const auto edge =
      std::min<std::size_t>(static_cast<std::size_t>(found - track.lengths.begin()), track.lengths.size() - 1);
  const double before = edge == 0 ? 0.0 : track.lengths[edge - 1];
  const double edge_length = track.lengths[edge] - before;
  std::size_t rest = edge;
  for (const Polyline& polyline : track.polylines) {
    if (rest < polyline.edge_count()) {
      return lerp(polyline.edge_begin(rest), polyline.edge_end(rest),
                  edge_length > 0.0 ? std::min((target - before) / edge_length, 1.0) : 0.0);
    }
    rest -= polyline.edge_count();
  }
  contract_broken("an edge of the track");
}

struct PlaceIn {
  const PlaceKey& key;

  Vec2 operator()(const SpotRegion& spot) const { return spot.at; }
  Vec2 operator()(const SegmentRegion& segment) const {
    return lerp(segment.from, segment.to, chances(key, false, 0).x);
  }
  Vec2 operator()(const RectangleRegion& r) const {
    const Vec2 uv = chances(key, true, 0);
    return {r.low.x + (r.high.x - r.low.x) * uv.x, r.low.y + (r.high.y - r.low.y) * uv.y};
  }
  Vec2 operator()(const RingRegion& ring) const {
    const Vec2 uv = chances(key, true, 0);
    const double radius =
        ring.inner == 0.0
            ? ring.outer * std::sqrt(uv.x)
            : std::sqrt(ring.inner * ring.inner + uv.x * (ring.outer * ring.outer - ring.inner * ring.inner));
    const double azimuth = math::tau * uv.y;
    return ring.centre + radius * direction(azimuth);
  }
  Vec2 operator()(const AreaRegion& area) const {
    // The reader has seen to it that the area fills a thousandth of its box: all attempts miss once in e^65.
    constexpr std::uint64_t attempts = 65536;
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
      const Vec2 uv = chances(key, true, attempt);
      const Vec2 p{area.box.low.x + area.box.width() * uv.x, area.box.low.y + area.box.height() * uv.y};
      if (inside_outlines(area, p)) return p;
    }
    return area.outlines.front().points.front();
  }
  Vec2 operator()(const TrackRegion& track) const { return on_track(track, chances(key, false, 0).x); }
  Vec2 operator()(const PointsRegion& set) const {
    const auto index = static_cast<std::size_t>(chances(key, false, 0).x * static_cast<double>(set.points.size()));
    return set.points[std::min(index, set.points.size() - 1)];
  }
};

}  // namespace

bool Region::is_area() const {
  return std::holds_alternative<RectangleRegion>(shape) || std::holds_alternative<RingRegion>(shape) ||
         std::holds_alternative<AreaRegion>(shape);
}

Box2 Region::box() const {
  return std::visit(BoxOf{}, shape);
}

bool Region::contains(Vec2 p) const {
  if (std::holds_alternative<RectangleRegion>(shape)) return box().contains(p);
  if (const auto* ring = std::get_if<RingRegion>(&shape)) {
    const double r = distance(ring->centre, p);
    return r >= ring->inner && r <= ring->outer;
  }
  const auto* area = std::get_if<AreaRegion>(&shape);
  BURIN_EXPECT(area != nullptr);
  return area->box.contains(p) && inside_outlines(*area, p);
}

void Region::add_crossings(Vec2 a, Vec2 b, std::vector<double>& crossings) const {
  const Vec2 d = b - a;
  if (const auto* rectangle = std::get_if<RectangleRegion>(&shape)) {
    const Vec2 low = rectangle->low;
    const Vec2 high = rectangle->high;
    const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
    for (std::size_t c = 0; c < 4; ++c) add_segment_crossing(a, d, corners[c], corners[(c + 1) % 4], crossings);
    return;
  }
  if (const auto* ring = std::get_if<RingRegion>(&shape)) {
    add_circle_crossings(a - ring->centre, d, ring->outer, crossings);
    if (ring->inner > 0.0) add_circle_crossings(a - ring->centre, d, ring->inner, crossings);
    return;
  }
  const auto* area = std::get_if<AreaRegion>(&shape);
  BURIN_EXPECT(area != nullptr);
  Box2 reached;
  reached.add(a);
  reached.add(b);
  if (!reached.touches(area->box)) return;
  for (const Polyline& outline : area->outlines) {
    for (std::size_t e = 0; e < outline.edge_count(); ++e) {
      add_segment_crossing(a, d, outline.edge_begin(e), outline.edge_end(e), crossings);
    }
  }
}

Vec2 place_in(const Region& region, const PlaceKey& key) {
  return std::visit(PlaceIn{key}, region.shape);
}

}  // namespace burin::curves::line_art
