#include <algorithm>
#include <array>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/curves/two_point/automaton.hpp>
#include <burin/curves/two_point/keyed_rule.hpp>
#include <burin/curves/two_point/motif_figure.hpp>

namespace burin::curves::two_point {

namespace {

/// Layers of a motif_sheet, and its pens.
constexpr LayerId unit_layer = 0;
constexpr LayerId unit_arrow_layer = 1;
constexpr LayerId join_layer = 2;
constexpr LayerId motif_layer = 3;
constexpr LayerId vertex_layer = 4;
constexpr LayerId arrow_layer = 5;

constexpr std::array<Vec2, 2> unit_edge{{{0.0, 0.0}, {1.0, 0.0}}};

/// A figure with its place on the page.
struct PlacedFigure {
  const MotifFigure* figure = nullptr;
  Affine2 page_from_unit;
};

Box2 box_of(const MotifFigure& figure) {
  Box2 box;
  for (const Vec2 p : unit_edge) box.add(p);
  for (const Vec2 p : figure.path) box.add(p);
  for (const Vec2 p : figure.joined) box.add(p);
  return box;
}

/// Columns of the grid in which n boxes of this shape come out largest.
std::size_t best_columns(std::size_t n, Vec2 box, const Box2& area) {
  std::size_t best = 1;
  double best_scale = 0.0;
  for (std::size_t columns = 1; columns <= n; ++columns) {
    const auto rows = static_cast<double>((n + columns - 1) / columns);
    const double scale =
        std::min(area.width() / (static_cast<double>(columns) * box.x), area.height() / (rows * box.y));
    if (scale > best_scale) {
      best = columns;
      best_scale = scale;
    }
  }
  return best;
}

std::vector<PlacedFigure> place(std::span<const MotifFigure> figures, const Box2& area) {
  constexpr double gap_share = 1.15;
  Vec2 largest{0.0, 0.0};
  for (const MotifFigure& figure : figures) {
    const Box2 box = box_of(figure);
    largest = {std::max(largest.x, box.width()), std::max(largest.y, box.height())};
  }
  const double gap = figures.size() > 1 ? gap_share : 1.0;
  // A flat motif needs some height too, or its row would have none.
  const Vec2 share{largest.x * gap, std::max(largest.y * gap, 0.05 * largest.x)};
  const std::size_t columns = best_columns(figures.size(), share, area);
  const std::size_t rows = (figures.size() + columns - 1) / columns;
  const Vec2 cell{area.width() / static_cast<double>(columns), area.height() / static_cast<double>(rows)};
  const double scale = std::min(cell.x / share.x, cell.y / share.y);
  std::vector<PlacedFigure> placed;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Vec2 centre{area.low.x + cell.x * (static_cast<double>(i % columns) + 0.5),
                      area.low.y + cell.y * (static_cast<double>(i / columns) + 0.5)};
    const Vec2 middle = box_of(figures[i]).center();
    placed.push_back({&figures[i], translation(centre) * scaling(scale, -scale) * translation(-1.0 * middle)});
  }
  return placed;
}

Flow draw_path(std::span<const Vec2> points, const Affine2& map, const PathHead& head, PathSink& sink) {
  std::vector<Vec2> mapped;
  for (const Vec2 p : points) mapped.push_back(map(p));
  if (sink.begin(head) == Flow::stop || sink.points(mapped) == Flow::stop) return Flow::stop;
  return sink.end();
}

/// A half arrow about a point of the edge from p to q (page, y down), its barb to the right of travel or to the left.
std::vector<Vec2> half_arrow(Vec2 p, Vec2 q, double at, bool barb_right) {
  constexpr double longest_mm = 9.0;
  constexpr double share_of_edge = 0.42;
  constexpr double barb_share = 0.42;
  const double length_mm = distance(p, q);
  const double arrow_mm = std::min(longest_mm, share_of_edge * length_mm);
  const Vec2 along = (arrow_mm / length_mm) * (q - p);
  const Vec2 right{-along.y, along.x};
  const Vec2 tail = p + at * (q - p) - 0.5 * along;
  return {tail, tail + along, tail + (barb_right ? barb_share : -barb_share) * right};
}

/// The half arrow of the dashed edge: hollow, and off its middle, through which many motifs run.
Flow draw_unit_arrow(const PlacedFigure& placed, PathSink& sink) {
  const Vec2 p = placed.page_from_unit(unit_edge[0]);
  const Vec2 q = placed.page_from_unit(unit_edge[1]);
  return draw_path(half_arrow(p, q, 0.6, true), {}, {.layer = unit_arrow_layer, .closed = true}, sink);
}

Flow draw_arrows(const PlacedFigure& placed, PathSink& sink) {
  const MotifFigure& figure = *placed.figure;
  for (std::size_t j = 0; j + 1 < figure.path.size(); ++j) {
    const bool reversed = !figure.reverse.empty() && figure.reverse[j] != 0;
    const bool mirrored = !figure.flip.empty() && figure.flip[j] != 0;
    const Vec2 p = placed.page_from_unit(figure.path[reversed ? j + 1 : j]);
    const Vec2 q = placed.page_from_unit(figure.path[reversed ? j : j + 1]);
    if (p == q) continue;
    const PathHead head{.layer = arrow_layer, .paint = Paint::fill_nonzero, .closed = true};
    if (draw_path(half_arrow(p, q, 0.5, !mirrored), {}, head, sink) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow draw_vertices(const PlacedFigure& placed, PathSink& sink) {
  for (const Vec2 p : placed.figure->path) {
    if (draw_path({&p, 1}, placed.page_from_unit, {.layer = vertex_layer}, sink) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

/// The join points of the sub-edges of the first edge; empty when the motif has none.
std::vector<Vec2> joined_points(const Motif& motif, const std::optional<SignRule>& sign,
                                const std::vector<Vec2>& path) {
  if (!motif.join) return {};
  const std::optional<Automaton> automaton = make_automaton(motif, sign);
  if (!automaton) return {};
  const std::vector<std::uint32_t>& children = automaton->states[automaton->start(0)].children;
  std::vector<Vec2> points;
  for (std::size_t j = 0; j < children.size(); ++j) {
    points.push_back(path[j] + complex_product(automaton->states[children[j]].join, path[j + 1] - path[j]));
  }
  return points;
}

}  // namespace

std::optional<std::vector<MotifFigure>> motif_figures(const Motif& motif, const std::optional<SignRule>& sign,
                                                      std::uint64_t seed) {
  const KeyedRule rule(motif, sign, seed);
  const bool has_flags = !sign && !motif.sign;
  std::vector<MotifFigure> figures;
  for (std::size_t stage = 0; stage < motif.by_level.size(); ++stage) {
    for (std::size_t edge = 0; edge < motif.by_level[stage].by_edge.size(); ++edge) {
      MotifFigure figure;
      rule.path(unit_edge[0], unit_edge[1], static_cast<int>(stage) + 1, edge, figure.path);
      if (has_flags) {
        figure.flip = motif.flip;
        figure.reverse = motif.reverse;
      }
      if (stage == 0 && edge == 0) figure.joined = joined_points(motif, sign, figure.path);
      const Box2 box = box_of(figure);
      if (!std::isfinite(box.width()) || !std::isfinite(box.height())) return std::nullopt;
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

Sheet motif_sheet(const Page& page) {
  const Pen faint{"unit edge", {140, 140, 140}, 0.35};
  const Pen ink{"motif", {25, 25, 25}, 0.8};
  const Pen dot{"vertices", {25, 25, 25}, 2.0};
  const Pen accent{"directions", {200, 60, 35}, 0.35};
  Sheet sheet{page, {faint, ink, dot, accent}, {}, {}};
  sheet.layers = {{.name = "unit edge", .pen = 0, .cap = Cap::butt, .dashes_mm = {2.4, 1.8}},
                  {.name = "unit direction", .pen = 0, .join = Join::miter},
                  {.name = "joined", .pen = 3},
                  {.name = "motif", .pen = 1},
                  {.name = "vertices", .pen = 2},
                  {.name = "directions", .pen = 3, .paint = Paint::fill_nonzero}};
  return sheet;
}

Flow draw_motif_figures(std::span<const MotifFigure> figures, const Box2& area_mm, PathSink& sink) {
  BURIN_EXPECT(!figures.empty() && area_mm.width() > 0.0 && area_mm.height() > 0.0);
  const std::vector<PlacedFigure> placed = place(figures, area_mm);
  const auto draw_layer = [&](auto draw) {
    return std::all_of(placed.begin(), placed.end(), [&](const PlacedFigure& p) { return draw(p) == Flow::go; });
  };
  const auto line = [&sink](const PlacedFigure& p, std::span<const Vec2> points, LayerId layer) {
    return draw_path(points, p.page_from_unit, {.layer = layer}, sink);
  };
  const bool complete = draw_layer([&](const PlacedFigure& p) { return line(p, unit_edge, unit_layer); }) &&
                        draw_layer([&](const PlacedFigure& p) { return draw_unit_arrow(p, sink); }) &&
                        draw_layer([&](const PlacedFigure& p) {
                          return p.figure->joined.empty() ? Flow::go : line(p, p.figure->joined, join_layer);
                        }) &&
                        draw_layer([&](const PlacedFigure& p) { return line(p, p.figure->path, motif_layer); }) &&
                        draw_layer([&](const PlacedFigure& p) { return draw_vertices(p, sink); }) &&
                        draw_layer([&](const PlacedFigure& p) { return draw_arrows(p, sink); });
  return complete ? Flow::go : Flow::stop;
}

}  // namespace burin::curves::two_point
