#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>

#include <burin/base/result.hpp>

namespace burin::cli {

/// Mode and owner of a file that is replaced; the new one keeps them.
struct FileIdentity {
  mode_t mode;
  uid_t user;
  gid_t group;
};

/// What an output path means.
struct OutputTarget {
  enum class Kind : std::uint8_t {
    file,        ///< written beside and renamed; symbolic links are resolved
    special,     ///< a device or a fifo: written directly
    descriptor,  ///< stdout and the like: written directly
  };
  Kind kind = Kind::file;
  std::string path;                        ///< file, special
  int descriptor = -1;                     ///< descriptor
  std::optional<FileIdentity> replaces{};  ///< the regular file that is there now
};

/// The descriptor that a path such as "-" (stdout), /dev/stderr or /dev/fd/3 stands for.
std::optional<int> named_descriptor(std::string_view path);

/// Looks at what is at `path` ("-": stdout) without touching it. A folder and a write-protected file are problems.
Result<OutputTarget> output_target(const std::string& path);

/// "cannot be written: No space left on device; ..." with what to do about it.
Problem write_problem(const std::string& path, int error);

}  // namespace burin::cli
