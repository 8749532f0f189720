#pragma once

#include <span>
#include <string>
#include <vector>

#include <burin/base/result.hpp>
#include <cli/draw_request.hpp>
#include <cli/options.hpp>

/// The options of commands that draw one result, as `burin draw` has them.
namespace burin::cli {

/// Those of `burin draw` but for the ones about several results, then a command's own.
std::vector<OptionRow> single_options(std::span<const OptionRow> own);

/// Reads them; several seeds are a problem.
Result<DrawRequest> read_single_request(const Arguments& arguments, const std::string& command,
                                        const PreferredBackEnd& preferred = {});

}  // namespace burin::cli
