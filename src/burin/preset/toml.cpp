#define TOML_HEADER_ONLY 0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <burin/preset/text_places.hpp>
#include <burin/preset/toml.hpp>
#include <burin/preset/toml_guard.hpp>
#include <burin/preset/toml_traps.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::Entry;
using params::Table;
using params::Value;

/// Turns toml++'s tree into ours.
class Converter {
 public:
  Converter(std::string_view text, std::string file, Findings& findings)
      : places_(text), file_(std::move(file)), findings_(findings) {}

  /// For a text that is not a file: everything in it is at `where`.
  Converter(const Where& where, Findings& findings) : places_({}), fixed_(where), findings_(findings) {}

  Where where(const toml::source_position& position) const {
    if (fixed_) return *fixed_;
    const std::size_t offset = places_.offset(position.line, position.column);
    return {file_, static_cast<int>(position.line), static_cast<int>(places_.byte_column(position.line, offset))};
  }

  Table table(const toml::table& source) {
    std::vector<std::pair<toml::source_position, Entry>> placed;
    for (const auto& [key, node] : source) {
      const toml::source_position begin = key.source().begin;
      placed.push_back({begin, {std::string(key.str()), where(begin), value(node)}});
    }
    // toml++ sorts by name; a preset's order is that of the file.
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Table result;
    for (auto& [position, entry] : placed) result.entries.push_back(std::move(entry));
    return result;
  }

  Value value(const toml::node& node) {
    const Where place = where(node.source().begin);
    if (const toml::table* inner = node.as_table()) return {place, table(*inner)};
    if (const toml::array* inner = node.as_array()) {
      Array array;
      for (const toml::node& item : *inner) array.push_back(value(item));
      return {place, std::move(array)};
    }
    if (const auto* text = node.as_string()) return {inside_quotes(place, node.source().begin), text->get()};
    if (const auto* whole = node.as_integer()) return {place, whole->get()};
    if (const auto* flag = node.as_boolean()) return {place, flag->get()};
    if (const auto* real = node.as_floating_point()) return number(place, real->get());
    findings_.report_and_hush(place, 1, "a date cannot be used here; put it in quotes if it is meant as text");
    return {place, std::string{}};
  }

 private:
  /// A text's place is its first character, so that columns inside of it can be added.
  Where inside_quotes(Where place, const toml::source_position& position) const {
    if (fixed_) return place;
    const std::string_view rest = places_.text().substr(places_.offset(position.line, position.column));
    const bool many_lines = rest.substr(0, 3) == "\"\"\"" || rest.substr(0, 3) == "'''";
    place.column += many_lines ? 3 : 1;
    if (many_lines && (rest.substr(3, 1) == "\n" || rest.substr(3, 2) == "\r\n")) {
      ++place.line;
      place.column = 1;
    }
    return place;
  }

  Value number(const Where& place, double real) {
    if (std::isfinite(real)) return {place, real};
    findings_.report_and_hush(
        place, 1, fmt::format("'{}' cannot be drawn; write a finite number", std::isnan(real) ? "nan" : "inf"));
    return {place, 0.0};
  }

  TextPlaces places_;
  std::string file_;
  std::optional<Where> fixed_;
  Findings& findings_;
};

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
  return text;
}

std::optional<Table> parse_toml(std::string_view text, const std::string& file, Findings& findings,
                                std::size_t most_bytes) {
  if (std::optional<Problem> refused = guard_toml(text, file, most_bytes)) {
    findings.problems.push_back(std::move(*refused));
    return std::nullopt;
  }
  Converter converter(text, file, findings);
  try {
    return converter.table(toml::parse(text));
  } catch (const toml::parse_error& error) {
    findings.problems.push_back(explain_syntax_error(text, converter.where(error.source().begin), error.description()));
    return std::nullopt;
  }
}

std::optional<Value> parse_toml_value(std::string_view text, const Where& where, Findings& findings) {
  const std::string statement = "value = " + std::string(text);
  if (guard_toml(statement, where.file, longest_preset_bytes)) return std::nullopt;
  try {
    const toml::table table = toml::parse(statement);
    const toml::node* node = table.get("value");
    if (table.size() != 1 || node == nullptr || node->is_date() || node->is_time() || node->is_date_time()) {
      return std::nullopt;
    }
    return Converter(where, findings).value(*node);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

}  // namespace burin::preset
