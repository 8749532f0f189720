#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/atomic_file.hpp>
#include <cli/command.hpp>
#include <cli/golden_case.hpp>
#include <cli/golden_report.hpp>
#include <cli/interrupt.hpp>
#include <cli/tbb_executor.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array option_rows{
    OptionRow{"bless", 0, "", "write what is missing or different, and tell what was written"},
    OptionRow{"size", 0, "Npx", "with --bless: dots along the longer side of new pictures (400)"},
    OptionRow{"report", 0, "FOLDER", "write index.html, junit.xml and a picture for each difference there"},
    OptionRow{"threads", 0, "N", "draw so many cases at once (all cores); what is told and written is the same"},
    OptionRow{"quiet", 'q', "", "say nothing when all is as it should be"},
};

constexpr std::array examples{
    Example{"burin new a.toml --from koch && burin golden . --bless", "a first case: writes a.dump and a.png"},
    Example{"burin new a.toml --from koch && burin golden . --bless -q && burin golden .",
            "what CI runs: exit code 1 when a golden is missing, different or an orphan"},
};

struct Request {
  std::string folder;
  std::optional<std::string> report;
  GoldenRequest of_cases;
  bool bless = false;
  bool quiet = false;
  int threads = 0;
};

/// Whether `inner` is `outer` or lies in it.
bool lies_in(const std::string& inner, const std::string& outer) {
  std::error_code error;
  const fs::path inner_path = fs::weakly_canonical(fs::absolute(inner, error), error) / "";
  const fs::path outer_path = fs::weakly_canonical(fs::absolute(outer, error), error) / "";
  return inner_path.generic_string().starts_with(outer_path.generic_string());
}

std::optional<double> whole_number(std::string_view text, double most) {
  const std::optional<double> number = parse_number(text);
  return number && *number >= 1.0 && *number <= most && *number == std::floor(*number) ? number : std::nullopt;
}

Result<Request> read_request(const Arguments& arguments) {
  Problems problems;
  const auto refuse = [&](std::string message) { problems.push_back({{"burin golden"}, std::move(message)}); };
  Request request;
  request.report = arguments.value("report");
  request.bless = arguments.has("bless");
  request.quiet = arguments.has("quiet");
  request.of_cases.wants_panels = request.report.has_value();
  if (arguments.words().size() == 1) {
    request.folder = arguments.words().front();
  } else {
    refuse(fmt::format("needs one folder of presets, not {}", arguments.words().size()));
  }
  if (request.report && !request.folder.empty() && lies_in(*request.report, request.folder)) {
    refuse(fmt::format("--report {} lies in {}, where its pictures would be taken for goldens; name a folder outside",
                       *request.report, request.folder));
  }
  if (const std::optional<std::string> text = arguments.value("size")) {
    constexpr double largest_px = 8192.0;
    const std::string digits = text->ends_with("px") ? text->substr(0, text->size() - 2) : *text;
    const std::optional<double> pixels = whole_number(digits, largest_px);
    request.of_cases.new_px = pixels.value_or(1.0);
    if (!pixels) {
      refuse(
          fmt::format("--size must be a whole number of dots from 1 to {} such as 400px, not '{}'", largest_px, *text));
    }
    if (!request.bless) refuse("--size goes with --bless; a case is drawn as large as its golden is");
  }
  if (const std::optional<std::string> text = arguments.value("threads")) {
    constexpr double most_threads = 1024.0;
    const std::optional<double> threads = whole_number(*text, most_threads);
    request.threads = static_cast<int>(threads.value_or(0.0));
    if (!threads) refuse(fmt::format("--threads must be a whole number from 1 to {}, not '{}'", most_threads, *text));
  }
  if (!problems.empty()) return problems;
  return request;
}

/// A picture that a preset reads is no golden that lost its preset.
void forget_data(GoldenFolder& folder, const std::vector<GoldenResult>& results) {
  std::erase_if(folder.orphans, [&](const std::string& orphan) {
    const std::string path = fs::path(folder.file(orphan, "")).lexically_normal().generic_string();
    return std::any_of(results.begin(), results.end(), [&](const GoldenResult& result) {
      return std::find(result.data.begin(), result.data.end(), path) != result.data.end();
    });
  });
}

Result<Done> write_into_folder(const std::string& path, std::string_view bytes, Temporaries& temporaries,
                               const std::stop_token& stop) {
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) return write_problem(path, error.value());
  return write_file(path, bytes, temporaries, stop);
}

/// All files of a report, or of the goldens that changed; the first that cannot be written ends it.
using Files = std::vector<std::pair<std::string, std::string>>;

Files report_files(const std::string& report, const GoldenFolder& folder, const std::vector<GoldenResult>& results) {
  const auto path = [&](std::string_view name) { return (fs::path(report) / name).string(); };
  Files files{{path(report_page_file), golden_page(folder, results)},
              {path(report_junit_file), golden_junit(folder, results)}};
  for (const GoldenResult& result : results) {
    if (!result.panels.empty()) files.emplace_back(path(result.name + std::string(picture_suffix)), result.panels);
  }
  return files;
}

Files blessed_files(const std::vector<GoldenResult>& results) {
  Files files;
  for (const GoldenResult& result : results) {
    for (const GoldenDifference& difference : result.differences) files.emplace_back(difference.file, difference.drawn);
  }
  return files;
}

/// What is wrong, or what a blessing changed.
std::string listed(const GoldenFolder& folder, const std::vector<GoldenResult>& results, bool blessed) {
  std::string text;
  for (const GoldenResult& result : results) {
    for (const GoldenDifference& difference : result.differences) {
      const char* const what = !blessed ? "" : difference.is_new ? "written, it " : "written, before: ";
      text += fmt::format("{}: {}{}\n", difference.file, what,
                          blessed && difference.is_new ? "is new" : difference.message);
    }
  }
  for (const std::string& orphan : folder.orphans) {
    text += fmt::format("{}: has no preset beside it; remove it, or bring its preset back\n", folder.file(orphan, ""));
  }
  return text;
}

struct Counts {
  std::size_t broken = 0;
  std::size_t different = 0;
};

Counts counts_of(const std::vector<GoldenResult>& results) {
  Counts counts;
  for (const GoldenResult& result : results) {
    if (!result.problems.empty()) ++counts.broken;
    if (!result.differences.empty()) ++counts.different;
  }
  return counts;
}

ExitCode tell(const Request& request, const GoldenFolder& folder, const std::vector<GoldenResult>& results,
              const Console& console) {
  const Counts counts = counts_of(results);
  const std::size_t unblessed = request.bless ? 0 : counts.different;
  const bool all_good = counts.broken == 0 && unblessed == 0 && folder.orphans.empty();
  const std::string list = listed(folder, results, request.bless);
  if (all_good) {
    if (request.quiet) return ExitCode::done;
    const std::string end = request.bless ? fmt::format("{} files written", blessed_files(results).size())
                                          : std::string("all as they should be");
    return console.print(fmt::format("{}{}: {} cases; {}\n", list, folder.path, results.size(), end));
  }
  for (const GoldenResult& result : results) {
    if (!result.problems.empty()) static_cast<void>(console.fail(result.problems));
  }
  std::string summary = fmt::format("{}: {} cases", folder.path, results.size());
  if (counts.broken > 0) summary += fmt::format(", {} cannot be drawn", counts.broken);
  if (counts.different > 0) {
    summary += fmt::format(", {} {}", counts.different, request.bless ? "written anew" : "not as they should be");
  }
  if (!folder.orphans.empty()) summary += fmt::format(", {} files without a preset", folder.orphans.size());
  console.note(list + summary + '\n');
  if (unblessed > 0) {
    console.note(fmt::format(
        "Look at them (--report FOLDER); if they are right, 'burin golden {} --bless' keeps them.\n", folder.path));
  }
  if (counts.broken == 0) return ExitCode::different;
  const auto broken =
      std::find_if(results.begin(), results.end(), [](const GoldenResult& r) { return !r.problems.empty(); });
  return exit_code(broken->problems);
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<Request> request = read_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin golden");
  Result<GoldenFolder> folder = find_goldens(request->folder);
  if (!folder) return console.fail(folder.problems());
  if (folder->cases.empty()) {
    return console.fail({Problem{{request->folder}, "has no presets; a case is a file NAME.toml in it or below"}});
  }

  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  std::vector<GoldenResult> results(folder->cases.size());
  TbbExecutor(request->threads).run(results.size(), [&](std::size_t i) {
    if (interrupt.signal() == 0) results[i] = check_golden(*folder, folder->cases[i], request->of_cases);
  });
  if (interrupt.signal() != 0) return interrupt.exit_code();
  forget_data(*folder, results);

  Files files = request->report ? report_files(*request->report, *folder, results) : Files();
  if (request->bless) {
    for (auto& file : blessed_files(results)) files.push_back(std::move(file));
  }
  for (const auto& [path, bytes] : files) {
    const Result<Done> written = write_into_folder(path, bytes, temporaries, interrupt.stop());
    if (interrupt.signal() != 0) return interrupt.exit_code();
    if (!written) return console.fail(written.problems());
  }
  return tell(*request, *folder, results, console);
}

}  // namespace

Command golden_command() {
  return {
      "golden",
      "hold presets against the drawings they gave before",
      "DIR [--bless] [--report FOLDER]",
      "A case is a preset DIR/.../NAME.toml and beside it its goldens: NAME.dump, the canonical dump in whole "
      "micrometres, and NAME.png by the native back end. Both are the same on every machine. Dumps are compared by "
      "their text, pictures by their pixels, drawn as large as the golden is. A golden that is missing or different "
      "fails, and so does an orphan: a .dump or .png without a preset that is not read by one either.\n\n"
      "--bless writes what is missing or different and leaves the rest as it is; orphans are for you to remove. The "
      "report shows golden, drawn and difference beside each other, junit.xml is for CI services. Hidden files and "
      "folders are passed over.\n\n"
      "Exit codes: 0 all as it should be or blessed, 1 different, missing or orphans, 2 wrong command line, 3 a "
      "preset is wrong, 4 too large, 5 cannot be written.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
