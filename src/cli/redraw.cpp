#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/sha256.hpp>
#include <cli/command.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/interrupt.hpp>
#include <cli/recover/recovered.hpp>
#include <cli/redraw_request.hpp>

namespace burin::cli {

namespace {

constexpr std::array examples{
    Example{"burin draw koch && burin redraw koch.svg -o b.svg && cmp koch.svg b.svg", "the same to the byte"},
    Example{"burin draw koch && burin redraw koch.svg -D levels=3 -o koch.pdf", "one knob turned, in another format"},
    Example{"burin draw koch && burin redraw koch.svg --page a1", "planned for a larger page; pens keep their width"},
    Example{"burin draw koch && burin redraw koch.svg --enlarge a1", "all of it scaled, pens and margins too"},
    Example{"burin draw koch && burin redraw koch.svg --text > mine.toml", "back to the preset"},
};

/// The data files of a drawing, read where they are found and held against what the record says of them.
class RecordedData {
 public:
  RecordedData(std::vector<std::string> folders, std::vector<params::DataDigest> recorded)
      : folders_(std::move(folders)), recorded_(std::move(recorded)) {}

  /// From the first folder that has it as it was, else from the first that has it.
  Result<std::string> read(std::string_view name) {
    const auto is_this = [&](const params::DataDigest& data) { return data.name == name; };
    const auto known = std::find_if(recorded_.begin(), recorded_.end(), is_this);
    std::optional<Problem> missing;
    std::optional<std::string> changed;
    for (const std::string& folder : folders_) {
      Result<std::string> bytes = data_reader(folder)(name);
      if (!bytes) {
        if (!missing) missing = bytes.problems().front();
      } else if (known == recorded_.end() || sha256_hex(*bytes) == known->sha256) {
        return *std::move(bytes);
      } else if (!changed) {
        changed = *std::move(bytes);
      }
    }
    if (!changed) {
      missing->message += "; --data-folder tells where data files are";
      return *std::move(missing);
    }
    changed_.emplace_back(name);
    return *std::move(changed);
  }

  const std::vector<std::string>& changed() const { return changed_; }

 private:
  std::vector<std::string> folders_;
  std::vector<params::DataDigest> recorded_;
  std::vector<std::string> changed_;
};

std::vector<std::string> data_folders(const Arguments& arguments, const std::string& file) {
  if (const std::optional<std::string> folder = arguments.value("data-folder")) return {*folder};
  const std::string beside = std::filesystem::path(file).parent_path().string();
  std::vector<std::string> folders{beside};
  if (!beside.empty()) folders.emplace_back();
  // The pieces of the library have their data there.
  const std::vector<std::string> library = library_folders();
  folders.insert(folders.end(), library.begin(), library.end());
  return folders;
}

/// What may make the drawing differ from the file.
std::string notes(const Recovered& recovered, const RecordedData& data, const std::string& file) {
  std::string text;
  if (recovered.version != BURIN_VERSION) {
    text += fmt::format("{}: note: burin {} drew it, and this is burin " BURIN_VERSION "; the lines may differ\n", file,
                        recovered.version);
  }
  for (const std::string& name : data.changed()) {
    text += fmt::format("{}: note: the data file '{}' has changed since it was drawn\n", file, name);
  }
  return text;
}

ExitCode draw(const ReadyPiece& piece, const DrawRequest& request, const Console& console) {
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const bool live = console.shows_progress() && !request.quiet;
  const DrawOutcome outcome = draw_piece(piece, request, {temporaries, interrupt.stop(), live});
  if (interrupt.signal() != 0) return interrupt.exit_code();
  if (outcome.code != ExitCode::done) return tell_problems(outcome, request.command, console);
  if (request.quiet) return ExitCode::done;
  const std::string report = outcome.report + piece_report(piece.plan, piece.read, request.verbose);
  if (!request.writes_stdout()) return console.print(report);
  console.note(report);
  return ExitCode::done;
}

ExitCode run(const Arguments& arguments, const Console& console) {
  if (arguments.words().size() != 1) {
    return console.fail_usage({Problem{{"burin redraw"}, "name one SVG, PDF or PNG file that burin drew"}},
                              "burin redraw");
  }
  const std::string& file = arguments.words().front();
  const Result<Recovered> recovered = recover(file);
  if (!recovered) return console.fail(recovered.problems());
  if (arguments.has("text")) return console.print(recovered->preset.source.text);
  const Result<DrawRequest> request = redraw_request(*recovered, arguments, file);
  if (!request) return console.fail_usage(request.problems(), "burin redraw");

  RecordedData data(data_folders(arguments, file), recovered->data);
  const Result<ReadyPiece> piece =
      make_ready(recovered->preset, request->overrides, [&data](std::string_view name) { return data.read(name); });
  if (!piece) return console.fail(piece.problems());
  if (!request->quiet) console.note(notes(*recovered, data, file));
  return draw(*piece, *request, console);
}

}  // namespace

Command redraw_command() {
  return {"redraw",
          "draw a piece again from its own SVG, PDF or PNG file",
          "FILE [-o FILE]... [-D NAME=VALUE]... [OPTIONS]",
          "Every file that burin draws holds its preset and all options it was drawn with. Without options the result "
          "is the same to the byte. -D and --set are added to what the file was drawn with, other options replace it. "
          "Without -o the drawing goes to NAME-redrawn in the current folder, in the format of FILE; FILE itself is "
          "replaced only when -o names it.\n\n"
          "--page plans the piece for another page, where pens keep their millimetres; --enlarge scales the finished "
          "page with all that is on it.\n\n"
          "Data files are read beside FILE or in the current folder. One that is missing is an error; one that has "
          "changed is named, and drawn from.\n\n"
          "Exit codes: 0 done, 2 wrong command line, 3 no record in FILE, or wrong data, 4 too large, 5 cannot be "
          "written.",
          redraw_options(),
          examples,
          &run};
}

}  // namespace burin::cli
