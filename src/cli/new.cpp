#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include <burin/preset/load.hpp>
#include <cli/atomic_file.hpp>
#include <cli/command.hpp>
#include <cli/file_io.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

constexpr std::array option_rows{OptionRow{"from", 0, "PRESET", "the preset to copy"},
                                 OptionRow{"force", 'f', "", "replace FILE if it is there"}};

constexpr std::array examples{
    Example{"burin new mine.toml --from koch", "a preset of your own to edit"},
    Example{"burin new wide.toml --from koch --force && burin draw wide.toml", "and draw it"},
};

std::string first_knob_words(const preset::Summary& summary) {
  if (summary.knobs.empty()) return "--page a3";
  const preset::KnobInfo& knob = summary.knobs.front();
  return fmt::format("-D {}={}", knob.name, knob.default_text);
}

/// What to try, above the copied text.
std::string header(const std::string& file, const PresetText& preset, const preset::Summary& summary) {
  const std::string name = is_preset_path(file) ? file : "./" + file;
  return fmt::format(
      "# A copy of the preset '{0}' to edit.\n"
      "#   burin draw {1}             draws it into {2}.svg\n"
      "#   burin draw {1} {3}   turns a knob; the table [knobs] holds their defaults\n"
      "#   burin check {1}            says what is wrong\n"
      "#   burin show layer, burin show two-point ...   tell what may be written here\n"
      "\n",
      preset.stem, name, std::filesystem::path(file).stem().string(), first_knob_words(summary));
}

Problem usage_problem(std::string message) {
  return {{"burin new"}, std::move(message)};
}

Problems usage_problems(const Arguments& arguments) {
  Problems problems;
  if (arguments.words().size() != 1) problems.push_back(usage_problem("name one file to write: burin new FILE.toml"));
  if (!arguments.has("from")) {
    problems.push_back(usage_problem("say what to start from: --from PRESET ('burin list' shows the presets)"));
  }
  return problems;
}

/// Data files stay where they are; the copy looks for them beside itself.
void note_data(const preset::Piece& piece, const PresetText& preset, const Console& console) {
  for (const params::DataDigest& data : piece.data) {
    console.note(fmt::format("the preset reads '{}'; copy it from {} to beside the new file\n", data.name,
                             preset.folder.empty() ? "." : preset.folder));
  }
}

ExitCode run(const Arguments& arguments, const Console& console) {
  if (const Problems problems = usage_problems(arguments); !problems.empty()) {
    return console.fail_usage(problems, "burin new");
  }
  const std::string& file = arguments.words().front();
  std::error_code error;
  if (!arguments.has("force") && std::filesystem::is_regular_file(file, error)) {
    return console.fail({Problem{{file}, "is there already; --force replaces it", Trouble::output}});
  }
  const Result<PresetText> preset = read_preset(*arguments.value("from"));
  if (!preset) return console.fail(preset.problems());
  const Result<preset::Summary> summary = preset::summarise(preset->source);
  if (!summary) return console.fail(summary.problems());
  const Result<preset::Piece> piece = preset::load(preset->source, {}, data_reader(preset->folder));
  if (!piece) return console.fail(piece.problems());

  Temporaries temporaries;
  const Result<std::unique_ptr<AtomicFile>> copy = AtomicFile::open(file, temporaries, {});
  if (!copy) return console.fail(copy.problems());
  (*copy)->write(header(file, *preset, *summary));
  (*copy)->write(preset->source.text);
  if (const Result<Done> written = (*copy)->commit(); !written) {
    return (*copy)->lost_reader() ? ExitCode::output : console.fail(written.problems());
  }
  note_data(*piece, *preset, console);
  if (file == "-") return ExitCode::done;
  return console.print(fmt::format("{}: a copy of '{}'; edit it, then burin draw {}\n", file, preset->stem, file));
}

}  // namespace

Command new_command() {
  return {"new",
          "copy a preset into a file of your own to edit",
          "FILE --from PRESET [--force]",
          "The copy begins with comments that tell what to try. A file that is there is kept, unless --force is given.",
          option_rows,
          examples,
          &run};
}

}  // namespace burin::cli
