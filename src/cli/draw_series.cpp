#include <algorithm>
#include <atomic>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <cli/draw_report.hpp>
#include <cli/draw_series.hpp>
#include <cli/file_io.hpp>
#include <cli/series_problems.hpp>
#include <cli/series_progress.hpp>

namespace burin::cli {

namespace {

/// One result, and whether it was begun.
struct Drawn {
  DrawOutcome outcome;
  bool begun = false;
  bool uses_seed = false;
  std::vector<std::string> warnings{};
};

Problems make_folders(const std::vector<RequestedOutput>& outputs) {
  for (const RequestedOutput& output : outputs) {
    const std::filesystem::path folder = std::filesystem::path(output.path).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) return {write_problem(output.path, error.value())};
  }
  return {};
}

}  // namespace

SeriesOutcome draw_series(const PresetText& preset, const DrawRequest& request, const Series& series,
                          const SeriesOutputs& outputs, const Executor& executor, const Surroundings& around) {
  std::vector<Drawn> drawn(series.count());
  std::atomic<bool> cannot_write = false;
  Surroundings each = around;
  each.live = around.live && series.count() == 1;
  // Several results are drawn at a time, each by one thread.
  if (series.count() > 1) each.executor = nullptr;

  const auto draw_one = [&](std::size_t index) -> DrawOutcome {
    DrawRequest one = request;
    one.overrides = series.overrides(index, request.overrides);
    one.outputs = outputs.of_result[index];
    const Result<ReadyPiece> piece = make_ready(preset, one.overrides, data_reader(preset.folder));
    if (!piece) return DrawOutcome::failed(piece.problems());
    drawn[index].uses_seed = piece->plan.uses_seed();
    drawn[index].warnings = piece->read.warnings;
    if (outputs.makes_folders) {
      if (Problems problems = make_folders(one.outputs); !problems.empty()) return DrawOutcome::failed(problems);
    }
    DrawOutcome outcome = draw_piece(*piece, one, each);
    if (series.count() == 1) outcome.report += piece_report(piece->plan, piece->read, request.verbose);
    return outcome;
  };
  {
    SeriesProgress progress(series.count(), around.live && series.count() > 1);
    executor.run(series.count(), [&](std::size_t index) {
      if (around.stop.stop_requested() || cannot_write) return;
      drawn[index].begun = true;
      drawn[index].outcome = draw_one(index);
      if (drawn[index].outcome.code == ExitCode::output) cannot_write = true;
      progress.one_done();
    });
  }

  SeriesOutcome outcome;
  for (const Drawn& one : drawn) {
    if (!one.begun) continue;
    for (const std::string& warning : one.warnings) {
      const bool told = std::find(outcome.warnings.begin(), outcome.warnings.end(), warning) != outcome.warnings.end();
      if (!told) outcome.warnings.push_back(warning);
    }
    if (outcome.all.code == ExitCode::done) outcome.all.code = one.outcome.code;
    outcome.all.report += one.outcome.report;
    outcome.finished += one.outcome.code == ExitCode::done ? 1 : 0;
    outcome.uses_seed = outcome.uses_seed || one.uses_seed;
  }
  std::vector<Problems> problems;
  for (Drawn& one : drawn) problems.push_back(std::move(one.outcome.problems));
  outcome.all.problems = grouped_problems(problems, series);
  return outcome;
}

}  // namespace burin::cli
