#pragma once

#include <cstdint>
#include <string>

#include <burin/path/draw_context.hpp>
#include <burin/preset/plan.hpp>
#include <cli/atomic_file.hpp>
#include <cli/draw_request.hpp>
#include <cli/tbb_executor.hpp>

namespace burin::cli {

struct Drawing;

/// An output that is about to be drawn, or has been.
struct OutputJob {
  const Drawing* drawing = nullptr;
  std::string path;
  const BackEnd* back_end = nullptr;
  OutputOptions options;
  preset::RunOptions run;
  Forecast forecast;
  Origin origin;
  const TbbExecutor* executor = nullptr;  ///< null: there is no work for several threads
};

/// What a finished output holds.
struct OutputCounts {
  std::uint64_t drawn_points = 0;
  std::uint64_t skipped_points = 0;
  std::uint64_t bytes = 0;
};

/// Draws the job into the file and commits it. `live`: shows progress. A problem, or counts of what was drawn before
/// `job.run.stop` ended it: then nothing is committed.
Result<OutputCounts> draw_output(const OutputJob& job, AtomicFile& file, bool live);

}  // namespace burin::cli
