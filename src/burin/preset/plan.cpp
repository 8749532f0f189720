#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>
#include <burin/passes/crop.hpp>
#include <burin/path/decorators.hpp>
#include <burin/preset/pen_bands.hpp>
#include <burin/preset/plan.hpp>
#include <burin/preset/slot_layout.hpp>

namespace burin::preset {

/// A slot with every copy of what it holds, shared by its layers.
struct Plan::PlacedSlot {
  SlotFrame frame;
  std::vector<Copy> copies;
};

/// A preset layer in its slot.
struct Plan::Placed {
  Layer layer;
  std::shared_ptr<const PlacedSlot> slot;
  double extent_mm = 0.0;  ///< how far ink may reach beyond a point: half the widest pen, more for miters

  std::uint64_t seed_of(const Copy& copy, std::uint64_t piece_seed) const;
};

/// One sheet layer: which placed layer it draws, and how.
struct Plan::Step {
  std::shared_ptr<const Placed> placed;
  Paint paint = Paint::stroke;
  std::optional<std::size_t> band;  ///< of the layer's pens; nothing: all of it
  std::uint64_t piece_seed = 0;

  /// Where a copy lies on the page, its points counted from `origin` in model units.
  struct Placement {
    Vec2 origin;
    Affine2 page_from_model;
  };
  Placement placement(const Copy& copy, const RunOptions& options, const Page& page) const;
  DrawContext context(const Copy& copy, const RunOptions& options, const Page& page) const;
  /// `pens` is the layer's own choice, copied for this run: expressions are not shared between threads.
  Flow draw(const Copy& copy, const PenChoice& pens, LayerId layer, PathSink& sink, const RunOptions& options,
            const Page& page) const;
};

namespace {

std::uint64_t layer_seed(const Layer& layer, std::uint64_t piece_seed, int cell) {
  std::uint64_t seed = piece_seed;
  if (layer.style.seed != 0) seed = random_bits(seed, layer.style.seed);
  // The first copy is the plain picture; the symmetric copies of a cell are alike.
  return cell == 0 ? seed : random_bits(seed, cell);
}

const SlotSpec& slot_called(const Piece& piece, const std::string& name) {
  static const SlotSpec live_area;
  for (const NamedSlot& slot : piece.slots) {
    if (slot.name == name) return slot.slot;
  }
  return live_area;
}

std::size_t pen_index(const Piece& piece, const std::string& name) {
  for (std::size_t pen = 0; pen < piece.pens.size(); ++pen) {
    if (piece.pens[pen].name == name) return pen;
  }
  return 0;
}

double half_widest_pen_mm(const Piece& piece, const Layer& layer) {
  if (layer.style.stroke == "none") return 0.0;
  double widest = 0.0;
  for (const std::string& name : layer.style.pen.of) {
    widest = std::max(widest, piece.pens[pen_index(piece, name)].pen.width.mm);
  }
  return 0.5 * widest;
}

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

/// Most points a curve is run through before its size is known.
constexpr double most_points_unbounded = 5e7;

/// Why the layer's curve has no finite box, in words for the user.
Problem no_box(const Layer& layer, std::uint64_t seed) {
  const double asked = layer.family->forecast(layer.parameters, {.seed = seed}, 0.0).asked_points;
  if (asked > most_points_unbounded) {
    return {{},
            fmt::format("its curve cannot be fitted to the page: it has {} points, and all of them would have to be "
                        "drawn to know its size; lower '{}'",
                        count_text(asked), layer.family->cost_knob),
            Trouble::limit,
            {}};
  }
  return {{},
          "its curve cannot be fitted to the page: a point of it is not a number, or too far away to compute with; "
          "check its numbers and expressions",
          Trouble::input,
          {}};
}

}  // namespace

std::uint64_t Plan::Placed::seed_of(const Copy& copy, std::uint64_t piece_seed) const {
  return layer_seed(layer, piece_seed, copy.cell);
}

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
  DrawContext context{.seed = placed->seed_of(copy, piece_seed), .stop = options.stop, .executor = options.executor};
  const Placement place = placement(copy, options, page);
  context.origin = place.origin;
  context.mm_per_unit = options.space == Space::page ? place.page_from_model.scale() : copy.slot_from_model.scale();
  if (options.tolerance_mm > 0.0 && options.space == Space::page) {
    Box2 seen = with_bleed(page);
    // Dashes go on from what is left out, which therefore must be the same for every part.
    if (placed->layer.style.dashes.empty()) seen = intersection(seen, options.part_mm);
    context.view.box = image_box(inverse(place.page_from_model), seen.grown(placed->extent_mm));
    context.view.tolerance = options.tolerance_mm / context.mm_per_unit;
  }
  return context;
}

Flow Plan::Step::draw(const Copy& copy, const PenChoice& pens, LayerId layer, PathSink& sink, const RunOptions& options,
                      const Page& page) const {
  // From the generator: its band of the pen, the page, this layer's name on every path, the window.
  const DrawContext drawn = context(copy, options, page);
  std::optional<passes::Crop> crop;
  if (options.window && options.space == Space::page) crop.emplace(sink, with_bleed(page).grown(placed->extent_mm));
  Painted painted(crop ? static_cast<PathSink&>(*crop) : sink, layer, paint);
  Mapped mapped(painted, placement(copy, options, page).page_from_model);
  Stoppable stoppable(mapped, options.stop);
  if (!band) return placed->layer.family->draw(placed->layer.parameters, drawn, stoppable);
  PenBand banded(stoppable, pens, *band, copy, placed->slot->frame, drawn);
  return placed->layer.family->draw(placed->layer.parameters, drawn, banded);
}

Result<Plan::PlacedSlot> Plan::place_slot(const Piece& piece, const std::string& name) {
  std::vector<const Layer*> layers;
  for (const Layer& layer : piece.layers) {
    if (layer.style.slot == name) layers.push_back(&layer);
  }
  // One fit for all layers of a slot: the box is over the slot's layers, the inset over their pens.
  double inset_mm = 0.0;
  bool cells_differ = false;
  for (const Layer* layer : layers) {
    inset_mm = std::max(inset_mm, half_widest_pen_mm(piece, *layer));
    cells_differ = cells_differ || layer->family->uses_seed(layer->parameters);
  }
  const Layer* boxless = nullptr;
  const ContentBox content_box = [&](const Affine2& map, int cell) -> std::optional<Box2> {
    Box2 content;
    if (cell > 0 && !cells_differ) return content;  // nothing that cell 0 has not
    for (const Layer* layer : layers) {
      const std::optional<Box2> box =
          layer->family->bounds(layer->parameters, {.seed = layer_seed(*layer, piece.seed, cell)}, map);
      if (!box || !is_finite(box->low) || !is_finite(box->high)) {
        boxless = layer;
        return std::nullopt;
      }
      content.add(*box);
    }
    return content;
  };
  PlacedSlot placed{slot_frame(piece.page, slot_called(piece, name)), {}};
  Result<std::vector<Copy>> copies = lay_out(slot_called(piece, name), placed.frame, inset_mm, content_box);
  if (!copies) {
    const Layer& blamed = boxless != nullptr ? *boxless : *layers.front();
    Problem problem = boxless != nullptr ? no_box(*boxless, piece.seed) : copies.problems().front();
    problem.where = blamed.where;
    problem.message = fmt::format("layer '{}': {}", blamed.style.name, problem.message);
    return problem;
  }
  placed.copies = *std::move(copies);
  return placed;
}

Result<Plan> Plan::make(Piece piece) {
  Plan plan;
  auto sheet = std::make_shared<Sheet>(sheet_of(piece));
  auto steps = std::make_shared<std::vector<Step>>();
  Problems problems;
  std::map<std::string, std::shared_ptr<const PlacedSlot>> slots;  // null: could not be placed
  for (const Layer& layer : piece.layers) {
    auto [slot, is_new] = slots.try_emplace(layer.style.slot);
    if (is_new) {
      Result<PlacedSlot> placed_slot = place_slot(piece, layer.style.slot);
      if (placed_slot) {
        slot->second = std::make_shared<const PlacedSlot>(*std::move(placed_slot));
      } else {
        problems.push_back(placed_slot.problems().front());
      }
    }
    if (slot->second == nullptr) continue;
    auto placed = std::make_shared<Placed>();
    placed->slot = slot->second;
    placed->extent_mm = half_widest_pen_mm(piece, layer) * (layer.style.joins == Join::miter ? layer.style.miter : 1.5);
    placed->layer = layer;
    const LayerStyle& style = placed->layer.style;
    if (!style.fill.empty()) {
      const Paint rule = style.rule == FillRule::evenodd ? Paint::fill_evenodd : Paint::fill_nonzero;
      sheet->layers.push_back(sheet_layer(piece, style, style.fill, rule));
      steps->push_back({placed, rule, std::nullopt, piece.seed});
    }
    if (style.stroke == "none") continue;
    for (std::size_t band = 0; band < style.pen.of.size(); ++band) {
      sheet->layers.push_back(sheet_layer(piece, style, style.pen.of[band], Paint::stroke));
      steps->push_back(
          {placed, Paint::stroke, style.pen.of.size() > 1 ? std::optional(band) : std::nullopt, piece.seed});
    }
  }
  if (!problems.empty()) return problems;
  plan.seed_in_values_ = piece.seed_in_values;
  plan.page_ = sheet->page;
  if (piece.enlarge_onto) {
    plan.enlargement_ = enlargement(sheet->page, *piece.enlarge_onto);
    *sheet = enlarged(*std::move(sheet), *plan.enlargement_);
  }
  plan.sheet_ = std::move(sheet);
  plan.steps_ = std::move(steps);
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
    const Step& step = (*steps_)[s];
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    // The bands of a layer share its points: the first one counts them all.
    if (step.band.value_or(0) > 0) continue;
    for (const Copy& copy : step.placed->slot->copies) {
      const Forecast part = step.placed->layer.family->forecast(
          step.placed->layer.parameters, step.context(copy, planned, page_), enough - total.points);
      total.points += part.points;
      total.asked_points += part.asked_points;
      // Cuts between bands add points of their own.
      total.exact = total.exact && part.exact && !step.band;
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
  const Placed* costliest = nullptr;
  double most = -1.0;
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    const Placed& placed = *(*steps_)[s].placed;
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    const double asked = placed.layer.family->forecast(placed.layer.parameters, {}, 0.0).asked_points *
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
  for (std::size_t s = 0; s < steps_->size(); ++s) {
    if (options.wanted && !options.wanted(sheet_->layers[s])) continue;
    const Step& step = (*steps_)[s];
    const PenChoice pens = step.placed->layer.style.pen;
    for (const Copy& copy : step.placed->slot->copies) {
      if (step.draw(copy, pens, static_cast<LayerId>(s), sink, options, page_) == Flow::stop) return Flow::stop;
    }
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
  constexpr std::size_t rand_variable = band_variables.size() - 1;
  return seed_in_values_ || std::any_of(steps_->begin(), steps_->end(), [](const Step& step) {
           const Layer& layer = step.placed->layer;
           return layer.family->uses_seed(layer.parameters) || (step.band && layer.style.pen.by.uses(rand_variable));
         });
}

}  // namespace burin::preset
