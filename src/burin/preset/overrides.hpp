#pragma once

#include <array>
#include <string_view>

#include <burin/params/value.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/load.hpp>

namespace burin::preset {

/// Every key at the top of a preset, in the order they are usually written.
inline constexpr std::array<std::string_view, 11> top_level_keys{
    "burin", "seed", "about", "page", "knobs", "palette", "pens", "images", "define", "slots", "layer"};

/// Writes page size, landscape, margin and `--set` keys into the tree, as if they stood in the file; their values are
/// placed at the option. Knobs and the seed are left to their readers. A layer is found by its name or its number from
/// 1; what is named (pens, slots, layers, knobs, defines) must be there already.
void apply_overrides(params::Table& root, const Overrides& overrides, Findings& findings);

}  // namespace burin::preset
