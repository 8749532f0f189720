#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <burin/curves/two_point/block_tables.hpp>
#include <burin/curves/two_point/bounds.hpp>
#include <burin/curves/two_point/dimension.hpp>
#include <burin/curves/two_point/emitters.hpp>
#include <burin/curves/two_point/keyed_rule.hpp>
#include <burin/curves/two_point/trace_blocks.hpp>
#include <burin/curves/two_point/trace_joins.hpp>
#include <burin/curves/two_point/trace_rule.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/path/decorators.hpp>

namespace burin::curves {

namespace two_point {

namespace {

using Params = TwoPointParams;

/// The rule that draws these parameters: block tables where the motif is self-similar, else edge by edge.
using Engine = std::variant<BlockTables, KeyedRule>;

Engine engine_for(const Params& params, std::uint64_t seed) {
  if (std::optional<Automaton> automaton = make_automaton(params.motif, params.sign)) {
    return make_block_tables(*std::move(automaton));
  }
  return KeyedRule(params.motif, params.sign, seed);
}

/// Traces every base edge of one polyline into an emitter. `first_edge` is the ordinal of its first edge.
template <class Emitter>
Flow trace_polyline(const Polyline& polyline, std::uint64_t first_edge, int levels, const View& view,
                    const Engine& engine, Emitter& emitter) {
  const auto trace = [&](auto& tracer, auto start_of) {
    for (std::size_t e = 0; e < polyline.edge_count(); ++e) {
      if (tracer.trace(polyline.edge_begin(e), polyline.edge_end(e), start_of(first_edge + e)) == Flow::stop) {
        return Flow::stop;
      }
    }
    return Flow::go;
  };
  if (const auto* tables = std::get_if<BlockTables>(&engine)) {
    BlockTracer<Emitter> tracer(*tables, levels, view, emitter);
    return trace(tracer, [&](std::uint64_t edge) { return tables->automaton.start(edge); });
  }
  RuleTracer<KeyedRule, Emitter> tracer(std::get<KeyedRule>(engine), levels, view, emitter);
  return trace(tracer, [](std::uint64_t edge) { return edge; });
}

/// A view under which this rule may be cut: none when nothing bounds what an edge generates.
View usable_view(const View& view, const Engine& engine) {
  const auto* tables = std::get_if<BlockTables>(&engine);
  const double reach = tables != nullptr ? tables->reach : std::get<KeyedRule>(engine).detail(0, 1.0);
  return std::isfinite(reach) ? view : View{};
}

/// The base as seen from the context's origin. What is near the origin is then refined in small numbers, so that a
/// vertex is rounded to a fraction of its distance from there.
std::vector<Polyline> seen_from(Vec2 origin, const std::vector<Polyline>& base) {
  std::vector<Polyline> seen = base;
  for (Polyline& polyline : seen) {
    for (Vec2& point : polyline.points) point = point - origin;
  }
  return seen;
}

/// The points of S_m on one edge, its first not counted; infinite when it passes the range of numbers.
double points_per_edge(const Motif& motif, int levels) {
  double points = 1.0;
  for (int level = 1; level <= levels; ++level) points *= static_cast<double>(motif.stage(level).child_count());
  return points;
}

double points_asked(const Params& params) {
  double points = 0.0;
  for (const Polyline& polyline : params.base.polylines) {
    points += static_cast<double>(polyline.edge_count()) * points_per_edge(params.motif, params.levels) +
              (polyline.closed || params.motif.join ? 0.0 : 1.0);
  }
  return points;
}

/// Runs the curve for its box where the rule has no bound of its own.
constexpr double most_points_replayed = 5e7;

struct TwoPointFamily {
  using Params = TwoPointParams;

  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    if (params.sign && params.motif.sign) {
      context.report(table.find("sign")->where, "'sign' is given twice: in the curve and in its motif");
      return false;
    }
    if (!params.motif.join || make_automaton(params.motif, params.sign)) return true;
    context.report(table.find("motif")->where,
                   "'join' needs plain marks and a sign that repeats; leave out random, absolute and decaying ones");
    return false;
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext& context, const Affine2& frame) {
    if (!params.motif.join) {
      const Engine engine = engine_for(params, context.seed);
      const std::optional<Box2> box = std::visit(
          [&](const auto& rule) { return two_point::bounds(params.base, rule, params.levels, frame); }, engine);
      if (box) return box;
    }
    if (points_asked(params) > most_points_replayed) return std::nullopt;
    BoundsSink sink;
    Mapped mapped(sink, frame);
    DrawContext every_point = context;
    every_point.view = {};
    if (draw(params, every_point, mapped) == Flow::stop) return std::nullopt;
    return sink.finite() ? std::optional(sink.box()) : std::nullopt;
  }

  static Forecast forecast(const Params& params, const DrawContext& context, double enough) {
    const double asked = points_asked(params);
    if (params.motif.join) return {asked, asked, true};
    const Engine engine = engine_for(params, context.seed);
    const View view = usable_view(context.view, engine);
    if (!view.is_limited()) return {asked, asked, true};
    PointCounter counter(enough);
    std::uint64_t first_edge = 0;
    for (const Polyline& polyline : seen_from(context.origin, params.base.polylines)) {
      if (!polyline.closed && counter.point(polyline.points.front()) == Flow::stop)
        return {counter.count(), asked, false};
      if (trace_polyline(polyline, first_edge, params.levels, view, engine, counter) == Flow::stop) {
        return {counter.count(), asked, false};
      }
      first_edge += polyline.edge_count();
    }
    return {counter.count(), asked, true};
  }

  /// Every join point of the last level: no view cuts it, for a coarser edge's point lies on no finer curve.
  static Flow draw_joins(const Params& params, PathSink& sink) {
    const std::optional<Automaton> automaton = make_automaton(params.motif, params.sign);
    BURIN_EXPECT(automaton.has_value());
    std::uint64_t first_edge = 0;
    for (const Polyline& polyline : params.base.polylines) {
      const auto level = static_cast<std::uint16_t>(params.levels);
      if (sink.begin({.closed = polyline.closed, .level = level}) == Flow::stop) return Flow::stop;
      PointEmitter emitter(sink);
      JoinTracer tracer(*automaton, params.levels, emitter);
      for (std::size_t e = 0; e < polyline.edge_count(); ++e) {
        const std::uint32_t start = automaton->start(first_edge + e);
        if (tracer.trace(polyline.edge_begin(e), polyline.edge_end(e), start) == Flow::stop) return Flow::stop;
      }
      if (emitter.finish(false) == Flow::stop || sink.end() == Flow::stop) return Flow::stop;
      first_edge += polyline.edge_count();
    }
    return Flow::go;
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    if (params.motif.join) {
      Mapped moved(sink, translation(-context.origin));
      return draw_joins(params, moved);
    }
    const Engine engine = engine_for(params, context.seed);
    const View view = usable_view(context.view, engine);
    std::uint64_t first_edge = 0;
    for (const Polyline& polyline : seen_from(context.origin, params.base.polylines)) {
      const auto level = static_cast<std::uint16_t>(params.levels);
      if (sink.begin({.closed = polyline.closed, .level = level}) == Flow::stop) return Flow::stop;
      PointEmitter emitter(sink);
      if (emitter.point(polyline.points.front()) == Flow::stop) return Flow::stop;
      if (trace_polyline(polyline, first_edge, params.levels, view, engine, emitter) == Flow::stop) return Flow::stop;
      if (emitter.finish(polyline.closed) == Flow::stop || sink.end() == Flow::stop) return Flow::stop;
      first_edge += polyline.edge_count();
    }
    return Flow::go;
  }

  static bool uses_seed(const Params& params) {
    const std::optional<SignRule>& sign = params.sign ? params.sign : params.motif.sign;
    return params.motif.is_random() || (sign && sign->kind == SignRule::Kind::random);
  }

  static LimitFacts limit_facts(const Params& params) {
    return {.similarity_dimension = similarity_dimension(params.motif)};
  }

  /// A join draws points of the edges, which no other level has.
  static std::uint64_t retained_every(const Params& params) {
    return params.levels == 0 || params.motif.join ? 0 : params.motif.stage(params.levels).child_count();
  }
};

/// One step down: the sub-edge `digit` of an edge of the general rule.
void descend(const KeyedRule& rule, const TwoPointAddress& address, Vec2& p, Vec2& q) {
  std::uint64_t edge = address.base_edge;
  std::vector<Vec2> path;
  for (std::size_t level = 0; level < address.digits.size(); ++level) {
    const std::uint32_t digit = address.digits[level];
    rule.path(p, q, static_cast<int>(level) + 1, edge, path);
    BURIN_EXPECT(digit + 1 < path.size());
    p = path[digit];
    q = path[digit + 1];
    edge = edge * (path.size() - 1) + digit;
  }
}

/// The same by blocks, so that the bits are those of the drawing.
void descend(const BlockTables& tables, const TwoPointAddress& address, Vec2& p, Vec2& q) {
  std::uint32_t root_state = tables.automaton.start(address.base_edge);
  for (std::size_t level = 0; level < address.digits.size();) {
    const BlockTable& table = tables.by_state[root_state];
    std::size_t index = 0;
    std::size_t depth = 0;
    while (depth < static_cast<std::size_t>(table.depth) && level < address.digits.size()) {
      const std::size_t k = tables.automaton.child_count(table.states[depth][index]);
      BURIN_EXPECT(address.digits[level] < k);
      index = index * k + address.digits[level];
      ++depth;
      ++level;
    }
    const std::vector<Vec2>& v = table.vertices[depth];
    const Vec2 d = q - p;
    if (index + 2 < v.size()) q = p + complex_product(v[index + 1], d);
    if (index > 0) p = p + complex_product(v[index], d);
    root_state = table.states[depth][index];
  }
}

}  // namespace

}  // namespace two_point

Family two_point_family() {
  return make_family<two_point::TwoPointFamily>(
      "two-point",
      "fractal curves by recursive refinement of every edge: Koch, Minkowski, dragon, Sierpinski, your own",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, eq. (4)", "levels");
}

Vec2 vertex_at(const TwoPointParams& params, std::uint64_t seed, const TwoPointAddress& address) {
  BURIN_EXPECT(address.digits.size() == static_cast<std::size_t>(params.levels));
  std::uint64_t edge = address.base_edge;
  for (const Polyline& polyline : params.base.polylines) {
    if (edge >= polyline.edge_count()) {
      edge -= polyline.edge_count();
      continue;
    }
    Vec2 p = polyline.edge_begin(edge);
    Vec2 q = polyline.edge_end(edge);
    std::visit([&](const auto& rule) { two_point::descend(rule, address, p, q); }, two_point::engine_for(params, seed));
    return p;
  }
  contract_broken("base_edge < edge_count");
}

std::optional<Vec2> vertex_at(const TwoPointParams& params, std::uint64_t seed, std::uint64_t n) {
  // Digits from the finest level up; what is left over counts base edges.
  std::vector<std::uint32_t> digits(static_cast<std::size_t>(params.levels));
  std::uint64_t rest = n;
  for (int level = params.levels; level >= 1; --level) {
    const std::uint64_t k = params.motif.stage(level).child_count();
    digits[static_cast<std::size_t>(level - 1)] = static_cast<std::uint32_t>(rest % k);
    rest /= k;
  }
  std::uint64_t edges_before = 0;
  for (const Polyline& polyline : params.base.polylines) {
    edges_before += polyline.edge_count();
    if (rest < edges_before) return vertex_at(params, seed, {rest, digits});
  }
  const bool is_end = n != 0 && rest == edges_before && !params.base.polylines.back().closed &&
                      std::all_of(digits.begin(), digits.end(), [](std::uint32_t digit) { return digit == 0; });
  return is_end ? std::optional(params.base.polylines.back().points.back()) : std::nullopt;
}

}  // namespace burin::curves
