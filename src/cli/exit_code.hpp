#pragma once

#include <burin/base/problem.hpp>

namespace burin::cli {

/// How the tool ends; the numbers are documented and stable.
enum class ExitCode : int {
  done = 0,
  failure = 1,    ///< something that should not happen
  different = 1,  ///< what was compared is not the same
  usage = 2,      ///< the command line is wrong
  input = 3,      ///< a preset or its data is wrong
  limit = 4,      ///< more was asked for than the limits allow
  output = 5,     ///< a result could not be written
  interrupted = 130,
  terminated = 143,
};

/// What the first of these problems makes of the run. Pre: not empty.
inline ExitCode exit_code(const Problems& problems) {
  switch (problems.front().trouble) {
    case Trouble::limit:
      return ExitCode::limit;
    case Trouble::output:
      return ExitCode::output;
    case Trouble::input:
      break;
  }
  return ExitCode::input;
}

}  // namespace burin::cli
