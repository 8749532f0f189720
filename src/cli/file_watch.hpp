#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <string>

#include <cli/file_io.hpp>

namespace burin::cli {

/// What tells one state of a file from another. A file that is not there has one state.
struct FileStamp {
  bool exists = false;
  std::uint64_t device = 0;
  std::uint64_t number = 0;
  std::int64_t bytes = 0;
  std::int64_t modified_ns = 0;
  std::int64_t changed_ns = 0;

  bool operator==(const FileStamp&) const = default;
};

/// The state of the file at `path` now, through symbolic links.
FileStamp stamp_of(const std::string& path);

/// Files by path, each with its state when it was last looked at.
using FileStamps = std::map<std::string, FileStamp>;

/// Waits for files to change. Linux tells when something happens in their folders (inotify), whether a file is written,
/// replaced, removed or made again, or a link is turned; what counts is the files' state then. Once a second it is
/// looked at anyway, for file systems that tell nothing. The only file that names inotify.
class FileWatch {
 public:
  FileWatch();

  /// Waits until a file is not as in `seen`, and then until its writer seems to be done: for some milliseconds nothing
  /// happens, and nothing that was there is missing, or a tenth of a second is over. False: a stop was requested.
  bool wait_for_change(const FileStamps& seen, std::stop_token stop);

 private:
  void watch_folders_of(const std::string& path);
  bool watch_folder(const std::string& folder);
  /// Until something happens, a stop is requested, or the time is over.
  void wait(int milliseconds);
  void settle(const FileStamps& seen);

  Descriptor events_;
  Descriptor wake_up_;
  bool told_ = true;  ///< Linux tells of every folder
};

}  // namespace burin::cli
