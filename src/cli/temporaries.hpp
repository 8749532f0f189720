#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <cli/file_io.hpp>

namespace burin::cli {

/// The temporary files of this run that still exist, so that a sudden end can remove them from another thread.
class Temporaries {
 public:
  void add(const std::string& path);
  void forget(const std::string& path);
  void remove_all();

 private:
  std::mutex mutex_;
  std::vector<std::string> paths_;
};

/// An open, locked, empty file in `folder` that no other process uses: its name holds our process id.
struct TemporaryFile {
  Descriptor file;
  std::string path;
  int error = 0;  ///< errno when it could not be made
};
TemporaryFile make_temporary(const std::string& folder);

/// Removes the temporary files that processes left in `folder` when they died: those whose process is gone and whose
/// lock is free.
void sweep_temporaries(const std::string& folder);

}  // namespace burin::cli
