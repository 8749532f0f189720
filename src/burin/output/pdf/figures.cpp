#include <algorithm>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/output/pdf/figures.hpp>
#include <burin/output/pdf/pieces.hpp>

namespace burin::output::pdf {

namespace {

constexpr std::size_t fewest_points = 16;  ///< below, a call of a form is longer than the figure
constexpr std::size_t most_points = 1U << 16U;
constexpr std::size_t most_figures = 256;

}  // namespace

double reach(const Box2& box) {
  return std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

std::optional<FigureForm> figure_form(const Figure& figure) {
  const Recording& drawing = figure.drawing();
  if (drawing.all_points().size() < fewest_points) return std::nullopt;
  const double farthest = reach(figure.bounds());
  if (!(farthest > 0.0) || !std::isfinite(form_size / farthest)) return std::nullopt;
  const double scale = form_size / farthest;
  Pieces pieces(0);
  std::vector<Vec2> scaled;
  for (const Recording::Path& path : drawing.paths()) {
    pieces.begin_path(path.head.paint);
    for (const Recording::Contour& contour : drawing.contours(path)) {
      scaled.clear();
      for (const Vec2 p : drawing.points(contour)) scaled.push_back(scale * p);
      pieces.start(pieces.grid()(scaled.front()));
      if (pieces.lines(scaled) == 0) return std::nullopt;
      if (path.head.closed) pieces.close();
    }
  }
  pieces.end_piece();
  return FigureForm{std::string(pieces.text()), scale};
}

std::optional<Figures::Known> Figures::find(const Figure& figure) const {
  const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) { return kept.figure.looks_like(figure); });
  return found == kept_.end() ? std::nullopt : std::optional(found->known);
}

bool Figures::has_room_for(const Figure& figure) const {
  return kept_.size() < most_figures && points_ + figure.drawing().all_points().size() <= most_points;
}

Figures::Known Figures::add(const Figure& figure, double units_per_figure_unit) {
  BURIN_EXPECT(has_room_for(figure));
  points_ += figure.drawing().all_points().size();
  kept_.push_back({figure, {kept_.size(), units_per_figure_unit}});
  return kept_.back().known;
}

}  // namespace burin::output::pdf
