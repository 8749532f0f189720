#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <burin/base/suggest.hpp>
#include <cli/file_io.hpp>
#include <cli/personal_folder.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".toml";

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::vector<std::string> split(std::string_view list, char separator) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(separator), list.size());
    if (end > 0) parts.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return parts;
}

/// The build tree is laid out as an installation is, so this finds the shipped presets in both.
std::optional<std::string> shipped_folder() {
  std::error_code error;
  const fs::path tool = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  return (tool.parent_path().parent_path() / "share/burin/presets").string();
}

bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::optional<std::string> find_in_library(std::string_view name) {
  return library_file(fmt::format("{}{}", name, suffix));
}

Result<PresetText> read_preset_file(const std::string& path) {
  const Result<std::string> text = read_file(path, path, preset_limit_bytes);
  if (!text) return text.problems();
  const fs::path file(path);
  return PresetText{{path, *text}, file.stem().string(), file.filename().string(), file.parent_path().string()};
}

Problem not_found(const std::string& name) {
  std::vector<std::string_view> names;
  const std::vector<ShippedPreset> presets = library_presets();
  for (const ShippedPreset& preset : presets) names.push_back(preset.name);
  const std::string hint = names.empty() ? std::string() : suggestion(name, names);
  return {{"burin"},
          fmt::format("there is no preset '{}'{} (looked in {}; a file of your own is given with its path or its "
                      "suffix .toml)",
                      name, hint, fmt::join(library_folders(), ", "))};
}

}  // namespace

std::optional<std::string> library_file(std::string_view name) {
  for (const std::string& folder : library_folders()) {
    std::string path = fmt::format("{}/{}", folder, name);
    if (is_file(path)) return path;
  }
  return std::nullopt;
}

bool is_preset_path(std::string_view word) {
  return word == "-" || word.find('/') != std::string_view::npos ||
         (word.size() > suffix.size() && word.substr(word.size() - suffix.size()) == suffix);
}

Result<PresetText> read_preset(const std::string& word) {
  if (word == "-") {
    const Result<std::string> text = read_stdin(preset_limit_bytes);
    if (!text) return text.problems();
    return PresetText{{"-", *text}, std::string(stdin_stem), "-", ""};
  }
  if (is_preset_path(word)) return read_preset_file(word);
  if (const std::optional<std::string> path = find_in_library(word)) return read_preset_file(*path);
  if (is_file(word)) return read_preset_file(word);
  return not_found(word);
}

Problems with_source(Problems problems, const PresetText& preset) {
  attach_source(problems, preset.source.name, preset.source.text);
  return problems;
}

std::vector<ShippedPreset> library_presets() {
  std::map<std::string, std::string> found;
  for (const std::string& folder : library_folders()) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      const fs::path& path = at->path();
      if (path.extension() == suffix && is_file(path.string())) found.emplace(path.stem().string(), path.string());
    }
  }
  std::vector<ShippedPreset> presets;
  for (auto& [name, path] : found) presets.push_back({name, path});
  return presets;
}

bool is_library_preset(std::string_view name) {
  return find_in_library(name).has_value();
}

std::vector<std::string> library_folders() {
  std::vector<std::string> folders = split(environment("BURIN_PATH"), ':');
  if (std::optional<std::string> folder = personal_folder("presets")) folders.push_back(std::move(*folder));
  if (std::optional<std::string> folder = shipped_folder()) folders.push_back(std::move(*folder));
  return folders;
}

}  // namespace burin::cli
