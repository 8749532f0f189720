#pragma once

#include <string>
#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/images.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// Reads [[layer]], of which there must be one, into the piece; `file` is where that is reported. Pens and slots must
/// be those of the piece, which gets the pens of gradients too. Pre: `layer_names`, one for each layer.
void read_layers(const params::Table& root, const std::vector<std::string>& names, const Where& file,
                 const std::vector<NamedImage>& images, Piece& piece, params::ReadContext& context);

}  // namespace burin::preset
