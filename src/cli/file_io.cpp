#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include <burin/preset/nested_piece.hpp>
#include <burin/primitives/library.hpp>
#include <cli/file_io.hpp>
#include <cli/personal_folder.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

std::string size_text(std::size_t bytes) {
  const std::size_t mebi = std::size_t{1} << 20U;
  return bytes >= mebi ? fmt::format("{} MiB", bytes / mebi) : fmt::format("{} KiB", bytes / 1024);
}

Result<std::string> read_all(int fd, const std::string& shown, std::size_t limit_bytes) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (true) {
    const ssize_t got = read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Problem{{shown}, "cannot be read: " + system_words(errno)};
    if (got == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(got));
    if (text.size() > limit_bytes) {
      return Problem{{shown}, fmt::format("is larger than {}, the most that is read", size_text(limit_bytes))};
    }
  }
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Descriptor::~Descriptor() {
  close();
}

int Descriptor::close() {
  if (fd_ < 0) return 0;
  return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno;
}

std::string system_words(int error) {
  return std::generic_category().message(error);
}

int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Result<std::string> read_file(const std::string& path, const std::string& shown, std::size_t limit_bytes) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  if (!file.is_open()) return Problem{{shown}, "cannot be read: " + system_words(errno)};
  struct stat status {};
  if (fstat(file.get(), &status) != 0) return Problem{{shown}, "cannot be read: " + system_words(errno)};
  if (S_ISDIR(status.st_mode)) return Problem{{shown}, "is a folder, not a file"};
  return read_all(file.get(), shown, limit_bytes);
}

Result<std::string> read_stdin(std::size_t limit_bytes) {
  return read_all(STDIN_FILENO, "-", limit_bytes);
}

namespace {

/// Where the file lies that a preset of this folder calls `name`.
std::string path_of(const std::string& folder, std::string_view name) {
  constexpr std::string_view own_figures = primitives::personal_prefix;
  constexpr std::string_view library = preset::library_prefix;
  if (name.starts_with(own_figures)) {
    const std::filesystem::path own = personal_folder("primitives").value_or("");
    return (own / name.substr(own_figures.size())).string();
  }
  if (name.starts_with(library)) {
    return library_file(name.substr(library.size())).value_or(std::string(name));
  }
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

ReadFile data_reader(std::string folder) {
  return [folder = std::move(folder)](std::string_view name) -> Result<std::string> {
    const std::string path = path_of(folder, name);
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
      return Problem{{path}, "is no regular file; data is read from regular files only"};
    }
    return read_file(path, path, data_limit_bytes);
  };
}

}  // namespace burin::cli
