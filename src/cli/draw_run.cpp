#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <cli/draw_output.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_run.hpp>

namespace burin::cli {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A layer that --only or --skip names and the piece lacks.
Problems unknown_layers(const Sheet& sheet, const DrawRequest& request) {
  std::vector<std::string_view> names;
  for (const SheetLayer& layer : sheet.layers) {
    if (std::find(names.begin(), names.end(), layer.name) == names.end()) names.push_back(layer.name);
  }
  Problems problems;
  for (const auto& [option, wanted] : {std::pair("--only", request.only), std::pair("--skip", request.skip)}) {
    for (const std::string& name : wanted) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      problems.push_back(
          {{request.command}, fmt::format("{}: there is no layer '{}'{}", option, name, suggestion(name, names))});
    }
  }
  return problems;
}

/// Fewer are drawn by one thread before others have begun.
constexpr double points_worth_threads = 4e5;

/// Every output with all that is known before it is opened.
Result<std::vector<OutputJob>> make_jobs(const DrawingFor& drawing_for, const DrawRequest& request,
                                         const Surroundings& around) {
  std::vector<OutputJob> jobs;
  for (const RequestedOutput& output : request.outputs) {
    const Drawing& drawing = drawing_for(*output.back_end);
    const Sheet& sheet = drawing.sheet;
    OutputJob job;
    job.drawing = &drawing;
    job.back_end = output.back_end;
    job.path = output.path.empty() ? fmt::format("{}.{}", drawing.stem, output.back_end->format) : output.path;
    job.options = output_options(request, sheet.page);
    if (Result<Done> accepted = job.back_end->accepts(sheet, job.options); !accepted) return accepted.problems();
    const bool every_point = request.all_points || job.back_end->space == Space::model;
    job.run.space = job.back_end->space;
    job.run.tolerance_mm = every_point ? 0.0 : job.back_end->tolerance_mm(sheet, job.options);
    job.run.wanted = [&request](const SheetLayer& layer) {
      return (request.only.empty() || contains(request.only, layer.name)) && !contains(request.skip, layer.name);
    };
    job.run.window = request.view;
    job.run.stop = around.stop;
    const Result<Forecast> forecast = drawing.check_size(job.run, request.max_points);
    if (!forecast) return forecast.problems();
    const Result<Done> fits = check_memory(*job.back_end, *forecast, sheet, job.options, request.max_memory_mb * 1e6);
    if (!fits) return fits.problems();
    job.forecast = *forecast;
    if (forecast->points >= points_worth_threads) job.executor = around.executor;
    job.origin = drawing.origin(*job.back_end);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

/// Opens every output before the first is drawn, so that a folder that cannot be written to costs no time.
Result<std::vector<std::unique_ptr<AtomicFile>>> open_files(const std::vector<OutputJob>& jobs,
                                                            const Surroundings& around) {
  std::vector<std::unique_ptr<AtomicFile>> files;
  Problems problems;
  for (const OutputJob& job : jobs) {
    Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(job.path, around.temporaries, around.stop);
    if (file) {
      files.push_back(*std::move(file));
    } else {
      problems.insert(problems.end(), file.problems().begin(), file.problems().end());
    }
  }
  if (!problems.empty()) return problems;
  return files;
}

}  // namespace

DrawOutcome DrawOutcome::failed(Problems problems) {
  const ExitCode code = exit_code(problems);
  return {code, std::move(problems)};
}

Result<ReadyPiece> make_ready(PresetText preset, const preset::Overrides& overrides, const ReadFile& read_file) {
  Result<preset::Piece> piece = preset::load(preset.source, overrides, read_file);
  if (!piece) return piece.problems();
  ReadPiece read{piece->about, piece->seed, piece->data, piece->warnings};
  Result<preset::Plan> plan = preset::Plan::make(*std::move(piece));
  if (!plan) return with_source(plan.problems(), preset);
  return ReadyPiece{std::move(preset), std::move(read), *std::move(plan)};
}

DrawOutcome draw_outputs(const DrawingFor& drawing_for, const DrawRequest& request, const Surroundings& around) {
  for (const RequestedOutput& output : request.outputs) {
    Problems unknown = unknown_layers(drawing_for(*output.back_end).sheet, request);
    if (!unknown.empty()) return DrawOutcome::misused(std::move(unknown));
  }
  const Result<std::vector<OutputJob>> jobs = make_jobs(drawing_for, request, around);
  if (!jobs) return DrawOutcome::failed(jobs.problems());
  const Result<std::vector<std::unique_ptr<AtomicFile>>> files = open_files(*jobs, around);
  if (around.stop.stop_requested()) return {ExitCode::interrupted};
  if (!files) return DrawOutcome::failed(files.problems());

  DrawOutcome outcome;
  for (std::size_t i = 0; i < jobs->size(); ++i) {
    const OutputJob& job = (*jobs)[i];
    AtomicFile& file = *(*files)[i];
    if (job.back_end->binary && file.is_terminal()) {
      const std::string advice = fmt::format("{} is not for terminals; write a file (-o NAME.{}) or a pipe",
                                             job.back_end->format, job.back_end->format);
      return DrawOutcome::misused({Problem{{request.command}, advice}});
    }
    const double memory_bytes = job.back_end->memory_bytes(job.forecast.points, job.drawing->sheet, job.options);
    const MemoryBudget::Share share(around.memory, memory_bytes);
    const Result<OutputCounts> counts = draw_output(job, file, around.live);
    if (around.stop.stop_requested()) return {ExitCode::interrupted};
    if (!counts && file.lost_reader()) return {ExitCode::output};
    if (!counts) return DrawOutcome::failed(counts.problems());
    outcome.report += output_report(job, *counts);
  }
  return outcome;
}

DrawOutcome draw_piece(const ReadyPiece& piece, const DrawRequest& request, const Surroundings& around) {
  const preset::Plan& plan = piece.plan;
  const Drawing drawing{
      .stem = piece.preset.stem,
      .sheet = plan.sheet(),
      .check_size = [&](const auto& options, double max_points) { return plan.check_size(options, max_points); },
      .run = [&](PathSink& sink, const auto& options) { return plan.run(sink, options); },
      .origin = [&](const BackEnd& back_end) { return make_origin(request, back_end, piece.preset, piece.read); }};
  DrawOutcome outcome = draw_outputs([&](const BackEnd&) -> const Drawing& { return drawing; }, request, around);
  outcome.problems = with_source(std::move(outcome.problems), piece.preset);
  return outcome;
}

}  // namespace burin::cli
