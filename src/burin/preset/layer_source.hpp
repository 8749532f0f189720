#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// The keys of which a layer has one: what it draws.
std::vector<std::string_view> source_keys();

/// Reads the source of the layer called `name`: its family and the parameters of each level. `defines` may be null. A
/// `piece` stands for several layers and is left to `read_nested_piece`.
void read_source(const params::Table& table, const std::string& name, const params::Table* defines, Layer& layer,
                 params::ReadContext& context);

}  // namespace burin::preset
