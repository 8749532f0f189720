#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A place in a text the user wrote. Lines and columns count from 1; column counts bytes. Line 0: the whole file, or a
/// command line option whose words are then in `file` (for example "-D levels=9").
struct Where {
  std::string file;
  int line = 0;
  int column = 0;
};

/// What kind of trouble a problem is. The tool turns it into an exit code.
enum class Trouble : std::uint8_t {
  input,   ///< the preset, a data file or a value in them is wrong
  limit,   ///< asked for more than the limits allow
  output,  ///< a result could not be written
};

/// One thing that is wrong with what the user gave, in words that say what was expected and what to do.
struct Problem {
  Where where;
  std::string message;
  Trouble trouble = Trouble::input;
  std::string source_line{};  ///< the line of text at `where`, filled in by whoever holds the text
};

using Problems = std::vector<Problem>;

/// "file:line:col: error: message", then the source line and a caret when the line is known. No final newline.
std::string problem_text(const Problem& problem);

/// All problems, one after another, each ended by a newline.
std::string problems_text(const Problems& problems);

/// Fills `source_line` of every problem that points into `file` from that file's text.
void attach_source(Problems& problems, const std::string& file, std::string_view text);

}  // namespace burin
