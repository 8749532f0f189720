#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/suggest.hpp>
#include <burin/preset/toml.hpp>
#include <cli/file_io.hpp>
#include <cli/pen_sets.hpp>

namespace burin::cli {

namespace {

using params::Entry;
using params::Table;
using params::Value;

Problem problem(std::string message) {
  return {{"--pens"}, std::move(message)};
}

/// Empty without a home.
std::string pens_file() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string folder = variable("XDG_CONFIG_HOME"); !folder.empty()) return folder + "/burin/pens.toml";
  const std::string home = variable("HOME");
  return home.empty() ? "" : home + "/.config/burin/pens.toml";
}

/// A value of a pen as --set takes it.
std::string value_text(const Value& value) {
  if (const std::string* text = value.text()) return *text;
  if (const bool* flag = std::get_if<bool>(&value.data)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value.data)) return shortest_text(*number);
  std::string list;
  if (value.array() != nullptr) {
    for (const Value& item : *value.array()) list += (list.empty() ? "" : ", ") + value_text(item);
  }
  return '[' + list + ']';
}

std::string path_part(const std::string& name) {
  return name.find('.') == std::string::npos ? name : '"' + name + '"';
}

Result<PenKeys> keys_of(const Table& set, const std::string& file) {
  PenKeys keys;
  for (const Entry& pen : set.entries) {
    if (pen.value.table() == nullptr) {
      return Problem{pen.where,
                     fmt::format("pen '{}' in '{}' is a table such as {{ color = \"black\", width = \"0.4mm\" }}, "
                                 "not {}",
                                 pen.key, file, pen.value.kind_name())};
    }
    for (const Entry& key : pen.value.table()->entries) {
      keys.emplace_back(path_part(pen.key) + '.' + key.key, value_text(key.value));
    }
  }
  return keys;
}

}  // namespace

Result<PenKeys> read_pens_option(const std::string& word) {
  if (const std::size_t equals = word.find('='); equals != std::string::npos) {
    return PenKeys{{word.substr(0, equals), word.substr(equals + 1)}};
  }
  const std::string file = pens_file();
  if (file.empty()) return problem("no folder for pens.toml: neither XDG_CONFIG_HOME nor HOME is set");
  const Result<std::string> text = read_file(file, file, preset_limit_bytes);
  if (!text) return text.problems();
  preset::Findings findings;
  const std::optional<Table> root = preset::parse_toml(*text, file, findings);
  if (!root || !findings.empty()) return findings.sorted(file);
  std::vector<std::string_view> sets;
  for (const Entry& entry : root->entries) sets.push_back(entry.key);
  const Value* set = root->find(word);
  if (set == nullptr) return problem(fmt::format("no pens '{}' in '{}'{}", word, file, suggestion(word, sets)));
  if (set->table() != nullptr) return keys_of(*set->table(), file);
  return Problem{set->where, fmt::format("'{}' is a table of pens, not {}", word, set->kind_name())};
}

}  // namespace burin::cli
