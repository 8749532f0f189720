#pragma once

#include <span>

#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// Cairo's back ends: pdf, png and svg.
std::span<const BackEnd> back_ends();

}  // namespace burin::output_cairo
