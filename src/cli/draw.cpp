#include <array>
#include <string>

#include <cli/command.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_request.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/interrupt.hpp>

namespace burin::cli {

namespace {

constexpr std::array examples{
    Example{"burin draw koch", "writes koch.svg"},
    Example{"burin draw koch -D levels=3 -o small.svg -o small.csv", "one knob turned; two files, each complete"},
    Example{"burin draw koch -o koch.pdf --page a3 --landscape --margin 30mm", "a print at true size"},
    Example{"burin draw koch -o koch.png --size 1200px", "a picture 1200 dots high"},
    Example{"burin draw koch -q -o - --format csv | head -n 3", "into another program"},
};

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<DrawRequest> request = read_draw_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin draw");
  const Result<PresetText> preset = read_preset(request->preset);
  if (!preset) return console.fail(preset.problems());
  const Result<ReadyPiece> piece = make_ready(*preset, request->overrides, data_reader(preset->folder));
  if (!piece) return console.fail(piece.problems());

  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const bool live = console.shows_progress() && !request->quiet;
  const DrawOutcome outcome = draw_piece(*piece, *request, {temporaries, interrupt.stop(), live});
  if (interrupt.signal() != 0) return interrupt.exit_code();
  if (outcome.code != ExitCode::done) return tell_problems(outcome, request->command, console);
  if (request->quiet) return ExitCode::done;
  const std::string report = outcome.report + piece_report(piece->plan, piece->read, request->verbose);
  if (!request->writes_stdout()) return console.print(report);
  console.note(report);
  return ExitCode::done;
}

}  // namespace

Command draw_command() {
  return {"draw",
          "draw a preset into SVG, PDF, PNG or CSV files",
          "PRESET [-o FILE]... [-D NAME=VALUE]... [OPTIONS]",
          "PRESET is the name of a shipped preset ('burin list'), a file, or - for stdin. Without -o the drawing goes "
          "to NAME.svg in the current folder. A file appears when it is complete; until then the old one stays.\n\n"
          "Exit codes: 0 done, 2 wrong command line, 3 wrong preset or data, 4 too large, 5 cannot be written.",
          draw_options(),
          examples,
          &run};
}

}  // namespace burin::cli
