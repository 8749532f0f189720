#pragma once

#include <string>
#include <vector>

#include <cli/draw_request.hpp>
#include <cli/preset_library.hpp>
#include <cli/series.hpp>

namespace burin::cli {

/// Where the results of a series go.
struct SeriesOutputs {
  /// For each result the outputs of the request, their placeholders filled in.
  std::vector<std::vector<RequestedOutput>> of_result;
  bool makes_folders = false;  ///< several results make the folders that their names ask for
  std::string note{};          ///< what was added to names so that results differ; ends lines
};

/// Fills in {preset}, {seed}, {n} (from 1, with leading zeros) and the swept knobs. Several results whose pattern does
/// not tell them apart get their values added before the suffix. Problems: stdout for several results, an unknown
/// placeholder, two results in one file.
Result<SeriesOutputs> name_outputs(const DrawRequest& request, const Series& series, const PresetText& preset);

}  // namespace burin::cli
