#pragma once

#include <any>
#include <string>
#include <utility>
#include <vector>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>
#include <burin/curves/family.hpp>

namespace burin::preset {

/// Parameters of a family from pairs of name and value, written as in a preset ("1/16" and "square" need no quotes
/// here); the others have their defaults. `read_file` reads data files.
Result<std::any> family_parameters(const curves::Family& family,
                                   const std::vector<std::pair<std::string, std::string>>& values,
                                   const ReadFile& read_file);

}  // namespace burin::preset
