#include <algorithm>

#include <fmt/format.h>

#include <cli/help.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t columns = 80;
/// A name longer than this gets a line of its own, so that one long name does not push all texts to the right.
constexpr std::size_t widest_name = 24;

constexpr OptionRow no_color_option{"no-color", 0, "", "no colours in messages"};
constexpr OptionRow help_option{"help", 'h', "", "print this help"};

std::string option_words(const OptionRow& row) {
  std::string words = row.letter != 0 ? fmt::format("-{}, ", row.letter) : "    ";
  words += fmt::format("--{}", row.name);
  if (!row.value.empty()) words += fmt::format(" {}", row.value);
  return words;
}

}  // namespace

std::string version_text() {
  return "burin " BURIN_VERSION;
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t first_column) {
  std::string all;
  std::size_t column = first_column;
  if (column < indent) {
    all.append(indent - column, ' ');
    column = indent;
  }
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    if (column > indent && column + 1 + word.size() > columns) {
      all += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      all += ' ';
      ++column;
    }
    all += word;
    column += word.size();
    if (end < text.size() && text[end] == '\n') {
      all += '\n' + std::string(indent, ' ');
      column = indent;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all + '\n';
}

std::string table_text(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::size_t width = 0;
  for (const auto& [name, text] : rows) {
    if (name.size() <= widest_name) width = std::max(width, name.size());
  }
  const std::size_t indent = width + 4;
  std::string all;
  for (const auto& [name, text] : rows) {
    all += "  " + name;
    const bool own_line = name.size() > width;
    if (own_line) all += '\n';
    all += wrapped(text, indent, own_line ? 0 : name.size() + 2);
  }
  return all;
}

std::string general_help() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Command& command : commands()) rows.emplace_back(command.name, command.summary);
  return version_text() +
         ": engraves line art from small text files, true to the millimetre\n\n"
         "usage: burin COMMAND [WORDS] [OPTIONS]\n"
         "       burin FILE.toml [OPTIONS]     the same as burin draw FILE.toml\n\n" +
         table_text(rows) +
         "\n"
         "  burin draw koch                         a first picture: koch.svg\n"
         "  burin draw koch -D levels=3 -o k.svg    the same, one knob turned\n\n"
         "'burin COMMAND --help' tells more; 'burin --version' prints the version.\n";
}

std::vector<OptionRow> all_options(const Command& command) {
  std::vector<OptionRow> all(command.options.begin(), command.options.end());
  all.push_back(no_color_option);
  all.push_back(help_option);
  return all;
}

std::string command_help(const Command& command) {
  std::string text =
      fmt::format("burin {}: {}\n\nusage: burin {} {}\n\n", command.name, command.summary, command.name, command.usage);
  if (!command.details.empty()) text += wrapped(command.details, 0, 0) + '\n';
  std::vector<std::pair<std::string, std::string>> rows;
  for (const OptionRow& row : all_options(command)) {
    rows.emplace_back(option_words(row), std::string(row.doc) + (row.repeats ? "; may be repeated" : ""));
  }
  text += "options:\n" + table_text(rows) + "\nexamples:\n";
  for (const Example& example : command.examples) {
    text += fmt::format("  {}\n      {}\n", example.line, example.what);
  }
  return text;
}

}  // namespace burin::cli
