#include <algorithm>

#include <boost/program_options.hpp>
#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <cli/options.hpp>

namespace burin::cli {

namespace {

namespace po = boost::program_options;

po::options_description description_of(std::span<const OptionRow> rows) {
  po::options_description description;
  for (const OptionRow& row : rows) {
    std::string names(row.name);
    if (row.letter != 0) names += fmt::format(",{}", row.letter);
    if (row.value.empty()) {
      description.add_options()(names.c_str(), "");
    } else {
      description.add_options()(names.c_str(), po::value<std::string>(), "");
    }
  }
  return description;
}

const OptionRow* find_row(std::span<const OptionRow> rows, std::string_view name) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const OptionRow& r) {
    return r.name == name || (name.size() == 1 && r.letter == name.front());
  });
  return row == rows.end() ? nullptr : &*row;
}

std::string_view without_dashes(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
  return name;
}

std::string unknown_option(std::string_view who, std::string_view written, std::span<const OptionRow> rows) {
  const std::string_view shown = written.substr(0, written.find('='));
  std::vector<std::string_view> known;
  for (const OptionRow& row : rows) known.push_back(row.name);
  const std::string_view near = closest_word(without_dashes(shown), known);
  if (!near.empty()) return fmt::format("unknown option '{}'; did you mean '--{}'?", shown, near);
  return fmt::format("unknown option '{}'; '{} --help' lists the options", shown, who);
}

/// Program_options' error in our words.
std::string reworded(const po::error& error, std::span<const OptionRow> rows) {
  const auto* syntax = dynamic_cast<const po::invalid_syntax*>(&error);
  if (syntax == nullptr) return error.what();
  const OptionRow* row = find_row(rows, without_dashes(syntax->get_option_name()));
  if (row == nullptr) return error.what();
  switch (syntax->kind()) {
    case po::invalid_syntax::missing_parameter:
    case po::invalid_syntax::empty_adjacent_parameter:
      return fmt::format("option '{0}' needs a value: {0} {1}", option_name(*row), row->value);
    case po::invalid_syntax::extra_parameter:
      return fmt::format("option '{}' takes no value", option_name(*row));
    default:
      return error.what();
  }
}

Problems repeated_options(std::string_view who, std::span<const OptionRow> rows,
                          const std::vector<std::pair<std::string, std::string>>& given) {
  Problems problems;
  for (const OptionRow& row : rows) {
    const auto times = std::count_if(given.begin(), given.end(), [&](const auto& o) { return o.first == row.name; });
    if (times > 1 && !row.repeats && !row.value.empty()) {
      problems.push_back({{std::string(who)}, fmt::format("option '{}' is given {} times", option_name(row), times)});
    }
  }
  return problems;
}

}  // namespace

std::string option_name(const OptionRow& row) {
  return row.letter != 0 ? fmt::format("-{}", row.letter) : fmt::format("--{}", row.name);
}

bool Arguments::has(std::string_view option) const {
  return std::any_of(options_.begin(), options_.end(), [&](const auto& o) { return o.first == option; });
}

std::optional<std::string> Arguments::value(std::string_view option) const {
  const auto found = std::find_if(options_.begin(), options_.end(), [&](const auto& o) { return o.first == option; });
  return found == options_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> Arguments::values(std::string_view option) const {
  std::vector<std::string> all;
  for (const auto& [name, value] : options_) {
    if (name == option) all.push_back(value);
  }
  return all;
}

Result<Arguments> parse_arguments(std::string_view who, std::span<const OptionRow> rows,
                                  const std::vector<std::string>& command_line) {
  const po::options_description description = description_of(rows);
  Problems problems;
  std::vector<std::string> words;
  std::vector<std::pair<std::string, std::string>> options;
  try {
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    const po::parsed_options parsed =
        po::command_line_parser(command_line).options(description).style(style).allow_unregistered().run();
    for (const po::option& option : parsed.options) {
      if (option.unregistered) {
        problems.push_back({{std::string(who)}, unknown_option(who, option.original_tokens.front(), rows)});
      } else if (option.string_key.empty()) {
        words.insert(words.end(), option.value.begin(), option.value.end());
      } else {
        const OptionRow* row = find_row(rows, without_dashes(option.string_key));
        options.emplace_back(row->name, option.value.empty() ? std::string() : option.value.front());
      }
    }
  } catch (const po::error& error) {
    return Problem{{std::string(who)}, reworded(error, rows)};
  }
  if (problems.empty()) problems = repeated_options(who, rows, options);
  if (!problems.empty()) return problems;
  return Arguments(std::move(words), std::move(options));
}

}  // namespace burin::cli
