#pragma once

#include <string>
#include <vector>

#include <burin/primitives/primitive.hpp>

namespace burin::cli {

/// A figure that can be called by its name: one that came with burin, or the user's own.
struct LibraryFigure {
  std::string name;
  bool is_own = false;
};

/// The figures that came with burin, then those in the user's own folder, each by name. A figure of the user's with the
/// name of one of burin's is left out, as it cannot be called.
std::vector<LibraryFigure> library_figures();

bool is_library_figure(const std::string& name);

/// The figure of this name, or of a file: relative to the current folder.
Result<primitives::Primitive> read_figure(const std::string& word);

}  // namespace burin::cli
