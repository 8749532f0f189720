#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include <burin/preset/plan.hpp>
#include <cli/draw_request.hpp>
#include <cli/exit_code.hpp>
#include <cli/memory_budget.hpp>
#include <cli/origin.hpp>
#include <cli/preset_library.hpp>
#include <cli/tbb_executor.hpp>
#include <cli/temporaries.hpp>

/// From a preset's text to finished files. Nothing here prints, but for the progress that `Surroundings` allows, and
/// everything may be called from several threads at once.
namespace burin::cli {

/// A preset that has been read, checked and fitted to its page.
struct ReadyPiece {
  PresetText preset;
  ReadPiece read;
  preset::Plan plan;
};

/// Reads and plans. Every problem has the line of the preset it points to.
Result<ReadyPiece> make_ready(PresetText preset, const preset::Overrides& overrides, const ReadFile& read_file);

/// What a drawing shares with all others of this run of the tool.
struct Surroundings {
  Temporaries& temporaries;
  std::stop_token stop;
  bool live = false;                      ///< show on stderr how far it is
  MemoryBudget* memory = nullptr;         ///< what drawings that go on at once share; null: each is alone
  const TbbExecutor* executor = nullptr;  ///< for what is large enough within a drawing; null: this thread does it
};

/// How a drawing ended.
struct DrawOutcome {
  ExitCode code = ExitCode::done;  ///< `interrupted`, without problems, after a stop
  Problems problems{};             ///< also none when a pipe lost its reader
  std::string report{};            ///< a line for each output that was finished

  static DrawOutcome failed(Problems problems);
  /// A wrong command line.
  static DrawOutcome misused(Problems problems) { return {ExitCode::usage, std::move(problems)}; }
};

/// Something that can be drawn again and again: a piece, or a sheet of many.
struct Drawing {
  std::string stem;  ///< its file is called so when no name is given
  Sheet sheet;
  /// What a run will emit; a problem when that is more than `max_points`.
  std::function<Result<Forecast>(const preset::RunOptions& options, double max_points)> check_size;
  std::function<Flow(PathSink& sink, const preset::RunOptions& options)> run;
  std::function<Origin(const BackEnd& back_end)> origin;
};

/// What is drawn in a format. The drawing must live until all is written.
using DrawingFor = std::function<const Drawing&(const BackEnd& back_end)>;

/// Draws every output that the request asks for. All are checked and opened before the first is drawn; after a problem
/// those that are finished stay, and of the others no trace is left.
DrawOutcome draw_outputs(const DrawingFor& drawing_for, const DrawRequest& request, const Surroundings& around);

/// The same of one piece.
DrawOutcome draw_piece(const ReadyPiece& piece, const DrawRequest& request, const Surroundings& around);

}  // namespace burin::cli
