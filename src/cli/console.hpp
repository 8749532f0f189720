#pragma once

#include <string>
#include <string_view>

#include <burin/base/problem.hpp>
#include <cli/exit_code.hpp>

namespace burin::cli {

/// What the tool says: results on stdout, everything else on stderr.
class Console {
 public:
  /// Colours and progress are for terminals only, and neither with NO_COLOR, TERM=dumb nor --no-color for colours.
  explicit Console(bool colour_allowed);

  /// Whether stderr can show a line that rewrites itself.
  bool shows_progress() const { return live_; }

  /// A result on stdout. A failed write is reported, but for a reader that went away.
  ExitCode print(std::string_view text) const;
  /// Something worth knowing, on stderr.
  void note(std::string_view text) const;
  /// Problems on stderr; returns the exit code they stand for.
  ExitCode fail(const Problems& problems) const;
  /// Problems of the command line, and where to read on.
  ExitCode fail_usage(const Problems& problems, std::string_view help_command) const;

 private:
  void show(const Problems& problems) const;

  bool live_;
  bool colour_;
};

}  // namespace burin::cli
