#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/suggest.hpp>
#include <burin/base/units.hpp>
#include <burin/preset/piece_values.hpp>

namespace burin::preset {

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  int parentheses = 0;
  bool inside = false;
  for (const char c : text) {
    const bool blank = (c == ' ' || c == '\t' || c == '\n' || c == '\r') && parentheses == 0;
    if (c == '(') ++parentheses;
    if (c == ')' && parentheses > 0) --parentheses;
    if (!blank && !inside) words.emplace_back();
    if (!blank) words.back() += c;
    inside = !blank;
  }
  return words;
}

}  // namespace burin::preset

namespace burin::params {

namespace {

using preset::Margins;
using preset::PageSize;

struct Paper {
  std::string_view name;
  double width_mm;
  double height_mm;
};

constexpr std::array<Paper, 18> papers{{
    {"a0", 841.0, 1189.0},
    {"a1", 594.0, 841.0},
    {"a2", 420.0, 594.0},
    {"a3", 297.0, 420.0},
    {"a4", 210.0, 297.0},
    {"a5", 148.0, 210.0},
    {"a6", 105.0, 148.0},
    {"b0", 1000.0, 1414.0},
    {"b1", 707.0, 1000.0},
    {"b2", 500.0, 707.0},
    {"b3", 353.0, 500.0},
    {"b4", 250.0, 353.0},
    {"b5", 176.0, 250.0},
    {"b6", 125.0, 176.0},
    {"letter", 215.9, 279.4},
    {"legal", 215.9, 355.6},
    {"tabloid", 279.4, 431.8},
    {"square", 210.0, 210.0},
}};

constexpr Range side_range_mm{1.0, 20000.0};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
}

/// The two sides of "30x40cm": at the first x that is no part of px, of a function's name or of something in
/// parentheses.
std::optional<std::pair<std::string, std::string>> split_sides(const std::string& text) {
  int parentheses = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++parentheses;
    if (text[at] == ')') --parentheses;
    if (text[at] != 'x' || parentheses > 0 || at == 0 || text[at - 1] == 'p') continue;
    if (at + 1 < text.size() && text[at + 1] == '(' && text[at - 1] == 'a') continue;
    return std::pair{trimmed(text.substr(0, at)), trimmed(text.substr(at + 1))};
  }
  return std::nullopt;
}

bool read_side(const Value& whole, std::string side, double& side_mm, ReadContext& context) {
  Length length;
  if (!ValueType<Length>::read({whole.where, std::move(side)}, length, context)) return false;
  if (!side_range_mm.contains(length.mm)) {
    context.report(whole.where, fmt::format("a side of {} mm is outside {} mm", shortest_text(length.mm),
                                            range_text(side_range_mm)));
    return false;
  }
  side_mm = length.mm;
  return true;
}

}  // namespace

bool ValueType<Colour>::read(const Value& value, Colour& colour, ReadContext& context) {
  const std::string* text = value.text();
  if (text == nullptr) return report_kind(value, "a color: a name such as \"black\" or \"#rrggbb\"", context);
  if (const std::optional<Colour> found = parse_colour(*text)) {
    colour = *found;
    return true;
  }
  // There are too many names to list them all.
  const std::string_view near = closest_word(lower_case(*text), colour_names());
  context.report(value.where, fmt::format("'{}' is no color{}", *text,
                                          near.empty() ? "; write a name such as black, or #rrggbb"
                                                       : fmt::format("; did you mean '{}'?", near)));
  return false;
}

std::string ValueType<Colour>::text(const Colour& colour) {
  return '"' + colour_text(colour) + '"';
}

bool ValueType<PageSize>::read(const Value& value, PageSize& size, ReadContext& context) {
  const std::string* text = value.text();
  if (text == nullptr) return report_kind(value, "a paper such as \"a4\" or \"30x40cm\"", context);
  const std::string lower = lower_case(*text);
  for (const Paper& paper : papers) {
    if (paper.name == lower) {
      size = {paper.width_mm, paper.height_mm};
      return true;
    }
  }
  auto sides = split_sides(*text);
  if (!sides || sides->first.empty() || sides->second.empty() ||
      lower.find_first_of("0123456789") == std::string::npos) {
    std::vector<std::string_view> known;
    for (const Paper& paper : papers) known.push_back(paper.name);
    context.report(value.where,
                   fmt::format("'{}' is no paper such as a4 or 30x40cm{}", *text, suggestion(lower, known)));
    return false;
  }
  // The unit may stand once, behind the second side.
  auto& [width, height] = *sides;
  if (unit_suffix_begin(width) == width.size()) width += height.substr(unit_suffix_begin(height));
  PageSize read;
  const bool width_read = read_side(value, width, read.width_mm, context);
  if (!read_side(value, height, read.height_mm, context) || !width_read) return false;
  size = read;
  return true;
}

std::string ValueType<PageSize>::text(const PageSize& size) {
  for (const Paper& paper : papers) {
    if (paper.width_mm == size.width_mm && paper.height_mm == size.height_mm)
      return '"' + std::string(paper.name) + '"';
  }
  return fmt::format("\"{}x{}mm\"", shortest_text(size.width_mm), shortest_text(size.height_mm));
}

bool ValueType<Margins>::read(const Value& value, Margins& margins, ReadContext& context) {
  std::vector<Value> sides;
  if (const std::string* text = value.text()) {
    for (std::string& word : preset::split_words(*text)) sides.push_back({value.where, std::move(word)});
  } else if (value.array() == nullptr && value.table() == nullptr) {
    sides.push_back(value);
  }
  if (sides.empty() || sides.size() > 4) return report_kind(value, "one to four lengths in a text", context);
  std::vector<double> mm;
  for (const Value& side : sides) {
    Length length;
    if (!ValueType<Length>::read(side, length, context)) return false;
    if (length.mm < 0.0) {
      context.report(value.where, fmt::format("a margin of {} mm is below 0", shortest_text(length.mm)));
      return false;
    }
    mm.push_back(length.mm);
  }
  const double top = mm[0];
  const double right = mm.size() > 1 ? mm[1] : top;
  const double bottom = mm.size() > 2 ? mm[2] : top;
  margins = {top, right, bottom, mm.size() > 3 ? mm[3] : right};
  return true;
}

std::string ValueType<Margins>::text(const Margins& margins) {
  return fmt::format("\"{}mm {}mm {}mm {}mm\"", shortest_text(margins.top_mm), shortest_text(margins.right_mm),
                     shortest_text(margins.bottom_mm), shortest_text(margins.left_mm));
}

}  // namespace burin::params
