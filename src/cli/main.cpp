#include <algorithm>
#include <csignal>
#include <exception>
#include <fcntl.h>
#include <new>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <cli/cairo_back_ends.hpp>
#include <cli/command.hpp>
#include <cli/help.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

/// A file must not become stdout because the caller closed it: a closed stream gets a descriptor that fails.
void fill_closed_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(fd, F_GETFD) == -1) open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

ExitCode unknown_command(const std::string& word, const Console& console) {
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  std::string hint = suggestion(word, names);
  if (closest_word(word, names).empty() && is_library_preset(word)) {
    hint = fmt::format("; to draw that preset: burin draw {}", word);
  }
  return console.fail_usage({Problem{{"burin"}, fmt::format("there is no command '{}'{}", word, hint)}}, "burin");
}

ExitCode run_command(const Command& command, const std::vector<std::string>& words, const Console& console) {
  const std::string who = fmt::format("burin {}", command.name);
  const std::vector<OptionRow> rows = all_options(command);
  const Result<Arguments> arguments = parse_arguments(who, rows, words);
  if (!arguments) return console.fail_usage(arguments.problems(), who);
  if (arguments->has("help")) return console.print(command_help(command));
  return command.run(*arguments, console);
}

ExitCode run(const std::vector<std::string>& words) {
  const Console console(std::find(words.begin(), words.end(), "--no-color") == words.end());
  if (words.empty()) return console.print(general_help());
  const std::string& first = words.front();
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (first == "--version" || first == "-V") return console.print(version_text() + '\n');
  if (first == "--help" || first == "-h" || first == "help") {
    if (rest.empty()) return console.print(general_help());
    const Command* command = find_command(rest.front());
    return command == nullptr ? unknown_command(rest.front(), console) : console.print(command_help(*command));
  }
  if (const Command* command = find_command(first)) return run_command(*command, rest, console);
  if (is_preset_path(first)) return run_command(draw_command(), words, console);
  return unknown_command(first, console);
}

/// An error that no room foresaw.
ExitCode internal_error(std::string_view what) {
  Console(false).fail({Problem{{"burin"}, fmt::format("internal error: {}; please report it", what)}});
  return ExitCode::failure;
}

ExitCode missing_library(std::string_view what) {
  Console(false).fail({Problem{{"burin"}, fmt::format("Cairo's back ends are not installed: {}", what)}});
  return ExitCode::failure;
}

}  // namespace

}  // namespace burin::cli

int main(int argc, char** argv) {
  using burin::cli::ExitCode;
  burin::cli::fill_closed_streams();
  // A reader that went away and a limit on the size of files are errors of write(), not deaths.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  ExitCode code = ExitCode::failure;
  try {
    code = burin::cli::run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  } catch (const std::bad_alloc&) {
    burin::cli::Console(false).note("burin: error: not enough memory; lower the levels or draw fewer layers at once\n");
    code = ExitCode::limit;
  } catch (const burin::cli::MissingLibrary& missing) {
    code = burin::cli::missing_library(missing.what());
  } catch (const std::exception& error) {
    code = burin::cli::internal_error(error.what());
  }
  return static_cast<int>(code);
}
