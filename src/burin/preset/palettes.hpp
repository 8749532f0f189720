#pragma once

#include <span>
#include <string_view>

#include <burin/params/read_context.hpp>
#include <burin/path/colour.hpp>

namespace burin::preset {

/// Colours that go together: a paper and three inks of a piece.
struct Palette {
  std::string_view name;
  std::string_view summary;
  Colour paper;
  Colour ink;     ///< lines; at least 7:1 on the paper
  Colour accent;  ///< one place
  Colour soft;    ///< what recedes
};

std::span<const Palette> palettes();

/// The palette of this name, or null.
const Palette* find_palette(std::string_view name);

/// The ink that a pen of this name draws with: "ink", "accent" or "soft"; null for other names.
const Colour* ink_of(const Palette& palette, std::string_view pen);

/// What a preset's `palette` names; null when it has none or, which is reported, an unknown one.
const Palette* read_palette(const params::Table& root, params::ReadContext& context);

}  // namespace burin::preset
