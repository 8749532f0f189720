#include <array>
#include <string>

#include <fmt/format.h>

#include <cli/command.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_request.hpp>
#include <cli/draw_series.hpp>
#include <cli/file_io.hpp>
#include <cli/interrupt.hpp>
#include <cli/series_problems.hpp>
#include <cli/tbb_executor.hpp>

namespace burin::cli {

namespace {

constexpr std::array examples{
    Example{"burin draw koch", "writes koch.svg"},
    Example{"burin draw koch -D levels=3 -o small.svg -o small.csv", "one knob turned; two files, each complete"},
    Example{"burin draw koch -o koch.pdf --page a3 --landscape --margin 30mm", "a print at true size"},
    Example{"burin draw koch -o koch.png --size 1200px", "a picture 1200 dots high"},
    Example{"burin draw dragon --sweep levels=2..6 -o 'dragons/{n}-{levels}.svg'", "five files"},
    Example{"burin draw koch -q -o - --format csv | head -n 3", "into another program"},
};

ExitCode tell(const SeriesOutcome& outcome, const DrawRequest& request, const Console& console) {
  if (request.quiet) return ExitCode::done;
  for (const std::string& warning : outcome.warnings) console.note(warning + '\n');
  if (!outcome.uses_seed) console.note(seed_warning(request));
  if (!request.writes_stdout()) return console.print(outcome.all.report);
  console.note(outcome.all.report);
  return ExitCode::done;
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<DrawRequest> request = read_draw_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin draw");
  const Result<PresetText> preset = read_preset(request->preset);
  if (!preset) return console.fail(preset.problems());
  const Result<Series> series = read_series(*request, *preset);
  if (!series) return console.fail(series.problems());
  const Result<SeriesOutputs> outputs = name_outputs(*request, *series, *preset);
  if (!outputs) return console.fail_usage(outputs.problems(), "burin draw");
  if (!request->quiet) console.note(outputs->note);

  Temporaries temporaries;
  MemoryBudget memory(request->max_memory_mb * 1e6);
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const bool live = console.shows_progress() && !request->quiet;
  const TbbExecutor executor(request->threads);
  const SeriesOutcome outcome = draw_series(*preset, *request, *series, *outputs, executor,
                                            {temporaries, interrupt.stop(), live, &memory, &executor});
  const bool stopped = interrupt.signal() != 0;
  if (!stopped && outcome.all.code == ExitCode::done) return tell(outcome, *request, console);
  const ExitCode code = stopped ? interrupt.exit_code() : tell_problems(outcome.all, request->command, console);
  if (series->count() > 1 && !request->quiet) {
    console.note(fmt::format("{} of {} results are drawn\n", outcome.finished, series->count()));
  }
  return code;
}

}  // namespace

Command draw_command() {
  return {
      "draw",
      "draw a preset into SVG, PDF, PNG or CSV files",
      "PRESET [-o FILE]... [-D NAME=VALUE]... [OPTIONS]",
      "PRESET is the name of a shipped preset ('burin list'), a file, or - for stdin. Without -o the drawing goes "
      "to NAME.svg in the current folder. A file appears when it is complete; until then the old one stays.\n\n"
      "Several seeds and every --sweep make several results, one for each combination. In -o stand {preset}, {seed}, "
      "{n} (a running number) and {KNOB} of a swept knob; {{ is a brace. What tells the results apart is added to a "
      "name that lacks it, and missing folders are made. Where one result fails the others are still drawn.\n\n"
      "Exit codes: 0 done, 2 wrong command line, 3 wrong preset or data, 4 too large, 5 cannot be written; of "
      "several results the code of the first that failed.",
      draw_options(),
      examples,
      &run};
}

}  // namespace burin::cli
