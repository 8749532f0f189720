#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include <cli/file_io.hpp>
#include <cli/output_target.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

/// Follows symbolic links, the last of which may point to nothing yet.
Result<std::string> resolved(const std::string& path) {
  constexpr int most_links = 40;  // as the kernel
  fs::path at(path);
  for (int links = 0; links <= most_links; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(at, error))) return at.string();
    const fs::path next = fs::read_symlink(at, error);
    if (error) return write_problem(path, error.value());
    at = at.parent_path() / next;
  }
  return write_problem(path, ELOOP);
}

/// The outermost folder on the way to `path` that is not there.
std::string missing_folder(const std::string& path) {
  fs::path missing = fs::path(path).parent_path();
  std::error_code error;
  while (missing.has_parent_path() && missing.parent_path() != missing && !fs::exists(missing.parent_path(), error)) {
    missing = missing.parent_path();
  }
  return missing.string();
}

std::string advice(const std::string& path, int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "; free some space or write elsewhere with -o";
    case ENOENT:
      return fmt::format("; the folder '{}' is missing: make its folder first (mkdir -p) or write elsewhere with -o",
                         missing_folder(path));
    case ENOTDIR:
      return "; make its folder first or write elsewhere with -o";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a place you may write to with -o";
    case EISDIR:
      return "; name a file in it";
    default:
      return "";
  }
}

}  // namespace

// Opening such a path instead would start at the beginning of a file that somebody appends to.
std::optional<int> named_descriptor(std::string_view path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (path.substr(0, folder.size()) != folder) continue;
    int fd = -1;
    const char* end = path.data() + path.size();
    const auto [stopped, error] = std::from_chars(path.data() + folder.size(), end, fd);
    if (error == std::errc() && stopped == end && fd >= 0) return fd;
  }
  return std::nullopt;
}

Result<OutputTarget> output_target(const std::string& path) {
  if (const std::optional<int> fd = named_descriptor(path)) {
    return OutputTarget{OutputTarget::Kind::descriptor, path, *fd};
  }
  const Result<std::string> real = resolved(path);
  if (!real) return real.problems();
  struct stat status {};
  if (stat(real->c_str(), &status) != 0) {
    if (errno != ENOENT || fs::path(*real).filename().empty()) return write_problem(path, errno);
    return OutputTarget{OutputTarget::Kind::file, *real};
  }
  if (S_ISDIR(status.st_mode)) return write_problem(path, EISDIR);
  if (!S_ISREG(status.st_mode)) return OutputTarget{OutputTarget::Kind::special, *real};
  if (access(real->c_str(), W_OK) != 0) return write_problem(path, errno);
  return OutputTarget{OutputTarget::Kind::file, *real, -1,
                      FileIdentity{status.st_mode & 07777U, status.st_uid, status.st_gid}};
}

Problem write_problem(const std::string& path, int error) {
  const std::string shown = path == "-" ? "stdout" : path.empty() ? "''" : path;
  return {{shown}, fmt::format("cannot be written: {}{}", system_words(error), advice(path, error)), Trouble::output};
}

}  // namespace burin::cli
