#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/plan.hpp>
#include <cli/command.hpp>
#include <cli/draw_output.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_request.hpp>
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
          {{"burin draw"}, fmt::format("{}: there is no layer '{}'{}", option, name, suggestion(name, names))});
    }
  }
  return problems;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Every output with all that is known before it is opened.
Result<std::vector<OutputJob>> make_jobs(const preset::Plan& plan, const DrawRequest& request, const PresetText& preset,
                                         const ReadPiece& piece, std::stop_token stop) {
  std::vector<OutputJob> jobs;
  for (const RequestedOutput& output : request.outputs) {
    OutputJob job;
    job.back_end = output.back_end;
    job.path = output.path.empty() ? fmt::format("{}.{}", preset.stem, output.back_end->format) : output.path;
    job.options = output_options(request, plan.sheet().page);
    if (Result<Done> accepted = job.back_end->accepts(plan.sheet(), job.options); !accepted) return accepted.problems();
    const bool every_point = request.all_points || job.back_end->space == Space::model;
    job.run.space = job.back_end->space;
    job.run.tolerance_mm = every_point ? 0.0 : job.back_end->tolerance_mm(job.options);
    job.run.wanted = [&request](const SheetLayer& layer) {
      return (request.only.empty() || contains(request.only, layer.name)) && !contains(request.skip, layer.name);
    };
    job.run.stop = stop;
    const Result<Forecast> forecast = plan.check_size(job.run, request.max_points);
    if (!forecast) return forecast.problems();
    const Result<Done> fits =
        check_memory(*job.back_end, *forecast, plan.sheet(), job.options, request.max_memory_mb * 1e6);
    if (!fits) return fits.problems();
    job.forecast = *forecast;
    job.origin = make_origin(request, *job.back_end, preset, piece);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

/// Opens every output before the first is drawn, so that a folder that cannot be written to costs no time.
Result<std::vector<std::unique_ptr<AtomicFile>>> open_files(const std::vector<OutputJob>& jobs,
                                                            Temporaries& temporaries, const std::stop_token& stop) {
  std::vector<std::unique_ptr<AtomicFile>> files;
  Problems problems;
  for (const OutputJob& job : jobs) {
    Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(job.path, temporaries, stop);
    if (file) {
      files.push_back(*std::move(file));
    } else {
      problems.insert(problems.end(), file.problems().begin(), file.problems().end());
    }
  }
  if (!problems.empty()) return problems;
  return files;
}

ExitCode write_outputs(const preset::Plan& plan, const DrawRequest& request, const PresetText& preset,
                       const ReadPiece& piece, const Console& console) {
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const auto stopped = [&interrupt] { return static_cast<ExitCode>(128 + interrupt.signal()); };

  const Result<std::vector<OutputJob>> jobs = make_jobs(plan, request, preset, piece, interrupt.stop());
  if (!jobs) return console.fail(with_source(jobs.problems(), preset));
  const Result<std::vector<std::unique_ptr<AtomicFile>>> files = open_files(*jobs, temporaries, interrupt.stop());
  if (interrupt.signal() != 0) return stopped();
  if (!files) return console.fail(files.problems());

  std::string report;
  for (std::size_t i = 0; i < jobs->size(); ++i) {
    const OutputJob& job = (*jobs)[i];
    AtomicFile& file = *(*files)[i];
    if (job.back_end->binary && file.is_terminal()) {
      const std::string advice = fmt::format("{} is not for terminals; write a file (-o NAME.{}) or a pipe",
                                             job.back_end->format, job.back_end->format);
      return console.fail_usage({Problem{{"burin draw"}, advice}}, "burin draw");
    }
    const Result<OutputCounts> counts = draw_output(plan, job, file, console.shows_progress() && !request.quiet);
    if (interrupt.signal() != 0) return stopped();
    if (!counts) return file.lost_reader() ? ExitCode::output : console.fail(counts.problems());
    report += output_report(job, *counts);
  }
  if (request.quiet) return ExitCode::done;
  report += piece_report(plan, piece, request.verbose);
  if (!request.writes_stdout()) return console.print(report);
  console.note(report);
  return ExitCode::done;
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<DrawRequest> request = read_draw_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin draw");
  const Result<PresetText> preset = read_preset(request->preset);
  if (!preset) return console.fail(preset.problems());
  Result<preset::Piece> piece = preset::load(preset->source, request->overrides, data_reader(preset->folder));
  if (!piece) return console.fail(piece.problems());
  const ReadPiece read{piece->about, piece->seed, piece->data};
  Result<preset::Plan> plan = preset::Plan::make(*std::move(piece));
  if (!plan) return console.fail(with_source(plan.problems(), *preset));
  if (const Problems problems = unknown_layers(plan->sheet(), *request); !problems.empty()) {
    return console.fail_usage(problems, "burin draw");
  }
  return write_outputs(*plan, *request, *preset, read, console);
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
