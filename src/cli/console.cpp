#include <cerrno>
#include <cstdlib>
#include <unistd.h>

#include <fmt/format.h>

#include <cli/console.hpp>
#include <cli/file_io.hpp>

namespace burin::cli {

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::string coloured(std::string text) {
  constexpr std::string_view word = "error:";
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return text;
  return text.replace(at, word.size(), "\x1b[1;31merror:\x1b[0m");
}

}  // namespace

Console::Console(bool colour_allowed)
    : live_(isatty(STDERR_FILENO) == 1 && environment("TERM") != "dumb" && !environment("TERM").empty()),
      colour_(live_ && colour_allowed && environment("NO_COLOR").empty()) {}

ExitCode Console::print(std::string_view text) const {
  const int error = write_all(STDOUT_FILENO, text);
  if (error == 0) return ExitCode::done;
  if (error == EPIPE) return ExitCode::output;
  return fail({Problem{{"stdout"}, "cannot be written: " + system_words(error), Trouble::output}});
}

// Nothing is left to tell a user whose stderr fails, so these writes are not checked.
void Console::note(std::string_view text) const {
  write_all(STDERR_FILENO, text);
}

void Console::show(const Problems& problems) const {
  std::string text;
  for (const Problem& problem : problems) {
    text += (colour_ ? coloured(problem_text(problem)) : problem_text(problem)) + '\n';
  }
  note(text);
}

ExitCode Console::fail(const Problems& problems) const {
  show(problems);
  return exit_code(problems);
}

ExitCode Console::fail_usage(const Problems& problems, std::string_view help_command) const {
  show(problems);
  note(fmt::format("'{} --help' tells how it is used.\n", help_command));
  return ExitCode::usage;
}

}  // namespace burin::cli
