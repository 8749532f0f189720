#pragma once

#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/piece.hpp>

/// The parts of a preset that stand before its layers. Each reader reports what is wrong and gives back the rest.
namespace burin::preset {

About read_about(const params::Table& root, params::ReadContext& context);

/// With landscape the size is turned already: wider than high. Margins that leave nothing of the page are reported, at
/// `file` if nobody wrote them.
PageSpec read_page(const params::Table& root, const Where& file, params::ReadContext& context);

/// The page that --enlarge names.
PageSize read_enlarge(const std::string& size, params::ReadContext& context);

/// In file order; a single black one of 0.3 mm called "ink" when there are none.
std::vector<NamedPen> read_pens(const params::Table& root, params::ReadContext& context);

/// In file order.
std::vector<NamedSlot> read_slots(const params::Table& root, params::ReadContext& context);

}  // namespace burin::preset
