#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <burin/base/number_text.hpp>
#include <cli/command.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/file_watch.hpp>
#include <cli/interrupt.hpp>
#include <cli/single_request.hpp>

namespace burin::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array examples{
    Example{"burin watch koch", "koch.svg follows the preset until Ctrl-C", true},
    Example{"burin watch koch -D levels=3 -o koch.svg -o koch.csv", "with a knob turned, into two files", true},
};

std::span<const OptionRow> watch_options() {
  static const std::vector<OptionRow> rows = single_options({});
  return rows;
}

/// What cannot be followed or would follow itself.
Problems unfit(const DrawRequest& request) {
  Problems problems;
  const auto report = [&](std::string message) { problems.push_back({{request.command}, std::move(message)}); };
  if (request.preset == "-") report("stdin does not change; name a preset or a file");
  if (request.writes_stdout()) report("writes files that it replaces again and again, not stdout; name a file with -o");
  return problems;
}

/// A drawing of the preset as it is now, and the files that it was made from.
struct Drawn {
  DrawOutcome outcome;
  FileStamps files;
};

/// The drawing is written over `preset_path` or its data, which would change it forever.
Problems written_over(const FileStamps& files, const std::vector<std::string>& outputs) {
  Problems problems;
  for (const std::string& output : outputs) {
    for (const auto& [path, stamp] : files) {
      std::error_code error;
      if (std::filesystem::equivalent(path, output, error) && !error) {
        problems.push_back({{output}, "is what the drawing is made from; write it elsewhere with -o", Trouble::output});
      }
    }
  }
  return problems;
}

std::vector<std::string> output_paths(const DrawRequest& request, const std::string& stem) {
  std::vector<std::string> paths;
  for (const RequestedOutput& output : request.outputs) {
    paths.push_back(output.path.empty() ? fmt::format("{}.{}", stem, output.back_end->format) : output.path);
  }
  return paths;
}

Drawn draw_now(const DrawRequest& request, const std::string& preset_path, const Surroundings& around) {
  Drawn drawn;
  // States are noted before the files are read: what changes meanwhile is seen.
  drawn.files.emplace(preset_path, stamp_of(preset_path));
  const Result<PresetText> preset = read_preset(request.preset);
  if (!preset) return {DrawOutcome::failed(preset.problems()), drawn.files};
  const ReadFile read_data = [&, read = data_reader(preset->folder)](std::string_view name) {
    const std::string path = (std::filesystem::path(preset->folder) / name).string();
    drawn.files.emplace(path, stamp_of(path));
    return read(name);
  };
  const Result<ReadyPiece> piece = make_ready(*preset, request.overrides, read_data);
  if (!piece) {
    drawn.outcome = DrawOutcome::failed(piece.problems());
  } else if (const Problems over = written_over(drawn.files, output_paths(request, preset->stem)); !over.empty()) {
    drawn.outcome = DrawOutcome::failed(over);
  } else {
    drawn.outcome = draw_piece(*piece, request, around);
  }
  return drawn;
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<DrawRequest> request = read_single_request(arguments, "burin watch");
  if (!request) return console.fail_usage(request.problems(), "burin watch");
  if (const Problems problems = unfit(*request); !problems.empty()) return console.fail_usage(problems, "burin watch");
  const Result<PresetText> preset = read_preset(request->preset);
  if (!preset) return console.fail(preset.problems());
  const std::string path = preset->source.name;
  const std::string outputs = fmt::format("{}", fmt::join(output_paths(*request, preset->stem), ", "));

  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  FileWatch watch;
  FileStamps files;
  do {
    const Clock::time_point begin = Clock::now();
    Drawn drawn = draw_now(*request, path, {temporaries, interrupt.stop()});
    if (interrupt.signal() != 0) break;
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    if (drawn.outcome.code != ExitCode::done) {
      static_cast<void>(tell_problems(drawn.outcome, request->command, console));
      console.note(fmt::format("{} stays as it was until {} is right\n", outputs, path));
      // Files that were not read this time are followed on.
      for (const auto& [file, stamp] : files) drawn.files.emplace(file, stamp_of(file));
    } else if (!request->quiet) {
      const ExitCode printed = console.print(fmt::format("{}: {} ms\n", outputs, fixed_text(milliseconds, 1)));
      if (printed != ExitCode::done) return printed;
    }
    files = std::move(drawn.files);
  } while (watch.wait_for_change(files, interrupt.stop()));
  return interrupt.exit_code();
}

}  // namespace

Command watch_command() {
  return {
      "watch",
      "draw a preset again whenever it or its data changes",
      "PRESET [-o FILE]... [-D NAME=VALUE]... [OPTIONS]",
      "Draws as 'burin draw' does, then waits for the preset or one of its data files to be saved, and draws again. "
      "While something is wrong the last good drawing stays, and the problems are shown. Every drawing appears "
      "whole; a line tells how long it took. Ctrl-C ends it.\n\n"
      "Exit codes: 130 by Ctrl-C, 143 by SIGTERM, 2 wrong command line, 3 no such preset.",
      watch_options(),
      examples,
      &run};
}

}  // namespace burin::cli
