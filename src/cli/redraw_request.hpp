#pragma once

#include <span>
#include <string>

#include <burin/base/result.hpp>
#include <cli/draw_request.hpp>
#include <cli/options.hpp>
#include <cli/recover/recovered.hpp>

namespace burin::cli {

/// The options of `burin redraw`: those of `burin draw` that may be changed afterwards, and its own.
std::span<const OptionRow> redraw_options();

/// What `burin draw` was asked for when it drew `file`, with the options typed now in place of those recorded: -D and
/// --set are added to them, all others replace theirs. Choices of a format are taken over where an output has that
/// format. Without -o the output is NAME-redrawn in the current folder, in the format of the file.
Result<DrawRequest> redraw_request(const Recovered& recovered, const Arguments& typed, const std::string& file);

}  // namespace burin::cli
