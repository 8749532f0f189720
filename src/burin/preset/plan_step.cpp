#include <deque>
#include <optional>

#include <burin/passes/crop.hpp>
#include <burin/passes/dashes.hpp>
#include <burin/passes/items.hpp>
#include <burin/path/decorators.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/plan_step.hpp>

namespace burin::preset {

namespace {

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

}  // namespace

PlanStep::Placement PlanStep::placement(const Copy& copy, const RunOptions& options, const Page& page) const {
  if (options.space == Space::model) return {{}, copy.model_from_model};
  const Affine2 page_from_model = placed->slot->frame.page_from_slot() * copy.slot_from_model;
  if (!options.window) return {{}, page_from_model};
  // The window's centre is the origin, so that a deep zoom subtracts nothing large from anything large.
  const double zoom = page.width_mm / options.window->width_mm;
  const Affine2 m = page_from_model;
  return {inverse(page_from_model)(options.window->center_mm),
          {zoom * m.a, zoom * m.b, zoom * m.c, zoom * m.d, 0.5 * page.width_mm, 0.5 * page.height_mm}};
}

DrawContext PlanStep::context(const Copy& copy, const RunOptions& options, const Page& page) const {
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

Flow PlanStep::draw(const Copy& copy, LayerRun& run, LayerId layer, PathSink& sink, const RunOptions& options,
                    const Page& page, passes::Regions::Item& item) const {
  // From the generator: figures or bands of its line, the page, this layer's name on every path.
  const DrawContext drawn = context(copy, options, page);
  Painted painted(sink, layer, part.paint);
  Mapped mapped(painted, placement(copy, options, page).page_from_model);
  Stoppable stoppable(mapped, options.stop);
  return run.draw(setting_of(placed->slot->frame, copy, drawn), drawn, stoppable, item);
}

PathSink& PlanStep::clipped(PathSink& sink, const CutAreas& areas, std::deque<passes::RegionFilter>& filters) const {
  PathSink* next = &sink;
  for (const LayerClip& clip : *clips) {
    next = &filters.emplace_back(
        *next, areas.clips.at(&clip), clip.keep,
        clip.keep == passes::Keep::inside ? passes::Border::is_inside : passes::Border::is_outside);
  }
  return *next;
}

Flow PlanStep::draw_all(LayerId layer, PathSink& sink, const RunOptions& options, const Page& page,
                        const CutAreas& areas) const {
  // Onto the page: dashes, what later items hide, what clips, the window.
  PathSink* next = &sink;
  std::optional<passes::Crop> window;
  if (options.window && options.space == Space::page) {
    window.emplace(*next, with_bleed(page).grown(placed->extent_mm));
    next = &*window;
  }
  std::deque<passes::RegionFilter> filters;
  if (options.space == Space::page) next = &clipped(*next, areas, filters);
  passes::Regions::Item item = placed->first_item;
  if (!areas.hiding.empty()) {
    const passes::Keep keep = hidden ? passes::Keep::inside : passes::Keep::outside;
    next = &filters.emplace_back(*next, areas.hiding, keep, passes::Border::is_outside, item);
  }
  std::optional<passes::Dashes> dashes;
  if (!dashes_mm.empty() && options.space == Space::page) {
    dashes.emplace(*next, dashes_mm, with_bleed(page).grown(placed->extent_mm));
    next = &*dashes;
  }
  LayerRun run(placed->layer, part);
  for (const Copy& copy : placed->slot->copies) {
    if (draw(copy, run, layer, *next, options, page, item) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

void PlanStep::add_areas(passes::Regions& regions, const RunOptions& options, const Page& page,
                         const CutAreas& areas) const {
  passes::Regions::Item item = placed->first_item;
  passes::RegionRecorder recorder(regions, item);
  std::deque<passes::RegionFilter> filters;
  PathSink* next = &clipped(recorder, areas, filters);
  // A deep zoom makes outlines long; what shows of their areas stays as it is.
  std::optional<passes::Crop> window;
  if (options.window) next = &window.emplace(*next, with_bleed(page).grown(placed->extent_mm + 1.0));
  passes::ClosedPaths closed(*next, fill_of(placed->layer.style));
  LayerRun run(placed->layer, part);
  for (const Copy& copy : placed->slot->copies) {
    if (draw(copy, run, 0, closed, options, page, item) == Flow::stop) return;
  }
}

Forecast PlanStep::forecast(const Copy& copy, const LayerRun& run, const RunOptions& options, const Page& page,
                            double enough) const {
  const DrawContext drawn = context(copy, options, page);
  return run.forecast(setting_of(placed->slot->frame, copy, drawn), drawn, enough);
}

CutAreas cut_areas(const std::vector<PlanStep>& steps, const std::vector<PlanStep>& hiding, const RunOptions& options,
                   const Page& page) {
  CutAreas areas;
  // The curves themselves are neither hidden nor clipped.
  if (options.space == Space::model) return areas;
  RunOptions whole = options;
  whole.part_mm = Box2::everything();
  const auto add_clips = [&](const PlanStep& step) {
    for (const LayerClip& clip : *step.clips) {
      const auto [found, is_new] = areas.clips.try_emplace(&clip);
      if (!is_new) continue;
      passes::Regions& regions = found->second;
      for (const PlanStep& by : clip.by) by.add_areas(regions, whole, page, areas);
      if (clip.by.empty()) {
        regions.add(0, {outline_in_window(clip.outline_mm, options, page)}, Paint::fill_nonzero);
      }
      regions.build_index();
    }
  };
  for (const PlanStep& step : steps) add_clips(step);
  for (const PlanStep& step : hiding) add_clips(step);
  for (const PlanStep& step : hiding) step.add_areas(areas.hiding, whole, page, areas);
  areas.hiding.build_index();
  return areas;
}

}  // namespace burin::preset
