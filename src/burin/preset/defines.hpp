#pragma once

#include <burin/params/value.hpp>
#include <burin/preset/findings.hpp>

namespace burin::preset {

/// Merges [define]: a table with `like = "name"` gets the keys of that define, beneath its own and without going
/// deeper. Chains are followed; cycles, unknown names, chains longer than 64 and trees that grow beyond 100,000 values
/// are reported.
void resolve_likes(params::Table& root, Findings& findings);

}  // namespace burin::preset
