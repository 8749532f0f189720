#pragma once

#include <memory>

#include <burin/path/back_end.hpp>

namespace burin::output {

/// The vertices as a table in model units: "layer,path,x,y", one row a vertex, numbers that read back exactly. Every
/// contour is a path of its own; a closed one ends with its first point again. `path` counts from 0 in each layer;
/// sheet layers of the same name count on, so that (layer, path) is unique. Names are quoted as in RFC 4180 where they
/// must be; lines end with "\n". Masks are left out. Looks at no option. Memory O(layers).
std::unique_ptr<OutputSink> open_csv(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options);

}  // namespace burin::output
