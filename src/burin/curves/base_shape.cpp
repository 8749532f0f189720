#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/curves/base_shape.hpp>
#include <burin/curves/curve_source.hpp>
#include <burin/data/csv.hpp>
#include <burin/data/svg_path.hpp>

namespace burin::curves {

std::size_t BaseShape::edge_count() const {
  std::size_t edges = 0;
  for (const Polyline& polyline : polylines) edges += polyline.edge_count();
  return edges;
}

namespace {

enum class Shape : std::uint8_t { segment, triangle, square, ngon, star };

constexpr auto words(Shape) {
  return std::array<params::Word<Shape>, 5>{{{"segment", Shape::segment},
                                             {"triangle", Shape::triangle},
                                             {"square", Shape::square},
                                             {"ngon", Shape::ngon},
                                             {"star", Shape::star}}};
}

/// The keys of a base written as a table.
struct BaseSpec {
  std::optional<Shape> shape;
  int n = 5;
  double inner = 0.382;
  std::vector<Vec2> points;
  std::string csv;
  std::string path;
  std::optional<CurveSource> curve;
  std::optional<bool> closed;
  double tolerance = 0.001;

  static constexpr auto fields() {
    return std::tuple{
        params::field("shape", &BaseSpec::shape, "segment, triangle, square, ngon or star"),
        params::field("n", &BaseSpec::n, {2, 10000}, "corners of an ngon, points of a star"),
        params::field("inner", &BaseSpec::inner, params::positive, "inner radius of a star; the outer is 1"),
        params::field("points", &BaseSpec::points, "[[x, y], ...]"),
        params::field("csv", &BaseSpec::csv, "file of points, one a line"),
        params::field("path", &BaseSpec::path, "SVG path data, y down as in SVG"),
        params::field("curve", &BaseSpec::curve,
                      "the points of another curve: { family = \"two-point\", levels = 3 }, with a `seed` of its own"),
        params::field("closed", &BaseSpec::closed, "whether the last point joins the first; unset: as the source says"),
        params::field("tolerance", &BaseSpec::tolerance, params::positive,
                      "largest distance between a curve of `path` and its chords")};
  }
};
static_assert(params::ParamStruct<BaseSpec>);

constexpr double half_sqrt3 = 0.86602540378443864676;

/// Corners at the given radii in turn, the first one up, counter-clockwise about the origin.
Polyline ring(int corners, double even_radius, double odd_radius) {
  Polyline polyline{{}, true};
  for (int i = 0; i < corners; ++i) {
    const double degrees = 90.0 + 360.0 * i / corners;
    const double radius = i % 2 == 0 ? even_radius : odd_radius;
    polyline.points.push_back({radius * math::cos_degrees(degrees), radius * math::sin_degrees(degrees)});
  }
  return polyline;
}

Polyline named_shape(Shape shape, int n, double inner) {
  switch (shape) {
    case Shape::segment:
      return {{{0.0, 0.0}, {1.0, 0.0}}, false};
    case Shape::triangle:
      return {{{0.0, 0.0}, {1.0, 0.0}, {0.5, half_sqrt3}}, true};
    case Shape::square:
      return {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, true};
    case Shape::ngon:
      return ring(n, 1.0, 1.0);
    case Shape::star:
      return ring(2 * n, 1.0, inner);
  }
  return {};
}

/// The polylines a table describes, before `closed` is applied; nothing after reporting.
std::optional<std::vector<Polyline>> polylines_of(const BaseSpec& spec, const Where& where,
                                                  params::ReadContext& context) {
  const auto fail = [&](const Problems& problems) {
    context.problems.insert(context.problems.end(), problems.begin(), problems.end());
    return std::nullopt;
  };
  const int sources = int{spec.shape.has_value()} + int{!spec.points.empty()} + int{!spec.csv.empty()} +
                      int{!spec.path.empty()} + int{spec.curve.has_value()};
  if (sources != 1) {
    context.report(where, "a base needs exactly one of 'shape', 'points', 'csv', 'path' and 'curve'");
    return std::nullopt;
  }
  if (spec.curve) return spec.curve->polylines;
  if (spec.shape) return std::vector{named_shape(*spec.shape, spec.n, spec.inner)};
  if (!spec.points.empty()) return std::vector{Polyline{spec.points, false}};
  if (!spec.csv.empty()) {
    const Result<std::string> text = context.read_file(spec.csv);
    if (!text) {
      const Problem& problem = text.problems().front();
      context.report(where, problem.where.file.empty() ? problem.message
                                                       : fmt::format("'{}' {}", problem.where.file, problem.message));
      return std::nullopt;
    }
    Result<std::vector<Vec2>> points = data::read_csv_points(*text, spec.csv);
    if (!points) return fail(points.problems());
    return std::vector{Polyline{*std::move(points), false}};
  }
  const Result<std::vector<data::Subpath>> subpaths = data::parse_svg_path(spec.path, spec.tolerance, where);
  if (!subpaths) return fail(subpaths.problems());
  std::vector<Polyline> polylines;
  for (const data::Subpath& subpath : *subpaths) {
    Polyline polyline{{}, subpath.closed};
    for (const Vec2 p : subpath.points) polyline.points.push_back({p.x, -p.y});
    polylines.push_back(std::move(polyline));
  }
  return polylines;
}

bool read_spec(const params::Table& table, const Where& where, BaseShape& base, params::ReadContext& context) {
  BaseSpec spec;
  if (!params::read_fields(table, spec, "base", context)) return false;
  std::optional<std::vector<Polyline>> polylines = polylines_of(spec, where, context);
  if (!polylines) return false;
  for (Polyline& polyline : *polylines) {
    if (spec.closed) polyline.closed = *spec.closed;
    drop_repeated_end(polyline);
    if (polyline.points.size() < 2) {
      context.report(where, fmt::format("a base needs at least 2 points, found {}", polyline.points.size()));
      return false;
    }
  }
  if (polylines->empty()) {
    context.report(where, "the base is empty: its path draws no line");
    return false;
  }
  base = {*std::move(polylines), "table"};
  return true;
}

}  // namespace

BaseShape square_base() {
  return {{named_shape(Shape::square, 0, 0.0)}, "\"square\""};
}

std::vector<params::FieldInfo> base_fields() {
  return params::field_infos<BaseSpec>();
}

}  // namespace burin::curves

namespace burin::params {

using curves::BaseShape;

bool ValueType<BaseShape>::read(const Value& value, BaseShape& base, ReadContext& context) {
  if (const Table* table = value.table()) return curves::read_spec(*table, value.where, base, context);
  const std::string* word = value.text();
  if (word == nullptr) return report_kind(value, "a base: \"triangle\" or a table", context);
  if (const Value* defined = context.defined(*word); defined != nullptr && defined->table() != nullptr) {
    return curves::read_spec(*defined->table(), defined->where, base, context);
  }
  curves::Shape shape{};
  if (!ValueType<curves::Shape>::read(value, shape, context)) return false;
  const curves::BaseSpec defaults;
  base = {{curves::named_shape(shape, defaults.n, defaults.inner)}, '"' + *word + '"'};
  return true;
}

}  // namespace burin::params
