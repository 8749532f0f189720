#include <algorithm>

#include <burin/base/random.hpp>
#include <burin/preset/layer_facts.hpp>

namespace burin::preset {

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

Paint fill_of(const LayerStyle& style) {
  return style.rule == FillRule::evenodd ? Paint::fill_evenodd : Paint::fill_nonzero;
}

bool uses_seed(const Layer& layer) {
  const auto by_chance = [&](const std::any& parameters) { return layer.family->uses_seed(parameters); };
  const primitives::PositionUse pens = layer.style.pen.used();
  return by_chance(layer.parameters) || std::ranges::any_of(layer.coarser, by_chance) ||
         pens[primitives::position_variable("rand")] || pens[primitives::position_variable("random")] ||
         (layer.style.primitives && primitives::uses_chance(*layer.style.primitives));
}

}  // namespace burin::preset
