#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <burin/passes/regions.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/preset/piece.hpp>
#include <burin/preset/slot_layout.hpp>

namespace burin::preset {

/// What one sheet layer shows of a preset's layer.
struct LayerPart {
  Paint paint = Paint::stroke;
  std::optional<std::size_t> pen{};  ///< of the layer's pens; nothing: what all of them draw
  std::vector<std::size_t> levels;   ///< of the layer's, in order
};

/// Everything, as strokes or filled.
LayerPart whole_layer(const Layer& layer, Paint paint = Paint::stroke);
/// What one pen of the layer draws.
LayerPart pen_part(const Layer& layer, std::size_t pen);

/// How many items a copy of the layer has at most: numbers for the next copy begin there.
passes::Regions::Item items_of_copy(const Layer& layer);

/// How a copy lies, for expressions over the place.
primitives::Setting setting_of(const SlotFrame& frame, const Copy& copy, const DrawContext& context);

/// A part of a layer while it is drawn: with expressions of its own, for threads do not share them. A view must not cut
/// what figures are put along (`needs_every_point`).
class LayerRun {
 public:
  /// `layer` and `part` must outlive this.
  LayerRun(const Layer& layer, const LayerPart& part);

  /// Draws the part in model units. `item` numbers what is drawn, a path or a place for a figure each: while one
  /// passes, it is that one's number, the same for every part of the layer, and higher the later it comes. `overflowed`
  /// is set when `distinct` or `apart` could not remember all places.
  Flow draw(const primitives::Setting& setting, const DrawContext& context, PathSink& sink, passes::Regions::Item& item,
            bool* overflowed = nullptr);

  /// What draw will emit, with the other pens of the layer where places are shared out among them; gives up counting
  /// above `enough`.
  Forecast forecast(const primitives::Setting& setting, const DrawContext& context, double enough) const;

 private:
  Flow draw_levels(const DrawContext& context, PathSink& sink, passes::Regions::Item& item,
                   primitives::Placing* placing);
  Forecast forecast_curve(const DrawContext& context, double enough) const;
  Forecast count_figures(const primitives::Setting& setting, const DrawContext& context, double asked,
                         double enough) const;

  const Layer& layer_;
  const LayerPart& part_;
  PenChoice pens_;
  std::optional<primitives::PlacingSpec> placing_;
  primitives::Figures figures_;
};

/// Whether no view may leave out points of this layer's curve.
inline bool needs_every_point(const Layer& layer) {
  return layer.style.primitives.has_value();
}

}  // namespace burin::preset
