#include <algorithm>
#include <numeric>

#include <burin/passes/items.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/layer_run.hpp>
#include <burin/preset/pen_bands.hpp>

namespace burin::preset {

namespace {

/// Whether which pen draws is settled by the level alone.
bool pens_follow_levels(const Layer& layer) {
  return layer.style.pen.takes_turns() && !layer.coarser.empty();
}

/// Whether what is placed depends on all that was placed before, on other levels too.
bool remembers(const primitives::PlacingSpec& spec) {
  return spec.distinct || spec.apart.mm > 0.0;
}

/// What of a figure is an area, as one; null when nothing is.
std::shared_ptr<const Figure> filled(const Figure& figure, Paint paint) {
  const Recording& drawing = figure.drawing();
  Recorder recorder;
  Painted painted(recorder, 0, paint);
  const auto record = [&](const Recording::Path& path) {
    if (painted.begin(path.head) == Flow::stop) return Flow::stop;
    bool first = true;
    for (const Recording::Contour& contour : drawing.contours(path)) {
      if (!first && painted.contour() == Flow::stop) return Flow::stop;
      first = false;
      if (painted.points(drawing.points(contour)) == Flow::stop) return Flow::stop;
    }
    return painted.end();
  };
  for (const Recording::Path& path : drawing.paths()) {
    const bool area = path.head.closed || path.head.paint != Paint::stroke;
    if (area && record(path) == Flow::stop) return nullptr;
  }
  return recorder.recording().empty() ? nullptr : std::make_shared<const Figure>(recorder.take());
}

/// Counts points and stops above a number of them.
class PointLimit final : public PathSink {
 public:
  explicit PointLimit(double enough) : enough_(enough) {}
  Flow begin(const PathHead&) override { return Flow::go; }
  Flow points(std::span<const Vec2> points) override { return counted(points.size()); }
  Flow contour() override { return Flow::go; }
  Flow end() override { return Flow::go; }
  Flow place(const PathHead&, const Figure& figure, const Affine2&) override {
    return counted(figure.drawing().all_points().size());
  }
  double count() const { return count_; }

 private:
  Flow counted(std::size_t points) {
    count_ += static_cast<double>(points);
    return count_ > enough_ ? Flow::stop : Flow::go;
  }

  double enough_;
  double count_ = 0.0;
};

/// More items than a level has of them.
constexpr passes::Regions::Item items_of_level = passes::Regions::Item{1} << 32U;

/// A curve is run through to count its figures up to so many points.
constexpr double most_points_counted = 5e7;

}  // namespace

LayerPart whole_layer(const Layer& layer, Paint paint) {
  LayerPart part{paint, std::nullopt, std::vector<std::size_t>(layer.level_count())};
  std::iota(part.levels.begin(), part.levels.end(), std::size_t{0});
  return part;
}

LayerPart pen_part(const Layer& layer, std::size_t pen) {
  LayerPart part = whole_layer(layer);
  const std::size_t pens = layer.style.pen.of.size();
  if (pens == 1) return part;
  if (!pens_follow_levels(layer) || (layer.style.primitives && remembers(*layer.style.primitives))) {
    part.pen = pen;
  } else {
    std::erase_if(part.levels, [&](std::size_t level) { return level % pens != pen; });
  }
  return part;
}

passes::Regions::Item items_of_copy(const Layer& layer) {
  return layer.level_count() * items_of_level;
}

primitives::Setting setting_of(const SlotFrame& frame, const Copy& copy, const DrawContext& context) {
  return {.slot_from_model = copy.slot_from_model,
          .slot_width_mm = frame.width_mm,
          .slot_height_mm = frame.height_mm,
          .column = copy.column,
          .row = copy.row,
          .copy = copy.index,
          .seed = context.seed,
          .origin = context.origin};
}

LayerRun::LayerRun(const Layer& layer, const LayerPart& part)
    : layer_(layer), part_(part), pens_(layer.style.pen), placing_(layer.style.primitives), figures_(layer.figures) {
  if (part.paint == Paint::stroke) return;
  for (std::shared_ptr<const Figure>& figure : figures_) {
    if (figure != nullptr) figure = filled(*figure, part.paint);
  }
}

Flow LayerRun::draw_levels(const DrawContext& context, PathSink& sink, passes::Regions::Item& item,
                           primitives::Placing* placing) {
  const passes::Regions::Item first = item;
  for (const std::size_t level : part_.levels) {
    const std::any& parameters = layer_.level_parameters(level);
    if (placing != nullptr) placing->begin_level(layer_.family->retained_every(parameters));
    item = first + level * items_of_level;
    if (layer_.family->draw(parameters, context, sink) == Flow::stop) return Flow::stop;
  }
  item = first + items_of_copy(layer_);
  return Flow::go;
}

Flow LayerRun::draw(const primitives::Setting& setting, const DrawContext& context, PathSink& sink,
                    passes::Regions::Item& item, bool* overflowed) {
  if (placing_) {
    const primitives::PenFilter filter =
        part_.pen ? primitives::PenFilter{&pens_, *part_.pen} : primitives::PenFilter{};
    primitives::Placing placing(sink, *placing_, figures_, setting, filter);
    placing.count_items(item);
    Stoppable stoppable(placing, context.stop);  // few points may reach the sink
    const Flow flow = draw_levels(context, stoppable, item, &placing);
    if (overflowed != nullptr) *overflowed = *overflowed || placing.overflowed();
    return flow;
  }
  std::optional<PenBand> banded;
  if (part_.pen) banded.emplace(sink, pens_, *part_.pen, setting);
  passes::ItemCounter counter(banded ? static_cast<PathSink&>(*banded) : sink, item);
  return draw_levels(context, counter, item, nullptr);
}

Forecast LayerRun::forecast_curve(const DrawContext& context, double enough) const {
  Forecast total{};
  for (const std::size_t level : part_.levels) {
    const Forecast part = layer_.family->forecast(layer_.level_parameters(level), context, enough - total.points);
    total.points += part.points;
    total.asked_points += part.asked_points;
    // Cuts between bands add points of their own.
    total.exact = total.exact && part.exact && !part_.pen;
    if (total.points > enough) {
      total.exact = false;
      return total;
    }
  }
  return total;
}

Forecast LayerRun::forecast(const primitives::Setting& setting, const DrawContext& context, double enough) const {
  if (!placing_) return forecast_curve(context, enough);
  const Forecast curve = forecast_curve(context, most_points_counted);
  double largest = 0.0;
  bool all_alike = true;
  for (const std::shared_ptr<const Figure>& figure : figures_) {
    const double points = figure == nullptr ? 0.0 : static_cast<double>(figure->drawing().all_points().size());
    all_alike = all_alike && (largest == 0.0 || largest == points);
    largest = std::max(largest, points);
  }
  const bool by_turns = placing_->every.length_mm > 0.0 || placing_->every.count > 1;
  const double asked = curve.asked_points / static_cast<double>(placing_->every.count) * largest;
  if (curve.points > most_points_counted) return {curve.points * largest, asked, false};
  if (by_turns || asked > enough) return count_figures(setting, context, asked, enough);
  const bool exact = curve.exact && all_alike && !part_.pen && primitives::fills_every_place(*placing_) &&
                     placing_->at == primitives::PlaceAt::points && placing_->mode == primitives::PlaceMode::all;
  return {asked, asked, exact};
}

/// Of all pens together, as for curves.
Forecast LayerRun::count_figures(const primitives::Setting& setting, const DrawContext& context, double asked,
                                 double enough) const {
  LayerPart part = part_;
  part.pen.reset();
  PointLimit limit(enough);
  passes::Regions::Item item = 0;
  const bool ended = LayerRun(layer_, part).draw(setting, context, limit, item) == Flow::stop;
  return {limit.count(), asked, !ended};
}

}  // namespace burin::preset
