#pragma once

#include <string>

#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// The operators that set a layer's whole style: width, ends, corners, dashes and colour, in units of `unit_mm`.
std::string layer_style(const Sheet& sheet, std::size_t layer, double unit_mm);

/// Its lengths alone, for another unit.
std::string stroke_lengths(const Sheet& sheet, std::size_t layer, double unit_mm);

/// Whether a layer's lines are dashed: with no length at all, they are full.
bool is_dashed(const SheetLayer& layer);

}  // namespace burin::output::pdf
