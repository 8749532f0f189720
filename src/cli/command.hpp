#pragma once

#include <span>
#include <string_view>

#include <cli/console.hpp>
#include <cli/exit_code.hpp>
#include <cli/options.hpp>

namespace burin::cli {

/// A line that a reader can paste, and what it does. A test runs every one of them.
struct Example {
  std::string_view line;
  std::string_view what;
  bool endless = false;  ///< runs until Ctrl-C
};

/// A row of the table of commands: all that is known of one. Its file defines the function that returns the row.
struct Command {
  std::string_view name;
  std::string_view summary;
  std::string_view usage;    ///< after "burin NAME "
  std::string_view details;  ///< paragraphs for its help
  std::span<const OptionRow> options;
  std::span<const Example> examples;
  ExitCode (*run)(const Arguments& arguments, const Console& console);
};

Command draw_command();
Command sheet_command();
Command redraw_command();
Command watch_command();
Command list_command();
Command show_command();
Command check_command();
Command new_command();
Command gallery_command();
Command primitives_command();
Command measure_command();
Command golden_command();
Command diff_command();
Command fit_command();

/// All commands, in the order of the help.
std::span<const Command> commands();

/// The command of this name, or null.
const Command* find_command(std::string_view name);

}  // namespace burin::cli
