#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cli/command.hpp>

namespace burin::cli {

/// "burin 0.1.0"
std::string version_text();

/// What a bare `burin` and `burin --help` print: from the table of commands.
std::string general_help();

/// `burin COMMAND --help`.
std::string command_help(const Command& command);

/// The command's options and those that every command has.
std::vector<OptionRow> all_options(const Command& command);

/// Text in lines of at most 80 columns, each after `indent` spaces; the first stands after `first_column` columns that
/// the caller has written. Line breaks in the text stay.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t first_column);

/// Two columns: names and wrapped texts.
std::string table_text(const std::vector<std::pair<std::string, std::string>>& rows);

}  // namespace burin::cli
