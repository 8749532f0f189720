#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include <burin/passes/region_filter.hpp>
#include <burin/passes/regions.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/preset/layer_run.hpp>
#include <burin/preset/piece.hpp>
#include <burin/preset/plan.hpp>
#include <burin/preset/slot_fit.hpp>

namespace burin::preset {

/// A preset layer in its slot.
struct PlacedLayer {
  Layer layer;
  std::shared_ptr<const FittedSlot> slot;
  double extent_mm = 0.0;  ///< how far ink may reach beyond a point: half the widest pen, more for miters
  passes::Regions::Item first_item = 0;
};

struct LayerClip;
struct CutAreas;

/// One sheet layer: which placed layer it draws, and how. `page` is always the planned one.
struct PlanStep {
  std::shared_ptr<const PlacedLayer> placed;
  LayerPart part;
  std::uint64_t piece_seed = 0;
  std::shared_ptr<const std::vector<LayerClip>> clips{};
  bool hidden = false;              ///< what others hide of it, not what is seen
  std::vector<double> dashes_mm{};  ///< cut into its lines before they are cut otherwise; empty: none

  /// Draws every copy, cut by the areas and to the window.
  Flow draw_all(LayerId layer, PathSink& sink, const RunOptions& options, const Page& page,
                const CutAreas& areas) const;
  /// Adds what the step's paths enclose of what its own clips leave.
  void add_areas(passes::Regions& regions, const RunOptions& options, const Page& page, const CutAreas& areas) const;
  /// What one copy adds to a drawing; gives up counting above `enough` points.
  Forecast forecast(const Copy& copy, const LayerRun& run, const RunOptions& options, const Page& page,
                    double enough) const;

 private:
  /// The head of a chain of filters, one for each clip, that ends in `sink`; `filters` holds them.
  PathSink& clipped(PathSink& sink, const CutAreas& areas, std::deque<passes::RegionFilter>& filters) const;
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
};

/// What a layer is cut by: what another one encloses, with all its parts, or an outline in page millimetres.
struct LayerClip {
  passes::Keep keep = passes::Keep::inside;
  std::vector<PlanStep> by{};
  std::vector<Vec2> outline_mm{};
};

/// What layers hide and enclose, in the space of one run.
struct CutAreas {
  passes::Regions hiding;
  std::map<const LayerClip*, passes::Regions> clips;
};

/// What the steps' layers are cut by in a run: all that `hiding` encloses, and their clips.
CutAreas cut_areas(const std::vector<PlanStep>& steps, const std::vector<PlanStep>& hiding, const RunOptions& options,
                   const Page& page);

}  // namespace burin::preset
