#include <memory>

#include <burin/output/raster/png.hpp>
#include <burin/path/decorators.hpp>
#include <cli/draw_output.hpp>
#include <cli/draw_run.hpp>
#include <cli/progress.hpp>

namespace burin::cli {

namespace {

std::unique_ptr<OutputSink> open_sink(const OutputJob& job, ByteSink& bytes, const Sheet& sheet) {
  // Of all back ends the rasterizer alone has work for several threads.
  if (job.executor == nullptr || job.back_end->open != output::png_back_end().open) {
    return job.back_end->open(bytes, sheet, job.options);
  }
  output::RasterPlan plan;
  plan.workers = {job.executor, job.executor->workers()};
  return output::open_png(bytes, sheet, job.options, plan);
}

}  // namespace

Result<OutputCounts> draw_output(const OutputJob& job, AtomicFile& file, bool live) {
  Sheet sheet = job.drawing->sheet;
  sheet.made_by = job.origin;
  const std::unique_ptr<OutputSink> sink = open_sink(job, file, sheet);
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
