#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/primitives/library.hpp>

namespace burin::primitives {

namespace {

constexpr std::string_view suffix = ".svg";

bool is_file_name(std::string_view word) {
  return word.find('/') != std::string_view::npos ||
         (word.size() > suffix.size() && word.substr(word.size() - suffix.size()) == suffix);
}

Problem unknown(std::string_view word) {
  std::vector<std::string_view> names;
  for (const ShippedFigure& figure : shipped_figures()) names.push_back(figure.name);
  return {
      {},
      fmt::format("no figure is called '{}'{}; 'burin list primitives' shows those there are, and a file of your own "
                  "is given with its suffix: '{}.svg'",
                  word, suggestion(word, names), word)};
}

}  // namespace

Result<Primitive> find_primitive(std::string_view word, const ReadFile& read_file, double tolerance) {
  if (is_file_name(word)) {
    const Result<std::string> text = read_file(word);
    if (!text) return text.problems();
    return read_primitive_svg(*text, std::string(word), tolerance);
  }
  const std::span<const ShippedFigure> shipped = shipped_figures();
  const auto row =
      std::lower_bound(shipped.begin(), shipped.end(), word,
                       [](const ShippedFigure& figure, std::string_view name) { return figure.name < name; });
  if (row != shipped.end() && row->name == word) {
    return read_primitive_svg(row->svg, fmt::format("{}{}", word, suffix), tolerance);
  }
  const std::string personal = fmt::format("{}{}{}", personal_prefix, word, suffix);
  if (const Result<std::string> text = read_file(personal)) return read_primitive_svg(*text, personal, tolerance);
  return unknown(word);
}

}  // namespace burin::primitives
