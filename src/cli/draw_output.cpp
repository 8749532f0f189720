#include <memory>

#include <burin/path/decorators.hpp>
#include <cli/draw_output.hpp>
#include <cli/draw_run.hpp>
#include <cli/progress.hpp>

namespace burin::cli {

Result<OutputCounts> draw_output(const OutputJob& job, AtomicFile& file, bool live) {
  Sheet sheet = job.drawing->sheet;
  sheet.made_by = job.origin;
  const std::unique_ptr<OutputSink> sink = job.back_end->open(file, sheet, job.options);
  Counted counted(*sink);
  {
    Progress progress(counted, live && !file.is_terminal(), job.path, job.forecast.points);
    // A sink that cannot write ends the run too; its reason is the file's, and finish() or commit() tells it.
    const auto run = [&](const preset::RunOptions& options) { return job.drawing->run(progress, options); };
    static_cast<void>(preset::run_for(*sink, run, job.run));
  }
  if (!job.run.stop.stop_requested() && !file.failed()) {
    if (const Result<Done> finished = sink->finish(); !finished && !file.failed()) return finished.problems();
  }
  const OutputCounts counts{counted.point_count(), sink->skipped_points(), file.byte_count()};
  if (job.run.stop.stop_requested()) return counts;
  if (const Result<Done> committed = file.commit(); !committed) return committed.problems();
  return counts;
}

}  // namespace burin::cli
