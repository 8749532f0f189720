#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include <cli/golden_folder.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

/// Paths of all files in the folder, relative to it.
Result<std::vector<fs::path>> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
    const bool is_hidden = at->path().filename().string().starts_with('.');
    std::error_code unknown;
    if (is_hidden && at->is_directory(unknown)) at.disable_recursion_pending();
    if (!is_hidden && !at->is_directory(unknown)) files.push_back(at->path().lexically_relative(folder));
  }
  if (error) return Problem{{folder}, "cannot be looked through: " + error.message()};
  return files;
}

}  // namespace

std::string GoldenFolder::file(std::string_view name, std::string_view suffix) const {
  return (fs::path(path) / name).string() + std::string(suffix);
}

Result<GoldenFolder> find_goldens(const std::string& path) {
  const Result<std::vector<fs::path>> files = files_in(path);
  if (!files) return files.problems();
  GoldenFolder folder{path, {}, {}};
  std::set<fs::path> cases;
  for (const fs::path& file : *files) {
    if (file.extension() == ".toml") cases.insert(fs::path(file).replace_extension());
  }
  for (const fs::path& file : *files) {
    if (file.extension() != dump_suffix && file.extension() != picture_suffix) continue;
    if (!cases.contains(fs::path(file).replace_extension())) folder.orphans.push_back(file.generic_string());
  }
  for (const fs::path& name : cases) folder.cases.push_back(name.generic_string());
  std::sort(folder.cases.begin(), folder.cases.end());
  std::sort(folder.orphans.begin(), folder.orphans.end());
  return folder;
}

}  // namespace burin::cli
