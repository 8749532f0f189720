#pragma once

#include <span>
#include <stdexcept>

#include <burin/path/back_end.hpp>

namespace burin::cli {

/// A part of the tool that was not installed with it.
struct MissingLibrary final : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Cairo's back ends; none in a build without. Its library, and two dozen that it needs, take as long to load as a
/// small drawing takes to draw: this loads them, where the tool is not linked with it. Throws MissingLibrary when it
/// is not there.
std::span<const BackEnd> cairo_back_ends();

}  // namespace burin::cli
