#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/atomic_file.hpp>
#include <cli/command.hpp>
#include <cli/file_io.hpp>
#include <cli/gallery_page.hpp>
#include <cli/gallery_piece.hpp>
#include <cli/interrupt.hpp>
#include <cli/recover/found_record.hpp>
#include <cli/tbb_executor.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array option_rows{
    OptionRow{"output", 'o', "FOLDER", "draw into this folder (gallery)"},
    OptionRow{"presets", 0, "FOLDER", "draw the presets of this folder"},
    OptionRow{"check", 0, "", "only say what in the folder is not as it would be drawn"},
    OptionRow{"quiet", 'q', "", "errors only"},
};

constexpr std::array examples{
    Example{"burin gallery -o pictures", "every shipped preset, with pictures/README.md to read them by"},
    Example{"burin new my.toml --from koch && burin gallery --presets . -o mine", "presets of your own"},
};

constexpr std::string_view page_file = "README.md";
constexpr std::string_view digests_file = "digests.txt";
/// More is slow to load in a page of many.
constexpr std::size_t moderate_svg_bytes = 500'000;
constexpr std::size_t largest_file_bytes = std::size_t{256} << 20U;

/// What is asked for.
struct Request {
  std::string folder;
  std::optional<std::string> presets_folder;  ///< else the library
  std::vector<ShippedPreset> presets;         ///< by name
  bool check = false;
};

std::vector<ShippedPreset> presets_in(const std::string& folder) {
  std::vector<ShippedPreset> presets;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path& path = at->path();
    if (path.extension() == ".toml") presets.push_back({path.stem().string(), path.string()});
  }
  std::sort(presets.begin(), presets.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return presets;
}

Result<Request> read_request(const Arguments& arguments) {
  const auto refuse = [](std::string message) { return Problem{{"burin gallery"}, std::move(message)}; };
  if (!arguments.words().empty()) {
    return refuse(fmt::format("takes options only, not '{}'; --presets FOLDER tells which presets to draw",
                              arguments.words().front()));
  }
  Request request;
  request.folder = arguments.value("output").value_or("gallery");
  request.check = arguments.has("check");
  request.presets_folder = arguments.value("presets");
  if (!request.presets_folder && !presets_in("presets").empty()) request.presets_folder = "presets";
  request.presets = request.presets_folder ? presets_in(*request.presets_folder) : library_presets();
  if (request.presets.empty()) {
    return refuse(fmt::format("there are no presets in {}", request.presets_folder.value_or("the library")));
  }
  return request;
}

/// A file of the gallery as it must be. The thumbnail of another Cairo differs in its bytes, but not in its record.
struct GalleryFile {
  std::string bytes;
  std::string record{};  ///< of a thumbnail when its bytes are not told
};
using GalleryFiles = std::map<std::string, GalleryFile>;

/// The way to a preset from the gallery's folder.
std::string relative_path(const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path from = fs::weakly_canonical(fs::absolute(folder, error), error);
  return fs::weakly_canonical(path, error).lexically_relative(from).generic_string();
}

/// Everything that the folder should hold.
Result<GalleryFiles> draw_all(const Request& request) {
  std::vector<std::optional<Result<GalleryPiece>>> pieces(request.presets.size());
  TbbExecutor(0).run(pieces.size(),
                     [&](std::size_t i) { pieces[i] = draw_for_gallery(request.presets[i], !request.check); });
  GalleryFiles files;
  std::vector<GalleryEntry> entries;
  Problems problems;
  for (std::optional<Result<GalleryPiece>>& piece : pieces) {
    if (!*piece) {
      problems.insert(problems.end(), piece->problems().begin(), piece->problems().end());
      continue;
    }
    GalleryPiece drawn = **std::move(piece);
    const std::string name = drawn.entry.name;
    if (request.presets_folder) {
      drawn.entry.preset_path = relative_path(fmt::format("{}/{}.toml", *request.presets_folder, name), request.folder);
    }
    files[name + ".svg"] = {std::move(drawn.svg)};
    files[name + ".png"] = {std::move(drawn.png), std::move(drawn.png_record)};
    entries.push_back(std::move(drawn.entry));
  }
  if (!problems.empty()) return problems;
  files[std::string(page_file)] = {gallery_page(entries)};
  files[std::string(digests_file)] = {digests_text(entries)};
  return files;
}

std::string path_in(const Request& request, std::string_view name) {
  return (fs::path(request.folder) / name).string();
}

/// The pictures of pieces that are no more, as far as an earlier run made them.
std::vector<std::string> leftovers(const Request& request, const GalleryFiles& files) {
  std::vector<std::string> names;
  const std::string digests_path = path_in(request, digests_file);
  const Result<std::string> digests = read_file(digests_path, digests_path, largest_file_bytes);
  if (!digests) return names;
  for (const std::string& name : names_in_digests(*digests)) {
    for (const std::string_view suffix : {".png", ".svg"}) {
      const std::string file = name + std::string(suffix);
      const bool plain = file.find('/') == std::string::npos;
      if (plain && !files.contains(file) && fs::exists(path_in(request, file))) names.push_back(file);
    }
  }
  return names;
}

bool is_as_it_should(const std::string& path, const GalleryFile& file) {
  const Result<std::string> bytes = read_file(path, path, largest_file_bytes);
  if (!bytes) return false;
  if (file.record.empty() || !file.bytes.empty()) return *bytes == file.bytes;
  const Result<std::string> record = find_record(bytes_of(*bytes), path);
  return record && *record == file.record;
}

ExitCode check(const Request& request, const GalleryFiles& files, bool quiet, const Console& console) {
  std::string differences;
  for (const auto& [name, file] : files) {
    const std::string path = path_in(request, name);
    if (is_as_it_should(path, file)) continue;
    differences += fmt::format("{}: {}\n", path, fs::exists(path) ? "is not what would be drawn" : "is missing");
  }
  for (const std::string& name : leftovers(request, files)) {
    differences += fmt::format("{}: no preset is called so any more\n", path_in(request, name));
  }
  if (differences.empty()) {
    return quiet ? ExitCode::done
                 : console.print(
                       fmt::format("{}: {} pieces, all as they should be\n", request.folder, request.presets.size()));
  }
  console.note(differences + "'burin gallery' draws them again.\n");
  return ExitCode::input;
}

ExitCode write_all_files(const Request& request, const GalleryFiles& files, bool quiet, const Console& console) {
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  std::error_code error;
  for (const std::string& name : leftovers(request, files)) fs::remove(path_in(request, name), error);
  std::size_t written = 0;
  for (const auto& [name, file] : files) {
    if (interrupt.signal() != 0) return interrupt.exit_code();
    const std::string path = path_in(request, name);
    // Equal files keep their date.
    if (is_as_it_should(path, file)) continue;
    const Result<Done> done = write_file(path, file.bytes, temporaries, interrupt.stop());
    if (!done) return console.fail(done.problems());
    ++written;
  }
  if (quiet) return ExitCode::done;
  for (const auto& [name, file] : files) {
    if (!name.ends_with(".svg") || file.bytes.size() <= moderate_svg_bytes) continue;
    console.note(fmt::format("{}: note: {} bytes are much for a gallery; fewer levels would show as much\n",
                             path_in(request, name), count_text(static_cast<double>(file.bytes.size()))));
  }
  return console.print(
      fmt::format("{}: {} pieces; {} files written\n", request.folder, request.presets.size(), written));
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<Request> request = read_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin gallery");
  std::error_code error;
  if (!request->check) fs::create_directories(request->folder, error);
  if (error) return console.fail({write_problem(request->folder, error.value())});
  const Result<GalleryFiles> files = draw_all(*request);
  if (!files) return console.fail(files.problems());
  const bool quiet = arguments.has("quiet");
  return request->check ? check(*request, *files, quiet, console) : write_all_files(*request, *files, quiet, console);
}

}  // namespace

Command gallery_command() {
  return {
      "gallery",
      "draw every preset into a folder with a page to look at them",
      "[-o FOLDER] [--presets FOLDER] [--check]",
      "Writes NAME.svg, a thumbnail NAME.png and README.md with pictures, commands and knobs, on all cores. The same "
      "presets give the same bytes. The presets are those of the folder presets here if there is one, else the "
      "library's.\n\n"
      "digests.txt has the SHA-256 of every piece's canonical dump, as 'burin draw NAME --format dump' writes it. "
      "--check compares README.md, digests.txt and the SVG files to the byte, and what the thumbnails say they were "
      "drawn from.\n\n"
      "Exit codes: 0 done, 2 wrong command line, 3 a wrong preset, or --check found a difference, 5 cannot be "
      "written.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
