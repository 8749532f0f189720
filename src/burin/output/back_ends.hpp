#pragma once

#include <span>

#include <burin/path/back_end.hpp>

namespace burin::output {

/// The back ends of the core, in the order of preference: native svg, pdf, png, csv, dump.
std::span<const BackEnd> back_ends();

}  // namespace burin::output
