#pragma once

#include <string_view>
#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// What the layers of a preset may name.
struct KnownNames {
  std::vector<std::string_view> pens;
  std::vector<std::string_view> slots;
  std::vector<std::string_view> layers;
  std::vector<std::string_view> clips;  ///< the layers by which others are clipped
};

/// Reports what in a layer's style cannot be: names that nothing has, a layer that would draw nothing, dashes without
/// length. `table` is what the style was read from, `where` the layer's place.
void check_style(const params::Table& table, const LayerStyle& style, const Where& where, const KnownNames& known,
                 params::ReadContext& context);

}  // namespace burin::preset
