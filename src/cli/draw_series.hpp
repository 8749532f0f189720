#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <burin/base/executor.hpp>
#include <cli/draw_run.hpp>
#include <cli/series_outputs.hpp>

namespace burin::cli {

/// How the results of a series ended.
struct SeriesOutcome {
  DrawOutcome all;                      ///< code of the first result, by number, that failed; problems of all of them
  std::size_t finished = 0;             ///< results whose files are complete
  bool uses_seed = false;               ///< whether another seed changes one of them
  std::vector<std::string> warnings{};  ///< of all of them, each once
};

/// Draws every result of the series into its outputs. Each stands for itself: where one fails the others are still
/// drawn, until a file cannot be written or a stop is requested; then no further one is begun. Files, report and
/// problems do not depend on the executor when all goes well.
SeriesOutcome draw_series(const PresetText& preset, const DrawRequest& request, const Series& series,
                          const SeriesOutputs& outputs, const Executor& executor, const Surroundings& around);

}  // namespace burin::cli
