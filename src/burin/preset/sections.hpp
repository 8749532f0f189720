#pragma once

#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/palettes.hpp>
#include <burin/preset/piece.hpp>

/// The parts of a preset that stand before its layers. Each reader reports what is wrong and gives back the rest.
namespace burin::preset {

About read_about(const params::Table& root, params::ReadContext& context);

/// With landscape the size is turned already: wider than high. Margins that leave nothing of the page are reported, at
/// `file` if nobody wrote them.
/// The paper's colour is the palette's unless it is written.
PageSpec read_page(const params::Table& root, const Where& file, const Palette* palette, params::ReadContext& context);

/// The page that --enlarge names.
PageSize read_enlarge(const std::string& size, params::ReadContext& context);

/// In file order. When there are none: the palette's three of 0.3 mm or, without palette, a black one called "ink".
/// Pens called like an ink of the palette have its colour unless one is written.
std::vector<NamedPen> read_pens(const params::Table& root, const Palette* palette, params::ReadContext& context);

/// In file order.
std::vector<NamedSlot> read_slots(const params::Table& root, params::ReadContext& context);

}  // namespace burin::preset
