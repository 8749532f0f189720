#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::cli {

/// A row of a command's option table: what the parser accepts and what the help prints.
struct OptionRow {
  std::string_view name;   ///< long name without dashes
  char letter;             ///< short name, or 0
  std::string_view value;  ///< what its value is called in help; empty: a flag
  std::string_view doc;
  bool repeats = false;  ///< may be given several times
};

/// "--seed", "-D": how messages call an option.
std::string option_name(const OptionRow& row);

/// A command line taken apart.
class Arguments {
 public:
  Arguments(std::vector<std::string> words, std::vector<std::pair<std::string, std::string>> options)
      : words_(std::move(words)), options_(std::move(options)) {}

  /// What is not an option, in order.
  const std::vector<std::string>& words() const { return words_; }
  bool has(std::string_view option) const;
  std::optional<std::string> value(std::string_view option) const;
  /// All values of an option that repeats, in order.
  std::vector<std::string> values(std::string_view option) const;

 private:
  std::vector<std::string> words_;
  std::vector<std::pair<std::string, std::string>> options_;  ///< long name and value, in order
};

/// Options may stand before, between and after the words; "--" ends them. A value may begin with '-' unless it is an
/// option's name. Unknown options, missing and superfluous values and repetitions are problems, with `who` ("burin
/// draw") as their place.
Result<Arguments> parse_arguments(std::string_view who, std::span<const OptionRow> rows,
                                  const std::vector<std::string>& command_line);

}  // namespace burin::cli
