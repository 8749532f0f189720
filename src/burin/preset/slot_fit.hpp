#pragma once

#include <string>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/preset/piece.hpp>
#include <burin/preset/slot_layout.hpp>

namespace burin::preset {

/// A slot with every copy of what it holds, shared by its layers.
struct FittedSlot {
  SlotFrame frame;
  std::vector<Copy> copies;
};

/// Fits what the layers of a slot draw into it, pens and placed figures included. A problem: a slot without ink to fit,
/// a curve that leaves the range of numbers. Pre: a layer draws in this slot.
///
/// Figures keep their size in millimetres whatever the scale, so that one is found by steps, each of which runs through
/// their curves; it leaves them within a ten thousandth of a millimetre of where they fit. Figures that stand so many
/// millimetres apart come and go with the scale: what they draw may be a few millimetres smaller than the slot.
Result<FittedSlot> fit_slot(const Piece& piece, const std::string& name);

}  // namespace burin::preset
