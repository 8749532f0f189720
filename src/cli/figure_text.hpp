#pragma once

#include <string>

#include <burin/primitives/primitive.hpp>
#include <cli/console.hpp>

namespace burin::cli {

/// What `burin show leaf` says: title, family, who drew it, size, paths and points.
std::string figure_text(const primitives::Primitive& figure);

/// `burin show leaf -o FILE`: draws a figure large on a page, in the format of the file's suffix.
ExitCode write_figure_file(const primitives::Primitive& figure, const std::string& path, const Console& console);

}  // namespace burin::cli
