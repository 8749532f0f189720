#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include <cli/temporaries.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view name_begin = ".burin-";
constexpr std::string_view name_end = ".tmp";

/// The process in ".burin-PID-N.tmp".
std::optional<pid_t> owner_of(std::string_view name) {
  if (name.substr(0, name_begin.size()) != name_begin || name.size() < name_begin.size() + name_end.size() ||
      name.substr(name.size() - name_end.size()) != name_end) {
    return std::nullopt;
  }
  name.remove_prefix(name_begin.size());
  pid_t owner = 0;
  const auto [stopped, error] = std::from_chars(name.data(), name.data() + name.size(), owner);
  if (error != std::errc() || *stopped != '-' || owner <= 0) return std::nullopt;
  return owner;
}

/// A lock outlives neither its process nor a container in which process ids mean something else.
bool is_abandoned(const std::string& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  return file.is_open() && flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

void Temporaries::add(const std::string& path) {
  const std::lock_guard lock(mutex_);
  paths_.push_back(path);
}

void Temporaries::forget(const std::string& path) {
  const std::lock_guard lock(mutex_);
  std::erase(paths_, path);
}

void Temporaries::remove_all() {
  const std::lock_guard lock(mutex_);
  for (const std::string& path : paths_) unlink(path.c_str());
  paths_.clear();
}

TemporaryFile make_temporary(const std::string& folder) {
  constexpr int most_tries = 10000;
  const fs::path place(folder.empty() ? "." : folder);
  for (int number = 0; number < most_tries; ++number) {
    std::string path = (place / fmt::format("{}{}-{}{}", name_begin, getpid(), number, name_end)).string();
    Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open()) {
      // A file system without locks only loses the second guard against sweeping.
      flock(file.get(), LOCK_EX | LOCK_NB);
      return {std::move(file), std::move(path)};
    }
    if (errno != EEXIST) return {Descriptor(), std::move(path), errno};
  }
  return {Descriptor(), {}, EEXIST};
}

void sweep_temporaries(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end; at.increment(error)) {
    const std::optional<pid_t> owner = owner_of(at->path().filename().string());
    const bool dead = owner && kill(*owner, 0) != 0 && errno == ESRCH;
    if (dead && is_abandoned(at->path().string())) unlink(at->path().c_str());
  }
}

}  // namespace burin::cli
