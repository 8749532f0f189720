#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/expr/expression.hpp>
#include <burin/params/fields.hpp>
#include <burin/preset/piece_values.hpp>
#include <cli/sheet_request.hpp>

namespace burin::cli {

namespace {

constexpr std::array own_rows{
    OptionRow{"page", 0, "SIZE", "the sheet: a4, a3, letter ... or 30x40cm (a4)"},
    OptionRow{"landscape", 0, "", "turn the sheet on its side"},
    OptionRow{"margin", 0, "LENGTHS", "of the sheet: one to four lengths, clockwise from the top (12mm)"},
    OptionRow{"columns", 0, "N", "cells in a row; else as large as they can be, or a row for each value of a sweep"},
    OptionRow{"gap", 0, "LENGTH", "between cells (5mm)"},
    OptionRow{"labels", 0, "KIND", "under each cell: values, numbers or none"},
    OptionRow{"no-frames", 0, "", "no line around each cell"},
};

bool is_own(std::string_view name) {
  return std::any_of(own_rows.begin(), own_rows.end(), [&](const OptionRow& row) { return row.name == name; });
}

/// Reads the value of an option as presets write it.
template <class T>
void read_option(const Arguments& arguments, std::string_view name, T& target, Problems& problems) {
  const std::optional<std::string> text = arguments.value(name);
  if (!text) return;
  const Where where{fmt::format("--{} {}", name, *text)};
  params::ReadContext context{
      .problems = problems,
      .evaluate = [](std::string_view number, const Where& at) { return expr::evaluate_constant(number, at); },
      .defined = {},
      .read_file = {}};
  params::ValueType<T>::read({where, *text}, target, context);
}

void read_columns(const Arguments& arguments, SheetStyle& style, Problems& problems) {
  const std::optional<std::string> text = arguments.value("columns");
  if (!text) return;
  constexpr double most = 1000.0;
  const std::optional<double> columns = parse_number(*text);
  if (!columns || *columns < 1.0 || *columns > most || *columns != std::floor(*columns)) {
    problems.push_back(
        {{"burin sheet"}, fmt::format("--columns must be a whole number from 1 to 1000, not '{}'", *text)});
    return;
  }
  style.columns = static_cast<std::size_t>(*columns);
}

void read_page(const Arguments& arguments, SheetStyle& style, Problems& problems) {
  preset::PageSize size;
  read_option(arguments, "page", size, problems);
  if (arguments.has("landscape") && size.width_mm < size.height_mm) std::swap(size.width_mm, size.height_mm);
  style.page.width_mm = size.width_mm;
  style.page.height_mm = size.height_mm;
  read_option(arguments, "margin", style.margin, problems);
  params::Length gap{style.gap_mm};
  read_option(arguments, "gap", gap, problems);
  style.gap_mm = gap.mm;
  if (gap.mm < 0.0) problems.push_back({{"burin sheet"}, "--gap must not be negative"});
}

/// A sheet is a page.
void refuse_model_space(const DrawRequest& request, Problems& problems) {
  for (const RequestedOutput& output : request.outputs) {
    if (output.back_end->space == Space::page) continue;
    problems.push_back({{"burin sheet"},
                        fmt::format("{} holds curves in their own units, and a sheet is a page; write "
                                    "svg, pdf, png or dump",
                                    output.back_end->format)});
  }
}

/// The options that only a sheet has, as they were given.
std::vector<std::string> own_words(const Arguments& arguments) {
  std::vector<std::string> words;
  for (const OptionRow& row : own_rows) {
    if (!arguments.has(row.name)) continue;
    words.push_back(row.value.empty() ? fmt::format("--{}", row.name)
                                      : fmt::format("--{} {}", row.name, *arguments.value(row.name)));
  }
  return words;
}

}  // namespace

std::span<const OptionRow> sheet_options() {
  static const std::vector<OptionRow> rows = [] {
    std::vector<OptionRow> all(own_rows.begin(), own_rows.end());
    for (const OptionRow& row : draw_options()) {
      if (!is_own(row.name)) all.push_back(row);
    }
    return all;
  }();
  return rows;
}

Result<SheetRequest> read_sheet_request(const Arguments& arguments) {
  Result<DrawRequest> draw = read_draw_request(arguments, "burin sheet");
  SheetRequest request;
  Problems problems = draw ? Problems() : draw.problems();
  read_page(arguments, request.style, problems);
  read_columns(arguments, request.style, problems);
  read_option(arguments, "labels", request.captions, problems);
  request.style.frames = !arguments.has("no-frames");
  if (draw) refuse_model_space(*draw, problems);
  if (!problems.empty()) return problems;
  request.draw = *std::move(draw);
  request.draw.overrides.page_size.reset();
  request.draw.overrides.landscape = false;
  request.draw.overrides.margin.reset();
  request.words = own_words(arguments);
  return request;
}

}  // namespace burin::cli
