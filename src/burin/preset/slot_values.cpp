#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/suggest.hpp>
#include <burin/preset/piece_values.hpp>

namespace burin::params {

namespace {

using preset::Align;
using preset::Extent;
using preset::Grid;
using preset::SlotRect;
using preset::SymmetryName;

bool read_extent(const Where& where, std::string word, Extent& extent, ReadContext& context) {
  if (word.back() != '%') {
    Length length;
    if (!ValueType<Length>::read({where, std::move(word)}, length, context)) return false;
    extent = {length.mm, false};
    return true;
  }
  word.pop_back();
  double percent = 0.0;
  if (!read_number({where, std::move(word)}, percent, context)) return false;
  extent = {percent, true};
  return true;
}

std::string extent_text(const Extent& extent) {
  if (extent.value == 0.0) return "0";
  return shortest_text(extent.value) + (extent.percent ? "%" : "mm");
}

struct AlignWord {
  std::string_view word;
  int Align::*axis;
  int value;
};

constexpr std::array<AlignWord, 6> align_words{{{"left", &Align::x, -1},
                                                {"center", &Align::x, 0},
                                                {"right", &Align::x, 1},
                                                {"top", &Align::y, -1},
                                                {"middle", &Align::y, 0},
                                                {"bottom", &Align::y, 1}}};

constexpr std::array<std::string_view, 17> strip_and_plane_groups{"p111", "p1a1", "p1m1", "pm11", "p112", "pma2",
                                                                  "pmm2", "p1",   "p2",   "pm",   "pg",   "pmm",
                                                                  "p4",   "p4m",  "p3",   "p6",   "p6m"};

constexpr int most_turns = 360;

/// n of a rosette c_n or d_n.
std::optional<int> rosette_turns(std::string_view name) {
  if (name.size() < 2 || (name.front() != 'c' && name.front() != 'd') || name[1] == '0') return std::nullopt;
  int turns = 0;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + 1, end, turns);
  if (error != std::errc{} || stop != end || turns < 1) return std::nullopt;
  return turns;
}

}  // namespace

bool ValueType<SlotRect>::read(const Value& value, SlotRect& rect, ReadContext& context) {
  const std::string* text = value.text();
  if (text == nullptr) return report_kind(value, "a text \"x y w h\"", context);
  std::vector<std::string> parts = preset::split_words(*text);
  if (parts.size() != 4) {
    context.report(value.where, fmt::format("expected four parts \"x y w h\", found {}", parts.size()));
    return false;
  }
  SlotRect read;
  const std::array<Extent*, 4> extents{&read.x, &read.y, &read.width, &read.height};
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (!read_extent(value.where, std::move(parts[i]), *extents[i], context)) return false;
  }
  if (read.width.value <= 0.0 || read.height.value <= 0.0) {
    context.report(value.where, "width and height must be above 0");
    return false;
  }
  rect = read;
  return true;
}

std::string ValueType<SlotRect>::text(const SlotRect& rect) {
  return fmt::format("\"{} {} {} {}\"", extent_text(rect.x), extent_text(rect.y), extent_text(rect.width),
                     extent_text(rect.height));
}

bool ValueType<Align>::read(const Value& value, Align& align, ReadContext& context) {
  const std::string* text = value.text();
  const std::vector<std::string> parts = text == nullptr ? std::vector<std::string>{} : preset::split_words(*text);
  if (parts.empty() || parts.size() > 2) return report_kind(value, "one or two words such as \"left top\"", context);
  Align read;
  const AlignWord* before = nullptr;
  for (const std::string& part : parts) {
    const auto* const row = std::find_if(align_words.begin(), align_words.end(),
                                         [&](const AlignWord& known) { return known.word == part; });
    if (row == align_words.end()) {
      std::vector<std::string_view> known;
      for (const AlignWord& each : align_words) known.push_back(each.word);
      context.report(value.where, fmt::format("'{}' is no side{}", part, suggestion(part, known)));
      return false;
    }
    if (before != nullptr && before->axis == row->axis) {
      context.report(value.where, fmt::format("'{}' and '{}' are in the same direction", before->word, row->word));
      return false;
    }
    read.*(row->axis) = row->value;
    before = row;
  }
  align = read;
  return true;
}

std::string ValueType<Align>::text(const Align& align) {
  std::string_view across = "center";
  std::string_view down = "middle";
  for (const AlignWord& row : align_words) {
    if (row.axis == &Align::x && row.value == align.x) across = row.word;
    if (row.axis == &Align::y && row.value == align.y) down = row.word;
  }
  return fmt::format("\"{} {}\"", across, down);
}

bool ValueType<Grid>::read(const Value& value, Grid& grid, ReadContext& context) {
  const Array* array = value.array();
  if (array == nullptr || array->size() != 2) return report_kind(value, "a list [columns, rows]", context);
  Grid read;
  bool all = true;
  for (std::size_t i = 0; i < 2; ++i) {
    int& count = i == 0 ? read.columns : read.rows;
    if (!ValueType<int>::read((*array)[i], count, context)) {
      all = false;
    } else if (count < 1 || count > 1000) {
      context.report((*array)[i].where, fmt::format("{} {} is outside [1, 1000]", count, i == 0 ? "columns" : "rows"));
      all = false;
    }
  }
  if (all) grid = read;
  return all;
}

std::string ValueType<Grid>::text(const Grid& grid) {
  return fmt::format("[{}, {}]", grid.columns, grid.rows);
}

bool ValueType<SymmetryName>::read(const Value& value, SymmetryName& symmetry, ReadContext& context) {
  const std::string* text = value.text();
  if (text == nullptr) return report_kind(value, "the name of a symmetry such as \"d6\"", context);
  const std::optional<int> turns = rosette_turns(*text);
  if (turns && *turns > most_turns) {
    context.report(value.where, fmt::format("'{}' turns more than {} times", *text, most_turns));
    return false;
  }
  const auto& groups = strip_and_plane_groups;
  if (!turns && std::find(groups.begin(), groups.end(), *text) == groups.end()) {
    context.report(value.where, fmt::format("'{}' is no symmetry; known: rosettes c1 to c{}, d1 to d{}, {}", *text,
                                            most_turns, most_turns, fmt::join(groups, ", ")));
    return false;
  }
  symmetry.name = *text;
  return true;
}

std::string ValueType<SymmetryName>::text(const SymmetryName& symmetry) {
  return symmetry.name.empty() ? std::string{} : '"' + symmetry.name + '"';
}

}  // namespace burin::params
