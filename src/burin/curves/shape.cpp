#include <algorithm>
#include <utility>
#include <vector>

#include <burin/base/math.hpp>
#include <burin/curves/shape.hpp>
#include <burin/data/svg_path.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_path.hpp>

namespace burin::curves {

namespace {

/// Chords of a full circle: they miss it by a hundred thousandth of its radius.
constexpr int circle_chords = 720;

using Contour = std::vector<Vec2>;

/// Points of a circle about `center`, from the angle `first` on by `step` degrees.
void add_arc(Contour& contour, Vec2 center, double radius, double first, double step, int count) {
  for (int i = 0; i < count; ++i) {
    const double degrees = first + step * i;
    contour.push_back(center + radius * Vec2{math::cos_degrees(degrees), math::sin_degrees(degrees)});
  }
}

Contour circle(double radius) {
  Contour contour;
  add_arc(contour, {}, radius, 0.0, 360.0 / circle_chords, circle_chords);
  return contour;
}

/// Corners at two radii in turn, the first one up.
Contour corners(int count, double even_radius, double odd_radius) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    add_arc(contour, {}, i % 2 == 0 ? even_radius : odd_radius, 90.0 + 360.0 * i / count, 0.0, 1);
  }
  return contour;
}

Contour rectangle(double width, double height, double corner) {
  const Vec2 half{0.5 * width, 0.5 * height};
  if (!(corner > 0.0)) return {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  const double radius = std::min({corner, half.x, half.y});
  const Vec2 inset{half.x - radius, half.y - radius};
  constexpr int chords = circle_chords / 4;
  constexpr double step = 360.0 / circle_chords;
  Contour contour;
  add_arc(contour, {inset.x, -inset.y}, radius, -90.0, step, chords + 1);
  add_arc(contour, {inset.x, inset.y}, radius, 0.0, step, chords + 1);
  add_arc(contour, {-inset.x, inset.y}, radius, 90.0, step, chords + 1);
  add_arc(contour, {-inset.x, -inset.y}, radius, 180.0, step, chords + 1);
  contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
  if (contour.front() == contour.back()) contour.pop_back();
  return contour;
}

/// A path of the shape: its contours, all closed or none.
struct ShapePath {
  bool closed = true;
  std::vector<Contour> contours;
};

/// How far chords miss the curves of path data: a share of the larger side of what its points span.
Result<std::vector<data::Subpath>> subpaths_of(const std::string& d, const Where& where) {
  Result<std::vector<data::Subpath>> coarse = data::parse_svg_path(d, 1.0, where);
  if (!coarse) return coarse;
  Box2 box;
  for (const data::Subpath& subpath : *coarse) {
    for (const Vec2 p : subpath.points) box.add(p);
  }
  if (box.empty()) return coarse;
  return data::parse_svg_path(d, std::max(box.width(), box.height()) / circle_chords / 100.0, where);
}

/// The closed subpaths as one path, so that a hole is one; the open ones each alone.
std::vector<ShapePath> data_paths(const std::string& d) {
  const Result<std::vector<data::Subpath>> subpaths = subpaths_of(d, {});
  if (!subpaths) return {};
  std::vector<ShapePath> paths;
  ShapePath closed;
  for (const data::Subpath& subpath : *subpaths) {
    Contour contour;
    for (const Vec2 p : subpath.points) contour.push_back({p.x, -p.y});
    if (subpath.closed && contour.size() > 1) {
      closed.contours.push_back(std::move(contour));
    } else {
      paths.push_back({false, {std::move(contour)}});
    }
  }
  if (!closed.contours.empty()) paths.push_back(std::move(closed));
  return paths;
}

std::vector<ShapePath> paths_of(const ShapeParams& params) {
  const double inner = params.inner * params.r;
  switch (params.kind) {
    case ShapeKind::rectangle:
      return {{true, {rectangle(params.width, params.height, params.corner)}}};
    case ShapeKind::disc:
      return {{true, {circle(params.r)}}};
    case ShapeKind::ring: {
      Contour hole = circle(inner);
      std::reverse(hole.begin(), hole.end());  // a hole by either rule
      return {{true, {circle(params.r), std::move(hole)}}};
    }
    case ShapeKind::polygon:
      return {{true, {corners(params.n, params.r, params.r)}}};
    case ShapeKind::star:
      return {{true, {corners(2 * params.n, params.r, inner)}}};
    case ShapeKind::path:
      return data_paths(params.d);
  }
  return {};
}

Flow draw_shape(const ShapeParams& params, const Affine2& sink_from_model, PathSink& sink) {
  Mapped mapped(sink, sink_from_model * rotation_degrees(params.turn));
  for (const ShapePath& path : paths_of(params)) {
    if (draw_path(mapped, {.closed = path.closed}, path.contours) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

struct ShapeFamily {
  using Params = ShapeParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    const params::Value* d = table.find("d");
    if (params.kind != ShapeKind::path) {
      if (d != nullptr) context.report(d->where, "'d' is for kind = \"path\"");
      return d == nullptr;
    }
    if (d == nullptr) {
      context.report(table.find("kind")->where, "a path needs 'd': SVG path data");
      return false;
    }
    const Result<std::vector<data::Subpath>> subpaths = subpaths_of(params.d, d->where);
    if (!subpaths) {
      context.problems.insert(context.problems.end(), subpaths.problems().begin(), subpaths.problems().end());
    } else if (subpaths->empty()) {
      context.report(d->where, "the path draws no line");
    }
    return subpaths.ok() && !subpaths->empty();
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext&, const Affine2& frame) {
    BoundsSink bounds;
    static_cast<void>(draw_shape(params, frame, bounds));
    return bounds.box();
  }

  static Forecast forecast(const Params& params, const DrawContext&, double) {
    double points = 0.0;
    for (const ShapePath& path : paths_of(params)) {
      for (const Contour& contour : path.contours) points += static_cast<double>(contour.size());
    }
    return {points, points, true};
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_shape(params, translation(-context.origin), sink);
  }

  static bool uses_seed(const Params&) { return false; }
};

}  // namespace

Family shape_family() {
  return make_family<ShapeFamily>("shape", "a rectangle, disc, ring, polygon, star, or path data",
                                  "elementary geometry; path data as in Scalable Vector Graphics 1.1", "n");
}

}  // namespace burin::curves
