#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/passes/crop.hpp>
#include <burin/passes/items.hpp>
#include <burin/passes/region_filter.hpp>
#include <burin/path/decorators.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/layer_run.hpp>
#include <burin/preset/plan.hpp>
#include <burin/preset/slot_fit.hpp>

namespace burin::preset {

/// A preset layer in its slot.
struct Plan::Placed {
  Layer layer;
  std::shared_ptr<const FittedSlot> slot;
  double extent_mm = 0.0;  ///< how far ink may reach beyond a point: half the widest pen, more for miters
  passes::Regions::Item first_item = 0;
};

/// What a layer is cut by: what another one encloses, or an outline in page millimetres.
struct Plan::Clip {
  passes::Keep keep = passes::Keep::inside;
  std::shared_ptr<const Step> by{};
  std::vector<Vec2> outline_mm{};
};

/// What layers hide and enclose, in the space of one run.
struct Plan::Areas {
  passes::Regions hiding;
  std::map<const Clip*, passes::Regions> clips;
};

/// One sheet layer: which placed layer it draws, and how.
struct Plan::Step {
  std::shared_ptr<const Placed> placed;
  LayerPart part;
  std::uint64_t piece_seed = 0;
  std::shared_ptr<const std::vector<Clip>> clips{};
  bool hidden = false;  ///< what others hide of it, not what is seen

  /// Where a copy lies on the page, its points counted from `origin` in model units.
  struct Placement {
    Vec2 origin;
    Affine2 page_from_model;
  };
  Placement placement(const Copy& copy, const RunOptions& options, const Page& page) const;
  DrawContext context(const Copy& copy, const RunOptions& options, const Page& page) const;
  /// Draws one copy into `sink`, in the space of the options. `item`: see LayerRun.
  Flow draw(const Copy& copy, LayerRun& run, LayerId layer, PathSink& sink, const RunOptions& options, const Page& page,
            passes::Regions::Item& item) const;
  /// Draws every copy, cut by the areas and to the window.
  Flow draw_all(LayerId layer, PathSink& sink, const RunOptions& options, const Page& page, const Areas& areas) const;
  /// Adds what the step's paths enclose.
  void add_areas(passes::Regions& regions, const RunOptions& options, const Page& page) const;
  Forecast forecast(const Copy& copy, const LayerRun& run, const RunOptions& options, const Page& page,
                    double enough) const;
};

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

SheetLayer sheet_layer(const Piece& piece, const LayerStyle& style, const std::string& pen, Paint paint) {
  SheetLayer layer;
  layer.name = style.name;
  layer.pen = pen_index(piece, pen);
  layer.paint = paint;
  layer.cap = style.caps;
  layer.join = style.joins;
  layer.miter_limit = style.miter;
  for (const params::Length& dash : style.dashes) layer.dashes_mm.push_back(dash.mm);
  layer.opacity = style.opacity;
  return layer;
}

/// What the page shows, bleed and all.
Box2 with_bleed(const Page& page) {
  return Box2{{0.0, 0.0}, {page.width_mm, page.height_mm}}.grown(page.bleed_mm);
}

/// An outline on the page as the window shows it.
std::vector<Vec2> outline_in_window(std::vector<Vec2> outline_mm, const RunOptions& options, const Page& page) {
  if (!options.window) return outline_mm;
  const double zoom = page.width_mm / options.window->width_mm;
  const Vec2 middle{0.5 * page.width_mm, 0.5 * page.height_mm};
  for (Vec2& p : outline_mm) p = middle + zoom * (p - options.window->center_mm);
  return outline_mm;
}

Paint fill_of(const LayerStyle& style) {
  return style.rule == FillRule::evenodd ? Paint::fill_evenodd : Paint::fill_nonzero;
}

}  // namespace

Plan::Step::Placement Plan::Step::placement(const Copy& copy, const RunOptions& options, const Page& page) const {
  if (options.space == Space::model) return {{}, copy.model_from_model};
  const Affine2 page_from_model = placed->slot->frame.page_from_slot() * copy.slot_from_model;
  if (!options.window) return {{}, page_from_model};
  // The window's centre is the origin, so that a deep zoom subtracts nothing large from anything large.
  const double zoom = page.width_mm / options.window->width_mm;
  const Affine2 m = page_from_model;
  return {inverse(page_from_model)(options.window->center_mm),
          {zoom * m.a, zoom * m.b, zoom * m.c, zoom * m.d, 0.5 * page.width_mm, 0.5 * page.height_mm}};
}

DrawContext Plan::Step::context(const Copy& copy, const RunOptions& options, const Page& page) const {
  DrawContext context{
      .seed = layer_seed(placed->layer, piece_seed, copy.cell), .stop = options.stop, .executor = options.executor};
  const Placement place = placement(copy, options, page);
  context.origin = place.origin;
  context.mm_per_unit = options.space == Space::page ? place.page_from_model.scale() : copy.slot_from_model.scale();
  if (options.tolerance_mm > 0.0 && options.space == Space::page && !needs_every_point(placed->layer)) {
    Box2 seen = with_bleed(page);
    // Dashes go on from what is left out, and what hides is counted, which therefore must be the same for every part.
    const LayerStyle& style = placed->layer.style;
    if (style.dashes.empty() && !style.hide) seen = intersection(seen, options.part_mm);
    context.view.box = image_box(inverse(place.page_from_model), seen.grown(placed->extent_mm));
    context.view.tolerance = options.tolerance_mm / context.mm_per_unit;
  }
  return context;
}

Flow Plan::Step::draw(const Copy& copy, LayerRun& run, LayerId layer, PathSink& sink, const RunOptions& options,
                      const Page& page, passes::Regions::Item& item) const {
  // From the generator: figures or bands of its line, the page, this layer's name on every path.
  const DrawContext drawn = context(copy, options, page);
  Painted painted(sink, layer, part.paint);
  Mapped mapped(painted, placement(copy, options, page).page_from_model);
  Stoppable stoppable(mapped, options.stop);
  return run.draw(setting_of(placed->slot->frame, copy, drawn), drawn, stoppable, item);
}

Flow Plan::Step::draw_all(LayerId layer, PathSink& sink, const RunOptions& options, const Page& page,
                          const Areas& areas) const {
  // Onto the page: what later items hide, what clips, the window.
  PathSink* next = &sink;
  std::optional<passes::Crop> window;
  if (options.window && options.space == Space::page) {
    window.emplace(*next, with_bleed(page).grown(placed->extent_mm));
    next = &*window;
  }
  std::deque<passes::RegionFilter> filters;
  for (const Clip& clip : *clips) {
    if (options.space == Space::model) break;
    next = &filters.emplace_back(
        *next, areas.clips.at(&clip), clip.keep,
        clip.keep == passes::Keep::inside ? passes::Border::is_inside : passes::Border::is_outside);
  }
  passes::Regions::Item item = placed->first_item;
  if (!areas.hiding.empty()) {
    const passes::Keep keep = hidden ? passes::Keep::inside : passes::Keep::outside;
    next = &filters.emplace_back(*next, areas.hiding, keep, passes::Border::is_outside, item);
  }
  LayerRun run(placed->layer, part);
  for (const Copy& copy : placed->slot->copies) {
    if (draw(copy, run, layer, *next, options, page, item) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

void Plan::Step::add_areas(passes::Regions& regions, const RunOptions& options, const Page& page) const {
  passes::Regions::Item item = placed->first_item;
  passes::RegionRecorder recorder(regions, item);
  // A deep zoom makes outlines long; what shows of their areas stays as it is.
  std::optional<passes::Crop> window;
  if (options.window) window.emplace(recorder, with_bleed(page).grown(placed->extent_mm + 1.0));
  passes::ClosedPaths areas(window ? static_cast<PathSink&>(*window) : recorder, fill_of(placed->layer.style));
  LayerRun run(placed->layer, part);
  for (const Copy& copy : placed->slot->copies) {
    if (draw(copy, run, 0, areas, options, page, item) == Flow::stop) return;
  }
}

Forecast Plan::Step::forecast(const Copy& copy, const LayerRun& run, const RunOptions& options, const Page& page,
                              double enough) const {
  const DrawContext drawn = context(copy, options, page);
  return run.forecast(setting_of(placed->slot->frame, copy, drawn), drawn, enough);
}

Result<Plan> Plan::make(Piece piece) {
  Result<std::vector<std::shared_ptr<const Placed>>> placed = place_layers(piece);
  if (!placed) return placed.problems();
  Plan plan;
  auto sheet = std::make_shared<Sheet>(sheet_of(piece));
  auto steps = std::make_shared<std::vector<Step>>();
  auto hiding = std::make_shared<std::vector<Step>>();
  for (const std::shared_ptr<const Placed>& layer : *placed) {
    const LayerStyle& style = layer->layer.style;
    const auto clips = std::make_shared<const std::vector<Clip>>(clips_of(*layer, *placed, piece));
    const auto add = [&](const std::string& pen, LayerPart part, bool hidden) {
      sheet->layers.push_back(sheet_layer(piece, style, pen, part.paint));
      if (hidden) sheet->layers.back().name += " hidden";
      steps->push_back({layer, std::move(part), piece.seed, clips, hidden});
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

Result<std::vector<std::shared_ptr<const Plan::Placed>>> Plan::place_layers(const Piece& piece) {
  std::vector<std::shared_ptr<const Placed>> all;
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
    all.push_back(std::make_shared<const Placed>(Placed{layer, slot->second, extent_mm, next_item}));
    next_item += slot->second->copies.size() * items_of_copy(layer);
  }
  if (!problems.empty()) return problems;
  return all;
}

std::vector<Plan::Clip> Plan::clips_of(const Placed& placed, const std::vector<std::shared_ptr<const Placed>>& all,
                                       const Piece& piece) {
  std::vector<Clip> clips;
  const auto add = [&](const std::optional<ClipSpec>& spec, passes::Keep keep) {
    if (!spec) return;
    Clip clip{.keep = keep};
    if (spec->layer.empty()) {
      clip.outline_mm = clip_outline(spec->table, placed.slot->frame, piece.page);
    } else {
      const auto by =
          std::ranges::find_if(all, [&](const auto& other) { return other->layer.style.name == spec->layer; });
      // The reader has made sure that there is one.
      BURIN_EXPECT(by != all.end());
      clip.by = std::make_shared<const Step>(
          Step{*by, whole_layer((*by)->layer), piece.seed, std::make_shared<const std::vector<Clip>>(), false});
    }
    clips.push_back(std::move(clip));
  };
  const LayerStyle& style = placed.layer.style;
  add(style.clip, passes::Keep::inside);
  add(style.outside, passes::Keep::outside);
  return clips;
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
    const Step& step = (*steps_)[s];
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
  const Placed* costliest = nullptr;
  double most = -1.0;
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    const Step& step = (*steps_)[s];
    const Placed& placed = *step.placed;
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

Plan::Areas Plan::areas_of(const RunOptions& options) const {
  Areas areas;
  // The curves themselves are neither hidden nor clipped.
  if (options.space == Space::model) return areas;
  RunOptions whole = options;
  whole.part_mm = Box2::everything();
  for (const Step& step : *hiding_) step.add_areas(areas.hiding, whole, page_);
  areas.hiding.build_index();
  for (const Step& step : *steps_) {
    for (const Clip& clip : *step.clips) {
      const auto [found, is_new] = areas.clips.try_emplace(&clip);
      if (!is_new) continue;
      passes::Regions& regions = found->second;
      if (clip.by != nullptr) {
        clip.by->add_areas(regions, whole, page_);
      } else {
        regions.add(0, {outline_in_window(clip.outline_mm, options, page_)}, Paint::fill_nonzero);
      }
      regions.build_index();
    }
  }
  return areas;
}

Flow Plan::run_steps(PathSink& sink, const RunOptions& options) const {
  const Areas areas = areas_of(options);
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    const Step& step = (*steps_)[s];
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
                                        [](const Step& step) { return preset::uses_seed(step.placed->layer); });
}

}  // namespace burin::preset
