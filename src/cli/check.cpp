#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>
#include <cli/command.hpp>
#include <cli/file_io.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

constexpr std::array option_rows{OptionRow{"quiet", 'q', "", "say nothing when all is well"}};

constexpr std::array examples{
    Example{"burin check koch", "reads a preset and says what is wrong with it"},
    Example{"burin new mine.toml --from koch && burin check mine.toml", "a file of your own"},
};

/// All that is wrong with one preset; nothing when it can be drawn. Warnings are added to `warnings`.
Problems problems_of(const std::string& word, std::vector<std::string>& warnings) {
  const Result<PresetText> preset = read_preset(word);
  if (!preset) return preset.problems();
  Result<preset::Piece> piece = preset::load(preset->source, {}, data_reader(preset->folder));
  if (!piece) return piece.problems();
  warnings.insert(warnings.end(), piece->warnings.begin(), piece->warnings.end());
  const Result<preset::Plan> plan = preset::Plan::make(*std::move(piece));
  return plan ? Problems() : with_source(plan.problems(), *preset);
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const std::vector<std::string>& words = arguments.words();
  if (words.empty()) {
    return console.fail_usage({Problem{{"burin check"}, "name the presets to check"}}, "burin check");
  }
  Problems problems;
  std::vector<std::string> warnings;
  for (const std::string& word : words) {
    const Problems found = problems_of(word, warnings);
    problems.insert(problems.end(), found.begin(), found.end());
  }
  for (const std::string& warning : warnings) console.note(warning + '\n');
  if (!problems.empty()) return console.fail(problems);
  if (arguments.has("quiet")) return ExitCode::done;
  return console.print(words.size() == 1 ? "1 preset is fine\n" : fmt::format("{} presets are fine\n", words.size()));
}

}  // namespace

Command check_command() {
  return {"check",     "say what is wrong with presets, without drawing them",
          "PRESET...", "Every problem of every preset is shown with its line. Exit code 3 when there is one.",
          option_rows, examples,
          &run};
}

}  // namespace burin::cli
