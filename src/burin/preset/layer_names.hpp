#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <burin/params/read_context.hpp>

namespace burin::preset {

/// The text at a key of a table; null when there is no table, no such key or no text.
const std::string* text_at(const params::Table* table, std::string_view key);

/// What the layers of a preset are called: as they say, or like their curves: by the define's name or the family's,
/// numbered when that is taken ("flake", "flake 2"). To be asked before `like` is resolved, which forgets the names.
std::vector<std::string> layer_names(const params::Array& layers);

/// Reports layers that are given a name that another one has.
void check_layer_names(const params::Array& layers, params::ReadContext& context);

}  // namespace burin::preset
