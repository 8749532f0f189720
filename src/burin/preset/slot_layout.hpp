#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/geom/affine2.hpp>
#include <burin/geom/box2.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// A slot's rectangle on the page. Slot space: millimetres from its centre, y up.
struct SlotFrame {
  Vec2 centre_mm;  ///< on the page, y down
  double width_mm = 0.0;
  double height_mm = 0.0;

  Affine2 page_from_slot() const { return {1.0, 0.0, 0.0, -1.0, centre_mm.x, centre_mm.y}; }
};

/// The rectangle of a slot on this page. The live area is the page without its margins.
SlotFrame slot_frame(const PageSpec& page, const SlotSpec& slot);

/// One copy of what a slot holds.
struct Copy {
  Affine2 slot_from_model;
  Affine2 model_from_model;    ///< the copy's symmetry alone, for output in model units
  Affine2 upright_from_model;  ///< what ContentBox was asked for
  int column = 0;              ///< of the grid
  int row = 0;
  int index = 0;  ///< over all copies
  int cell = 0;   ///< of the grid, row by row: copies of one cell share their randomness
};

/// The box of map(everything in the slot) as drawn in this grid cell; nothing when it cannot be had.
using ContentBox = std::function<std::optional<Box2>(const Affine2& map, int cell)>;

/// Fits the content into the slot: one scale and one alignment for all copies. `inset_mm` is kept free on every side,
/// for the width of the pens. A problem (without position) when the content has no box or the copies are too many.
Result<std::vector<Copy>> lay_out(const SlotSpec& slot, const SlotFrame& frame, double inset_mm,
                                  const ContentBox& content_box);

}  // namespace burin::preset
