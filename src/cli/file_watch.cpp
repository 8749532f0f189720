#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <cli/file_watch.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t happenings =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
constexpr int look_anyway_ms = 1000;
constexpr int look_untold_ms = 50;  ///< where Linux tells nothing
constexpr int quiet_ms = 8;
constexpr std::chrono::milliseconds longest_settling{100};
constexpr int most_links = 40;  // as the kernel

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

FileStamps stamps_now(const FileStamps& files) {
  FileStamps now;
  for (const auto& [path, stamp] : files) now.emplace(path, stamp_of(path));
  return now;
}

bool nothing_missing(const FileStamps& now, const FileStamps& seen) {
  return std::all_of(seen.begin(), seen.end(),
                     [&](const auto& file) { return !file.second.exists || now.at(file.first).exists; });
}

}  // namespace

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {};
  return {true, status.st_dev, status.st_ino, status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

FileWatch::FileWatch()
    : events_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), wake_up_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

bool FileWatch::wait_for_change(const FileStamps& seen, std::stop_token stop) {
  const std::stop_callback wake(stop, [this] {
    const std::uint64_t one = 1;
    write_all(wake_up_.get(), {reinterpret_cast<const char*>(&one), sizeof one});
  });
  while (!stop.stop_requested()) {
    told_ = events_.is_open();
    // Before looking, so that nothing between looking and waiting is missed. Folders may have been made anew.
    for (const auto& [path, stamp] : seen) watch_folders_of(path);
    if (stamps_now(seen) != seen) {
      settle(seen);
      return !stop.stop_requested();
    }
    wait(told_ ? look_anyway_ms : look_untold_ms);
  }
  return false;
}

/// The folder of the path, and those of the links that it leads through.
void FileWatch::watch_folders_of(const std::string& path) {
  fs::path at(path);
  for (int links = 0; links <= most_links; ++links) {
    fs::path folder = at.parent_path().empty() ? fs::path(".") : at.parent_path();
    // What is not there will be made in the nearest folder that is.
    while (!watch_folder(folder.string()) && folder.has_parent_path() && folder.parent_path() != folder) {
      folder = folder.parent_path();
    }
    std::error_code error;
    const fs::path next = fs::read_symlink(at, error);
    if (error) return;
    at = at.parent_path() / next;
  }
}

/// False: there is no such folder.
bool FileWatch::watch_folder(const std::string& folder) {
  if (!events_.is_open() || inotify_add_watch(events_.get(), folder.c_str(), happenings) >= 0) return true;
  if (errno == ENOENT || errno == ENOTDIR) return false;
  told_ = false;  // too many watches, or a folder that may not be read
  return true;
}

void FileWatch::wait(int milliseconds) {
  std::array<pollfd, 2> sources{pollfd{events_.get(), POLLIN, 0}, pollfd{wake_up_.get(), POLLIN, 0}};
  poll(sources.data(), sources.size(), milliseconds);
  std::array<char, 4096> ignored{};
  while (events_.is_open() && read(events_.get(), ignored.data(), ignored.size()) > 0) {
  }
}

void FileWatch::settle(const FileStamps& seen) {
  const Clock::time_point end = Clock::now() + longest_settling;
  FileStamps before = stamps_now(seen);
  while (Clock::now() < end) {
    wait(quiet_ms);
    FileStamps now = stamps_now(seen);
    if (now == before && nothing_missing(now, seen)) return;
    before = std::move(now);
  }
}

}  // namespace burin::cli
