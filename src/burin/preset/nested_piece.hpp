#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/params/fields.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// What the names of the library's files begin with where a ReadFile is asked for them.
inline constexpr std::string_view library_prefix = "burin:presets/";

/// Another preset as the source of a layer.
struct NestedPieceSpec {
  std::string file;
  std::optional<params::Value> knobs;
  std::optional<std::int64_t> seed;

  static constexpr auto fields() {
    return std::tuple{
        params::field("file", &NestedPieceSpec::file, "the preset: a file beside this one, or a name of the library"),
        params::field("knobs", &NestedPieceSpec::knobs, "{ NAME = VALUE }: its knobs, as -D turns them"),
        params::field("seed", &NestedPieceSpec::seed, params::not_negative, "its seed; unset: as it says itself")};
  }
};

/// What takes the place of a layer whose source is a preset.
struct NestedLayers {
  std::vector<Layer> layers;   ///< one for each sheet layer of the preset, in its order, all in the layer's slot
  std::vector<NamedPen> pens;  ///< those that the piece has not
};

/// Reads `piece = "koch"` or `piece = { file = "koch", knobs = { levels = 3 } }` of a layer; nothing after reporting.
/// The page of that preset, in millimetres and y up, is what the layers draw. `keeps_pen`: the layer names a pen, which
/// then draws all lines; else the preset's pens come along. Files the preset reads are found beside it.
std::optional<NestedLayers> read_nested_piece(const params::Value& value, const Layer& layer, bool keeps_pen,
                                              const std::vector<NamedPen>& pens, params::ReadContext& context);

}  // namespace burin::preset
