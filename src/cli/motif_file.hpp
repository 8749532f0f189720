#pragma once

#include <string>

#include <cli/console.hpp>

namespace burin::cli {

/// `burin show NAME --motif -o FILE`: draws the motifs of a preset's two-point curves, or the motif of this name, large
/// on a page, in the format of the file's suffix.
ExitCode write_motif_file(const std::string& name, const std::string& path, const Console& console);

}  // namespace burin::cli
