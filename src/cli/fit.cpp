#include <array>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/fractal_interpolation/contour.hpp>
#include <burin/curves/fractal_interpolation/fit.hpp>
#include <burin/curves/fractal_interpolation/source_points.hpp>
#include <cli/atomic_file.hpp>
#include <cli/command.hpp>
#include <cli/file_io.hpp>
#include <cli/fitted_preset.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;
namespace fractal = curves::fractal_interpolation;

constexpr std::array option_rows{
    OptionRow{"intervals", 0, "N", "pass through N + 1 of the points, equally far apart along the curve"},
    OptionRow{"scaling", 0, "KIND", "what -o stores: constant or function (the default), a line for each interval"},
    OptionRow{"closed", 0, "", "the curve returns to its first point"},
    OptionRow{"lonlat", 0, "", "the columns are degrees: x becomes (lon - mean) cos(mean lat)"},
    OptionRow{"json", 0, "", "print the comparison as JSON"},
    OptionRow{"output", 'o', "FILE.toml", "write a preset that draws the fit over the data; - is stdout"}};

constexpr std::array examples{
    Example{"burin fit fibonacci_spiral --intervals 24", "how near each method comes to the data"},
    Example{"burin fit fibonacci_spiral --intervals 12 -o fitted.toml", "a preset to draw and edit"},
    Example{"burin fit beetle_outline --intervals 60 --closed --json", "the numbers for a program"},
};

constexpr double most_intervals = 100'000;

/// What the command line asks for.
struct FitRequest {
  std::string data;
  int intervals = 0;
  fractal::Method method = fractal::Method::rational_function;
  bool closed = false;
  bool lonlat = false;
  bool json = false;
  std::optional<std::string> output;
};

Result<FitRequest> read_request(const Arguments& arguments) {
  Problems problems;
  const auto report = [&](std::string message) { problems.push_back({{"burin fit"}, std::move(message)}); };
  FitRequest request;
  if (arguments.words().size() == 1) {
    request.data = arguments.words().front();
  } else {
    report("name one CSV file of points");
  }
  if (const std::optional<std::string> text = arguments.value("intervals")) {
    const std::optional<double> number = parse_number(*text);
    if (number && *number >= 2.0 && *number <= most_intervals && *number == static_cast<int>(*number)) {
      request.intervals = static_cast<int>(*number);
    } else {
      report(fmt::format("--intervals takes a whole number from 2 to {}, not '{}'", most_intervals, *text));
    }
  } else {
    report("say how many intervals the fit may have: --intervals N");
  }
  const std::string scaling = arguments.value("scaling").value_or("function");
  if (scaling == "constant") {
    request.method = fractal::Method::rational_constant;
  } else if (scaling != "function") {
    report(fmt::format("--scaling takes constant or function, not '{}'", scaling));
  }
  request.closed = arguments.has("closed");
  request.lonlat = arguments.has("lonlat");
  request.json = arguments.has("json");
  request.output = arguments.value("output");
  if (request.json && request.output == "-") report("--json and -o - would both write to stdout");
  if (!problems.empty()) return problems;
  return request;
}

/// A file, or the shipped data of this name.
std::string find_data(const std::string& word) {
  std::error_code error;
  if (fs::exists(word, error) || word.find('/') != std::string::npos) return word;
  const std::string file = fs::path(word).has_extension() ? word : word + ".csv";
  for (const std::string& folder : library_folders()) {
    std::string path = (fs::path(folder) / "data" / file).string();
    if (fs::is_regular_file(path, error)) return path;
  }
  return word;
}

/// The data, cleaned; what was dropped is noted.
Result<fractal::SourcePoints> read_data(const FitRequest& request, const std::string& path, const Console& console) {
  const Result<std::string> text = read_file(path, path, data_limit_bytes);
  if (!text) return text.problems();
  Result<fractal::SourcePoints> source = fractal::points_of_csv(*text, path);
  if (!source) {
    Problems problems = source.problems();
    attach_source(problems, path, *text);
    return problems;
  }
  if (request.lonlat) fractal::project_from_degrees(source->points);
  if (const fractal::Repetitions repeated = fractal::drop_repeated(*source); repeated.count > 0) {
    console.note(fractal::warning_of(repeated) + '\n');
  }
  if (request.closed) fractal::close_up(*source);
  const std::size_t count = source->points.size();
  if (count > static_cast<std::size_t>(request.intervals)) return source;
  return Problem{{path},
                 fmt::format("has {} {}; {} intervals need at least {}", count,
                             count == 1 ? "point" : "different points", request.intervals, request.intervals + 1)};
}

/// JSON's name of a method.
std::string json_name(std::string_view word) {
  std::string name(word);
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

std::string json_text(const fractal::Comparison& comparison) {
  const std::size_t intervals = comparison.knots.size() - 1;
  std::string rmse;
  std::string numbers;
  for (const auto& [name, method] : words(fractal::Method{})) {
    const char* comma = rmse.empty() ? "" : ", ";
    rmse += fmt::format("{}\"{}\": {}", comma, json_name(name),
                        shortest_text(comparison.fits[static_cast<std::size_t>(method)].rmse));
    numbers += fmt::format("{}\"{}\": {}", comma, json_name(name), fractal::stored_numbers(method, intervals));
  }
  return fmt::format(
      "{{\n  \"points\": {},\n  \"fitted_every\": {},\n  \"intervals\": {},\n  \"rmse\": {{{}}},\n  \"parameters\": "
      "{{{}}}\n}}\n",
      comparison.t.size(), comparison.step, intervals, rmse, numbers);
}

std::string report_text(const fractal::Comparison& comparison, const std::string& path) {
  const std::size_t intervals = comparison.knots.size() - 1;
  const std::string sample = comparison.step == 1 ? "" : fmt::format(", 1 of {} fitted", comparison.step);
  std::string text = fmt::format("{}: {} points{}, {} intervals; errors where the larger side is 1\n\n", path,
                                 comparison.t.size(), sample, intervals);
  text += fmt::format("  {:<20}  {:>9}  {:>14}\n", "method", "RMSE", "numbers stored");
  for (const auto& [name, method] : words(fractal::Method{})) {
    text += fmt::format("  {:<20}  {:>9.6f}  {:>14}\n", name, comparison.fits[static_cast<std::size_t>(method)].rmse,
                        fractal::stored_numbers(method, intervals));
  }
  return text;
}

/// How a preset in the folder of `output` names the data.
std::string data_seen_from(const std::string& output, const std::string& path) {
  std::error_code error;
  const fs::path folder = output == "-" ? fs::path() : fs::path(output).parent_path();
  const fs::path base = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  return fs::absolute(path, error).lexically_normal().lexically_proximate(base).string();
}

ExitCode write_preset(const std::string& output, const std::string& text, const Console& console) {
  Temporaries temporaries;
  const Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(output, temporaries, {});
  if (!file) return console.fail(file.problems());
  (*file)->write(text);
  if (const Result<Done> written = (*file)->commit(); !written) {
    return (*file)->lost_reader() ? ExitCode::output : console.fail(written.problems());
  }
  return ExitCode::done;
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<FitRequest> request = read_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin fit");
  const std::string path = find_data(request->data);
  const Result<fractal::SourcePoints> source = read_data(*request, path, console);
  if (!source) return console.fail(source.problems());
  const fractal::Comparison comparison = fractal::compare_methods(
      source->points, request->intervals, request->closed ? fractal::Ends::periodic : fractal::Ends::open);
  if (comparison.knots.size() - 1 < static_cast<std::size_t>(request->intervals)) {
    console.note(fmt::format("{}: warning: the points lie too unevenly for {} intervals; {} are fitted\n", path,
                             request->intervals, comparison.knots.size() - 1));
  }
  if (request->output) {
    const std::string text = fitted_preset(comparison, request->method, source->points,
                                           {data_seen_from(*request->output, path), request->closed, request->lonlat});
    if (const ExitCode code = write_preset(*request->output, text, console); code != ExitCode::done) return code;
    if (*request->output == "-") return ExitCode::done;
  }
  return console.print(request->json ? json_text(comparison) : report_text(comparison, path));
}

}  // namespace

Command fit_command() {
  return {"fit",
          "fit a fractal interpolation to a curve of points",
          "DATA.csv --intervals N [--closed] [--json] [-o FILE.toml]",
          "DATA.csv has one x,y a line, in the order of the curve; or it is the name of shipped data: "
          "fibonacci_spiral, beetle_outline, coastline_maine, coastline_cornwall.\n\n"
          "Four methods pass through the same knots: the cubic spline, polynomial fractal interpolation with scaling "
          "functions, the rational one with constant scaling, and the rational one with scaling functions. Each is "
          "fitted and its error told beside the numbers that it stores: a method with more freedom comes nearer, and "
          "pays for it. -o writes the rational one.",
          option_rows,
          examples,
          &run};
}

}  // namespace burin::cli
