#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/path/decorators.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/plan.hpp>
#include <burin/preset/plan_step.hpp>

namespace burin::preset {

namespace {

std::optional<Cmyk> inks_of(const PenSpec& pen) {
  if (!pen.cmyk) return std::nullopt;
  const auto& [cyan, magenta, yellow, black] = *pen.cmyk;  // in percent
  return Cmyk{cyan / 100.0, magenta / 100.0, yellow / 100.0, black / 100.0};
}

Sheet sheet_of(const Piece& piece) {
  Sheet sheet;
  sheet.page = {piece.page.size.width_mm, piece.page.size.height_mm, piece.page.bleed.mm, piece.page.paper};
  for (const auto& [name, pen] : piece.pens) {
    sheet.pens.push_back({name, pen.color, pen.width.mm, inks_of(pen), pen.spot});
  }
  return sheet;
}

std::vector<double> dashes_mm(const LayerStyle& style) {
  std::vector<double> lengths_mm;
  for (const params::Length& dash : style.dashes) lengths_mm.push_back(dash.mm);
  return lengths_mm;
}

/// Without its dashes.
SheetLayer sheet_layer(const Piece& piece, const LayerStyle& style, const std::string& pen, Paint paint) {
  SheetLayer layer;
  layer.name = style.name;
  layer.pen = pen_index(piece, pen);
  layer.paint = paint;
  layer.cap = style.caps;
  layer.join = style.joins;
  layer.miter_limit = style.miter;
  layer.opacity = style.opacity;
  return layer;
}

using PlacedLayers = std::vector<std::shared_ptr<const PlacedLayer>>;

/// Fits every slot and numbers the items of the layers.
Result<PlacedLayers> place_layers(const Piece& piece) {
  PlacedLayers all;
  Problems problems;
  std::map<std::string, std::shared_ptr<const FittedSlot>> slots;  // null: could not be placed
  passes::Regions::Item next_item = 0;
  for (const Layer& layer : piece.layers) {
    auto [slot, is_new] = slots.try_emplace(layer.style.slot);
    if (is_new) {
      Result<FittedSlot> fitted = fit_slot(piece, layer.style.slot);
      if (fitted) {
        slot->second = std::make_shared<const FittedSlot>(*std::move(fitted));
      } else {
        problems.push_back(fitted.problems().front());
      }
    }
    if (slot->second == nullptr) continue;
    const double corner = layer.style.joins == Join::miter ? layer.style.miter : 1.5;
    const double extent_mm = half_widest_pen_mm(piece, layer) * corner;
    all.push_back(std::make_shared<const PlacedLayer>(PlacedLayer{layer, slot->second, extent_mm, next_item}));
    next_item += slot->second->copies.size() * items_of_copy(layer);
  }
  if (!problems.empty()) return problems;
  return all;
}

std::vector<LayerClip> clips_of(const PlacedLayer& placed, const PlacedLayers& all, const Piece& piece) {
  std::vector<LayerClip> clips;
  const auto add = [&](const std::optional<ClipSpec>& spec, passes::Keep keep) {
    if (!spec) return;
    LayerClip clip{.keep = keep};
    if (spec->layer.empty()) {
      clip.outline_mm = clip_outline(spec->table, placed.slot->frame, piece.page);
    } else {
      // Several when it draws another preset.
      for (const std::shared_ptr<const PlacedLayer>& other : all) {
        if (other->layer.style.name != spec->layer) continue;
        clip.by.push_back(
            {other, whole_layer(other->layer), piece.seed, std::make_shared<const std::vector<LayerClip>>()});
      }
      BURIN_EXPECT(!clip.by.empty());  // the reader has made sure
    }
    clips.push_back(std::move(clip));
  };
  const LayerStyle& style = placed.layer.style;
  add(style.clip, passes::Keep::inside);
  add(style.outside, passes::Keep::outside);
  return clips;
}

/// Whether lines of layer `index` are cut along other layers, or along its own later figures.
bool is_cut(const PlacedLayers& all, std::size_t index) {
  const LayerStyle& style = all[index]->layer.style;
  return style.clip || style.outside ||
         std::any_of(all.begin() + static_cast<std::ptrdiff_t>(index), all.end(),
                     [](const std::shared_ptr<const PlacedLayer>& later) { return later->layer.style.hide; });
}

}  // namespace

Result<Plan> Plan::make(Piece piece) {
  Result<PlacedLayers> placed = place_layers(piece);
  if (!placed) return placed.problems();
  Plan plan;
  auto sheet = std::make_shared<Sheet>(sheet_of(piece));
  auto steps = std::make_shared<std::vector<PlanStep>>();
  auto hiding = std::make_shared<std::vector<PlanStep>>();
  for (std::size_t i = 0; i < placed->size(); ++i) {
    const std::shared_ptr<const PlacedLayer>& layer = (*placed)[i];
    const LayerStyle& style = layer->layer.style;
    const bool cuts_dashes = is_cut(*placed, i);
    const auto clips = std::make_shared<const std::vector<LayerClip>>(clips_of(*layer, *placed, piece));
    const auto add = [&](const std::string& pen, LayerPart part, bool hidden) {
      sheet->layers.push_back(sheet_layer(piece, style, pen, part.paint));
      if (hidden) sheet->layers.back().name += " hidden";
      steps->push_back({layer, std::move(part), piece.seed, clips, hidden});
      (cuts_dashes ? steps->back().dashes_mm : sheet->layers.back().dashes_mm) = dashes_mm(style);
    };
    if (!style.fill.empty()) add(style.fill, whole_layer(layer->layer, fill_of(style)), false);
    for (std::size_t pen = 0; style.stroke != "none" && pen < style.pen.of.size(); ++pen) {
      if (style.pen.of[pen] != no_pen) add(style.pen.of[pen], pen_part(layer->layer, pen), false);
    }
    if (!style.hidden.empty()) add(style.hidden, whole_layer(layer->layer), true);
    if (style.hide) hiding->push_back({layer, whole_layer(layer->layer), piece.seed, clips, false});
  }
  plan.seed_in_values_ = piece.seed_in_values;
  plan.page_ = sheet->page;
  if (piece.enlarge_onto) {
    plan.enlargement_ = enlargement(sheet->page, *piece.enlarge_onto);
    *sheet = enlarged(*std::move(sheet), *plan.enlargement_);
  }
  plan.sheet_ = std::move(sheet);
  plan.steps_ = std::move(steps);
  plan.hiding_ = std::move(hiding);
  return plan;
}

void Plan::set_origin(Origin origin) {
  auto sheet = std::make_shared<Sheet>(*sheet_);
  sheet->made_by = std::move(origin);
  sheet_ = std::move(sheet);
}

RunOptions Plan::before_enlarging(RunOptions options) const {
  if (!enlargement_) return options;
  options.tolerance_mm /= enlargement_->factor;
  if (options.window) {
    options.window = PageWindow{inverse(enlargement_->new_from_page)(options.window->center_mm),
                                options.window->width_mm / enlargement_->factor};
  }
  return options;
}

Forecast Plan::forecast(const RunOptions& options, double enough) const {
  const RunOptions planned = before_enlarging(options);
  Forecast total{};
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    const PlanStep& step = (*steps_)[s];
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    // The bands of a layer share its points: the first one counts them all.
    if (step.part.pen && s > 0 && (*steps_)[s - 1].placed == step.placed && (*steps_)[s - 1].part.pen) continue;
    const LayerRun run(step.placed->layer, step.part);
    for (const Copy& copy : step.placed->slot->copies) {
      const Forecast part = step.forecast(copy, run, planned, page_, enough - total.points);
      total.points += part.points;
      total.asked_points += part.asked_points;
      total.exact = total.exact && part.exact;
      if (total.points > enough) {
        total.exact = false;
        return total;
      }
    }
  }
  return total;
}

Result<Forecast> Plan::check_size(const RunOptions& options, double max_points) const {
  const Forecast total = forecast(options, max_points);
  if (total.points <= max_points) return total;
  // Blame the layer that asks for most.
  const RunOptions planned = before_enlarging(options);
  const PlacedLayer* costliest = nullptr;
  double most = -1.0;
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    const PlanStep& step = (*steps_)[s];
    const PlacedLayer& placed = *step.placed;
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    const LayerRun run(placed.layer, step.part);
    const double asked = step.forecast(placed.slot->copies.front(), run, planned, page_, 0.0).asked_points *
                         static_cast<double>(placed.slot->copies.size());
    if (asked > most) {
      most = asked;
      costliest = &placed;
    }
  }
  return Problem{costliest->layer.where,
                 fmt::format("layer '{}' asks for {} points and would draw more than {}; lower '{}', draw coarser "
                             "(--decimals, --dpi) or raise --max-points",
                             costliest->layer.style.name, count_text(most), count_text(max_points),
                             costliest->layer.family->cost_knob),
                 Trouble::limit,
                 {}};
}

Flow Plan::run(PathSink& sink, const RunOptions& options) const {
  if (!enlargement_ || options.space == Space::model) return run_steps(sink, options);
  Mapped larger(sink, enlargement_->new_from_page);
  return run_steps(larger, before_enlarging(options));
}

Flow Plan::run_steps(PathSink& sink, const RunOptions& options) const {
  const CutAreas areas = cut_areas(*steps_, *hiding_, options, page_);
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    const PlanStep& step = (*steps_)[s];
    if (step.draw_all(static_cast<LayerId>(s), sink, options, page_, areas) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow run_for(OutputSink& sink, const std::function<Flow(const RunOptions&)>& run, RunOptions options) {
  do {
    options.part_mm = sink.wanted_part_mm();
    if (run(options) == Flow::stop) return Flow::stop;
  } while (sink.wants_another_run());
  return Flow::go;
}

bool Plan::uses_seed() const {
  return seed_in_values_ || std::any_of(steps_->begin(), steps_->end(),
                                        [](const PlanStep& step) { return preset::uses_seed(step.placed->layer); });
}

}  // namespace burin::preset
