#include <algorithm>
#include <cmath>
#include <memory>

#include <burin/curves/fractal_interpolation/curve.hpp>
#include <burin/curves/fractal_interpolation/enclosures.hpp>
#include <burin/curves/fractal_interpolation/fractal_interpolation.hpp>
#include <burin/curves/fractal_interpolation/limit.hpp>
#include <burin/curves/fractal_interpolation/trace.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/point_buffer.hpp>

namespace burin::curves {

namespace fractal_interpolation {

namespace {

static_assert(params::ParamStruct<FractalInterpolationParams>);

/// Data is read and fitted once; what travels as parameters is the curve made from it.
using Prepared = std::shared_ptr<const Curve>;

const Curve& curve_of(const std::any& parameters) {
  return **std::any_cast<Prepared>(&parameters);
}

std::optional<std::any> read(const params::Table& table, params::ReadContext& context,
                             const std::vector<std::string_view>& also_known) {
  FractalInterpolationParams params;
  if (!params::read_fields(table, params, "curve", context, also_known)) return std::nullopt;
  std::optional<Curve> curve = make_curve(params, table, context);
  if (!curve) return std::nullopt;
  return std::any(std::make_shared<const Curve>(*std::move(curve)));
}

bool repeats_first(const Curve& curve) {
  return !curve.closed || curve.part.has_value();
}

/// Every point of the level sets; infinite when it passes the range of numbers.
double points_asked(const Curve& curve) {
  double points = repeats_first(curve) ? 1.0 : 0.0;
  for (const Block& block : curve.blocks) {
    const auto pieces = static_cast<double>(block.functions.front().pieces.size());
    double of_block = pieces;
    for (int level = 0; level < curve.levels && curve.plot != Plot::nodes; ++level) of_block *= pieces;
    points += of_block;
  }
  return points;
}

/// Whether a view may cut the curve. It is not worth its while for few points, and what bounds the curve says nothing
/// about its error.
bool is_limited(const Curve& curve, const View& view) {
  constexpr double few = 4096.0;
  return view.is_limited() && curve.plot != Plot::error && points_asked(curve) > few;
}

template <class Emit>
Flow each_node(const Curve& curve, const DrawContext& context, Emit emit) {
  Curve nodes = curve;
  nodes.levels = 0;
  return trace(nodes, context, false, emit);
}

template <class Emit>
Flow each_point(const Curve& curve, const DrawContext& context, Emit emit) {
  if (curve.plot == Plot::nodes) return each_node(curve, context, emit);
  return trace(curve, context, is_limited(curve, context.view), emit);
}

Flow draw(const std::any& parameters, const DrawContext& context, PathSink& sink) {
  const Curve& curve = curve_of(parameters);
  PathHead head{.closed = !repeats_first(curve), .level = static_cast<std::uint16_t>(curve.levels)};
  if (curve.plot == Plot::nodes) {
    head.closed = false;
    return each_node(curve, context, [&](Vec2 node) {
      if (sink.begin(head) == Flow::stop || sink.points({&node, 1}) == Flow::stop) return Flow::stop;
      return sink.end();
    });
  }
  PointBuffer buffer(sink);
  bool begun = false;
  const Flow flow = each_point(curve, context, [&](Vec2 p) {
    // A part may hold no point at all.
    if (!std::exchange(begun, true) && sink.begin(head) == Flow::stop) return Flow::stop;
    return buffer.add(p);
  });
  if (flow == Flow::stop || !begun) return flow;
  return buffer.finish(false) == Flow::stop ? Flow::stop : sink.end();
}

Forecast forecast(const std::any& parameters, const DrawContext& context, double enough) {
  const Curve& curve = curve_of(parameters);
  const double asked = points_asked(curve);
  if (!curve.part && !is_limited(curve, context.view)) return {asked, asked, true};
  double count = 0.0;
  const Flow flow = each_point(curve, context, [&](Vec2) {
    count += 1.0;
    return count > enough ? Flow::stop : Flow::go;
  });
  return {count, asked, flow == Flow::go};
}

/// The box of all cells that the enclosures know, where there are too many points to look at each.
Box2 enclosing_box(const Curve& curve, const Affine2& frame) {
  Box2 box;
  const Interval span = parameter_span(curve);
  for (const Block& block : curve.blocks) {
    std::vector<Enclosures> enclosures;
    for (const Interpolant& f : block.functions) enclosures.push_back(make_enclosures(f));
    const Interpolant& f = block.functions.front();
    const std::vector<double> ends = cell_ends(f, enclosures.front().depth());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Interval x{f.begin + f.length * ends[k], f.begin + f.length * ends[k + 1]};
      if (curve.part &&
          (x.high < span.low + curve.part->low * span.width() || x.low > span.low + curve.part->high * span.width())) {
        continue;
      }
      const Interval first = enclosures.front().by_depth.back()[k];
      if (curve.planar) {
        const Interval second = enclosures.back().by_depth.back()[k];
        box.add(image_box(frame, {{first.low, second.low}, {first.high, second.high}}));
      } else {
        box.add(image_box(frame, {{x.low, curve.stretch * first.low}, {x.high, curve.stretch * first.high}}));
      }
    }
  }
  return box;
}

/// Exact to rounding up to a quarter of a million points; beyond, safe and, for rough curves, a few hundredths too
/// large.
std::optional<Box2> bounds(const std::any& parameters, const DrawContext& context, const Affine2& frame) {
  constexpr double most_points_replayed = 1 << 18;
  const Curve& curve = curve_of(parameters);
  if (points_asked(curve) > most_points_replayed) {
    if (curve.plot == Plot::error) return std::nullopt;
    return enclosing_box(curve, frame);
  }
  BoundsSink sink;
  Mapped mapped(sink, frame);
  DrawContext every_point = context;
  every_point.view = {};
  every_point.origin = {};
  if (draw(parameters, every_point, mapped) == Flow::stop || !sink.finite()) return std::nullopt;
  return sink.box();
}

/// A level set holds the one before, and each of its n intervals is divided by n; blocks of another length or the cut
/// of a part shift the count.
std::uint64_t retained_every(const std::any& parameters) {
  const Curve& curve = curve_of(parameters);
  if (curve.levels == 0 || curve.part || curve.plot == Plot::nodes) return 0;
  const std::size_t pieces = curve.blocks.front().functions.front().pieces.size();
  const bool alike = std::all_of(curve.blocks.begin(), curve.blocks.end(),
                                 [&](const Block& block) { return block.functions.front().pieces.size() == pieces; });
  return alike ? pieces : 0;
}

}  // namespace

}  // namespace fractal_interpolation

Family fractal_interpolation_family() {
  return {.name = "fractal-interpolation",
          .summary =
              "rational fractal interpolation with scaling functions, of data over x or of a plane contour; with "
              "the polynomial one and the cubic spline to compare, and fits",
          .source =
              "Song, Yang, Jiang, Bao, Zhang, Rational Fractal Interpolation Based on Function Scaling Factors, "
              "2021, eq. (6)",
          .fields = &params::field_infos<FractalInterpolationParams>,
          .read = &fractal_interpolation::read,
          .bounds = &fractal_interpolation::bounds,
          .forecast = &fractal_interpolation::forecast,
          .draw = &fractal_interpolation::draw,
          .uses_seed = [](const std::any&) { return false; },
          .theory = [](const std::any& parameters) { return theory_text(fractal_interpolation::curve_of(parameters)); },
          .limit_facts =
              [](const std::any& parameters) {
                return fractal_interpolation::limit_facts(fractal_interpolation::curve_of(parameters));
              },
          .retained_every = &fractal_interpolation::retained_every,
          .cost_knob = "levels"};
}

}  // namespace burin::curves
