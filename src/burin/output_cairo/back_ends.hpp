#pragma once

#include <span>

#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// Cairo's back ends: pdf, png and svg.
std::span<const BackEnd> back_ends();

}  // namespace burin::output_cairo

/// The same for programs that load this library only when they need it: sets `rows`.
extern "C" void burin_cairo_back_ends(std::span<const burin::BackEnd>& rows);
