#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/palettes.hpp>

namespace burin::preset {

namespace {

constexpr Colour rgb(unsigned hex) {
  return {static_cast<std::uint8_t>(hex >> 16U), static_cast<std::uint8_t>(hex >> 8U & 0xFFU),
          static_cast<std::uint8_t>(hex & 0xFFU)};
}

/// Paper, ink, accent, soft.
constexpr std::array table{
    Palette{"harbour", "navy and rust on oat", rgb(0xF2EDE2), rgb(0x1F2D3D), rgb(0xC2502E), rgb(0x7C98A8)},
    Palette{"orchard", "bottle green and apple red on cream", rgb(0xF6F1E4), rgb(0x26382B), rgb(0xB23A2E),
            rgb(0x93A268)},
    Palette{"dusk", "violet and rose on chalk", rgb(0xF5F0EE), rgb(0x2B2440), rgb(0xC9415A), rgb(0x9A93B3)},
    Palette{"ochre", "sepia and ochre on parchment", rgb(0xF4ECD8), rgb(0x33261D), rgb(0xB86E14), rgb(0xA8916F)},
    Palette{"frost", "ink blue and ice on mist", rgb(0xF1F4F5), rgb(0x14313F), rgb(0x2F7F9E), rgb(0x9DB6BF)},
    Palette{"moss", "forest and lichen on bone", rgb(0xF0F0E4), rgb(0x23301F), rgb(0x6F8A1E), rgb(0x9DAE93)},
    Palette{"plum", "plum and magenta on porcelain", rgb(0xF5F1EF), rgb(0x3A1F33), rgb(0xA23B72), rgb(0xB99AA9)},
    Palette{"night", "chalk and amber on blue-black", rgb(0x10151C), rgb(0xF0EAD8), rgb(0xE0A458), rgb(0x5F7A92)},
};

}  // namespace

std::span<const Palette> palettes() {
  return table;
}

const Palette* find_palette(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Palette::name);
  return found == table.end() ? nullptr : &*found;
}

const Colour* ink_of(const Palette& palette, std::string_view pen) {
  if (pen == "ink") return &palette.ink;
  if (pen == "accent") return &palette.accent;
  return pen == "soft" ? &palette.soft : nullptr;
}

const Palette* read_palette(const params::Table& root, params::ReadContext& context) {
  const params::Value* value = root.find("palette");
  if (value == nullptr) return nullptr;
  const Palette* found = value->text() == nullptr ? nullptr : find_palette(*value->text());
  if (found == nullptr) {
    std::vector<std::string_view> names;
    for (const Palette& palette : table) names.push_back(palette.name);
    const std::string written = value->text() == nullptr ? std::string(value->kind_name()) : *value->text();
    context.report(value->where, fmt::format("no palette '{}'{}", written, suggestion(written, names)));
  }
  return found;
}

}  // namespace burin::preset
