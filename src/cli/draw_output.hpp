#pragma once

#include <cstdint>
#include <string>

#include <burin/path/draw_context.hpp>
#include <burin/preset/plan.hpp>
#include <cli/atomic_file.hpp>
#include <cli/draw_request.hpp>

namespace burin::cli {

/// An output that is about to be drawn, or has been.
struct OutputJob {
  std::string path;
  const BackEnd* back_end = nullptr;
  OutputOptions options;
  preset::RunOptions run;
  Forecast forecast;
  Origin origin;
};

/// What a finished output holds.
struct OutputCounts {
  std::uint64_t drawn_points = 0;
  std::uint64_t skipped_points = 0;
  std::uint64_t bytes = 0;
};

/// Replays the plan, which shares its drawing with its copies, into the file and commits it. `live`: shows progress. A
/// problem, or counts of what was drawn before `job.run.stop` ended it: then nothing is committed.
Result<OutputCounts> draw_output(preset::Plan plan, const OutputJob& job, AtomicFile& file, bool live);

}  // namespace burin::cli
