#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <burin/base/problem.hpp>

namespace burin::preset {

/// What must not reach toml++: texts above `most_bytes`, bytes that are no UTF-8 text, control characters, runs
/// of more than 64 dotted keys (its recursion over them has no limit) and brackets that, with the dots of their keys,
/// are more than 64 deep. Nothing when the text may be parsed. O(length).
std::optional<Problem> guard_toml(std::string_view text, const std::string& file, std::size_t most_bytes);

}  // namespace burin::preset
