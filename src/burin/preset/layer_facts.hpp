#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <burin/preset/piece.hpp>

/// Small facts about a piece's layers that its planning asks for.
namespace burin::preset {

/// The seed of what a layer draws in a cell of its slot: symmetric copies of one cell are alike.
std::uint64_t layer_seed(const Layer& layer, std::uint64_t piece_seed, int cell);

/// The slot of this name; the live area for none.
const SlotSpec& slot_called(const Piece& piece, const std::string& name);

/// Its index in piece.pens.
std::size_t pen_index(const Piece& piece, const std::string& name);

/// How far a layer's lines reach to their sides.
double half_widest_pen_mm(const Piece& piece, const Layer& layer);

/// The paint of its areas.
Paint fill_of(const LayerStyle& style);

/// Whether another seed gives another drawing.
bool uses_seed(const Layer& layer);

}  // namespace burin::preset
