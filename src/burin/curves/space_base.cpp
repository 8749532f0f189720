#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/curves/space_base.hpp>

namespace burin::curves {

std::vector<SpacePolyline> SpaceBase::lifted() const {
  if (is_in_space()) return space;
  std::vector<SpacePolyline> lifted;
  for (const Polyline& polyline : plane.polylines) {
    lifted.push_back({{}, polyline.closed});
    for (const Vec2 p : polyline.points) lifted.back().points.push_back({p.x, p.y, 0.0});
  }
  return lifted;
}

namespace {

enum class Solid : std::uint8_t { tetrahedron, cube, octahedron, dodecahedron, icosahedron };

constexpr auto words(Solid) {
  return std::array<params::Word<Solid>, 5>{{{"tetrahedron", Solid::tetrahedron},
                                             {"cube", Solid::cube},
                                             {"octahedron", Solid::octahedron},
                                             {"dodecahedron", Solid::dodecahedron},
                                             {"icosahedron", Solid::icosahedron}}};
}

/// The keys of a base in space written as a table.
struct SpaceSpec {
  std::vector<Vec3> points;
  std::optional<Solid> solid;
  std::vector<int> knot;
  int n = 24;
  double tube = 0.45;
  bool closed = false;

  static constexpr auto fields() {
    using params::field;
    return std::tuple{
        field("points", &SpaceSpec::points, "[[x, y, z], ...]"),
        field("solid", &SpaceSpec::solid, "a regular solid of circumradius 1, each of its faces a polygon"),
        field("knot", &SpaceSpec::knot,
              "[p, q]: p times around the z axis and q times around a circle of radius 1 about it"),
        field("n", &SpaceSpec::n, {3, 100000}, "corners of a knot"),
        field("tube", &SpaceSpec::tube, params::not_negative, "a knot's distance from that circle"),
        field("closed", &SpaceSpec::closed, "of points: whether the last joins the first")};
  }
};
static_assert(params::ParamStruct<SpaceSpec>);

constexpr double golden = 1.6180339887498948482;
using Directions = std::vector<Vec3>;

/// (a, b, c) and what comes of it by turning the axes round and by changing signs.
void add_cycled(Directions& all, double a, double b, double c) {
  for (const Vec3 p : {Vec3{a, b, c}, Vec3{c, a, b}, Vec3{b, c, a}}) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      const Vec3 q{(signs & 1U) != 0 ? -p.x : p.x, (signs & 2U) != 0 ? -p.y : p.y, (signs & 4U) != 0 ? -p.z : p.z};
      if (std::find(all.begin(), all.end(), q) == all.end()) all.push_back(q);
    }
  }
}

Directions corners_of(Solid solid) {
  Directions corners;
  switch (solid) {
    case Solid::tetrahedron:
      corners = {{1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}};
      break;
    case Solid::cube:
      add_cycled(corners, 1.0, 1.0, 1.0);
      break;
    case Solid::octahedron:
      add_cycled(corners, 1.0, 0.0, 0.0);
      break;
    case Solid::dodecahedron:
      add_cycled(corners, 1.0, 1.0, 1.0);
      add_cycled(corners, 0.0, 1.0 / golden, golden);
      break;
    case Solid::icosahedron:
      add_cycled(corners, 1.0, 0.0, golden);
      break;
  }
  for (Vec3& corner : corners) corner = unit(corner);
  return corners;
}

/// Where the faces look: the corners of the dual solid.
Directions normals_of(Solid solid) {
  switch (solid) {
    case Solid::tetrahedron: {
      Directions normals = corners_of(solid);
      for (Vec3& normal : normals) normal = -normal;
      return normals;
    }
    case Solid::cube:
      return corners_of(Solid::octahedron);
    case Solid::octahedron:
      return corners_of(Solid::cube);
    case Solid::dodecahedron:
      return corners_of(Solid::icosahedron);
    case Solid::icosahedron:
      return corners_of(Solid::dodecahedron);
  }
  return {};
}

/// The corners farthest along the normal, counter-clockwise for whoever looks against it.
SpacePolyline face_of(const Directions& corners, Vec3 normal) {
  constexpr double rounding = 1e-9;
  double farthest = -1.0;
  for (const Vec3 corner : corners) farthest = std::max(farthest, dot(normal, corner));
  const Across axes = across(normal, {0.0, 0.0, 1.0});
  std::vector<std::pair<double, Vec3>> by_angle;
  for (const Vec3 corner : corners) {
    if (dot(normal, corner) < farthest - rounding) continue;
    by_angle.emplace_back(math::atan2(dot(axes.up, corner), -dot(axes.right, corner)), corner);
  }
  std::sort(by_angle.begin(), by_angle.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  SpacePolyline face{{}, true};
  for (const auto& [angle, corner] : by_angle) face.points.push_back(corner);
  return face;
}

std::vector<SpacePolyline> faces_of(Solid solid) {
  const Directions corners = corners_of(solid);
  std::vector<SpacePolyline> faces;
  for (const Vec3 normal : normals_of(solid)) faces.push_back(face_of(corners, normal));
  return faces;
}

SpacePolyline knot_of(const SpaceSpec& spec) {
  SpacePolyline knot{{}, true};
  for (int i = 0; i < spec.n; ++i) {
    const double around = 360.0 * spec.knot[0] * i / spec.n;
    const double about = 360.0 * spec.knot[1] * i / spec.n;
    const double r = 1.0 + spec.tube * math::cos_degrees(about);
    knot.points.push_back(
        {r * math::cos_degrees(around), r * math::sin_degrees(around), spec.tube * math::sin_degrees(about)});
  }
  return knot;
}

/// Whether a table describes a base in space: by a key that only those have, or by points of three coordinates.
bool says_space(const params::Table& table) {
  if (table.find("solid") != nullptr || table.find("knot") != nullptr) return true;
  const params::Value* points = table.find("points");
  const params::Array* array = points == nullptr ? nullptr : points->array();
  if (array == nullptr || array->empty() || array->front().array() == nullptr) return false;
  return array->front().array()->size() == 3;
}

bool read_spec(const params::Table& table, const Where& where, SpaceBase& base, params::ReadContext& context) {
  SpaceSpec spec;
  if (!params::read_fields(table, spec, "base in space", context)) return false;
  const int sources = int{!spec.points.empty()} + int{spec.solid.has_value()} + int{!spec.knot.empty()};
  if (sources != 1) {
    context.report(where, "a base in space needs exactly one of 'points', 'solid' and 'knot'");
    return false;
  }
  if (spec.solid) {
    base.space = faces_of(*spec.solid);
  } else if (!spec.knot.empty()) {
    if (spec.knot.size() != 2) {
      context.report(table.find("knot")->where, fmt::format("a knot is [p, q], found a list of {}", spec.knot.size()));
      return false;
    }
    base.space = {knot_of(spec)};
  } else {
    SpacePolyline polyline{spec.points, spec.closed};
    drop_repeated_end(polyline);
    if (polyline.points.size() < 2) {
      context.report(where, fmt::format("a base needs at least 2 points, found {}", polyline.points.size()));
      return false;
    }
    base.space = {std::move(polyline)};
  }
  base.text = "table";
  return true;
}

}  // namespace

SpaceBase tetrahedron_base() {
  return {.space = faces_of(Solid::tetrahedron), .text = "{ solid = \"tetrahedron\" }"};
}

std::vector<params::FieldInfo> space_base_fields() {
  return params::field_infos<SpaceSpec>();
}

}  // namespace burin::curves

namespace burin::params {

bool ValueType<curves::SpaceBase>::read(const Value& value, curves::SpaceBase& base, ReadContext& context) {
  const Value* written = &value;
  if (const std::string* word = value.text()) {
    if (const Value* defined = context.defined(*word)) written = defined;
  }
  if (const Table* table = written->table(); table != nullptr && curves::says_space(*table)) {
    return curves::read_spec(*table, written->where, base, context);
  }
  base.space.clear();
  return ValueType<curves::BaseShape>::read(value, base.plane, context);
}

}  // namespace burin::params
