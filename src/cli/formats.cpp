#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <burin/base/suggest.hpp>
#include <burin/output/back_ends.hpp>
#include <cli/cairo_back_ends.hpp>
#include <cli/formats.hpp>

namespace burin::cli {

namespace {

/// Cairo's finish is the better default where both write a format, but for SVG.
std::string_view preferred_name(std::string_view format) {
  return format == "pdf" || format == "png" ? "cairo" : "native";
}

/// The core's back end of that name; null when there is none.
const BackEnd* native_writer(std::string_view format, std::string_view name) {
  for (const BackEnd& row : output::back_ends()) {
    if (row.format == format && row.name == name) return &row;
  }
  return nullptr;
}

std::vector<const BackEnd*> writers_of(std::string_view format) {
  std::vector<const BackEnd*> writers = all_back_ends();
  std::erase_if(writers, [&](const BackEnd* b) { return b->format != format; });
  return writers;
}

}  // namespace

std::vector<const BackEnd*> all_back_ends() {
  std::vector<const BackEnd*> all;
  for (const BackEnd& row : output::back_ends()) all.push_back(&row);
  for (const BackEnd& row : cairo_back_ends()) all.push_back(&row);
  return all;
}

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  for (const BackEnd* row : all_back_ends()) {
    if (std::find(names.begin(), names.end(), row->format) == names.end()) names.push_back(row->format);
  }
  return names;
}

Result<Done> check_format(std::string_view format) {
  const std::span<const BackEnd> native = output::back_ends();
  if (std::any_of(native.begin(), native.end(), [&](const BackEnd& b) { return b.format == format; })) return Done{};
  const std::vector<std::string_view> names = format_names();
  if (std::find(names.begin(), names.end(), format) != names.end()) return Done{};
  return Problem{{"burin draw"}, fmt::format("there is no format '{}'; formats: {}", format, fmt::join(names, ", "))};
}

Result<const BackEnd*> choose_back_end(std::string_view format, const std::optional<std::string>& name) {
  const std::string_view wanted = name ? std::string_view(*name) : preferred_name(format);
  if (const BackEnd* const row = native_writer(format, wanted)) return row;
  if (const Result<Done> known = check_format(format); !known) return known.problems();
  const std::vector<const BackEnd*> writers = writers_of(format);
  for (const BackEnd* row : writers) {
    if (row->name == wanted) return row;
  }
  if (!name) return writers.front();
  std::vector<std::string_view> names;
  for (const BackEnd* row : writers) names.push_back(row->name);
  return Problem{{"burin draw"},
                 fmt::format("no back end '{}' writes {} in this version; back ends of {}: {}", *name, format, format,
                             fmt::join(names, ", "))};
}

Result<std::string> format_of_suffix(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix.empty()) {
    return Problem{{"burin draw"},
                   fmt::format("'{}' has no suffix that tells its format; add one or --format: {}", path,
                               fmt::join(format_names(), ", "))};
  }
  suffix.erase(0, 1);
  for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (check_format(suffix)) return suffix;
  return Problem{{"burin draw"},
                 fmt::format("'{}': '.{}' is no format that burin writes; formats: {}", path, suffix,
                             fmt::join(format_names(), ", "))};
}

const std::vector<FormatOption>& format_options() {
  static const std::vector<FormatOption> rows{
      {"dpi", {"png"}},          {"size", {"png"}},           {"decimals", {"svg", "pdf"}, "native"},
      {"paper", {"svg", "pdf"}}, {"defs", {"svg"}, "native"}, {"view", {"svg", "pdf", "png", "dump"}}};
  return rows;
}

bool uses_option(const BackEnd& back_end, std::string_view option) {
  for (const FormatOption& row : format_options()) {
    if (row.option != option) continue;
    return (row.back_end.empty() || row.back_end == back_end.name) &&
           std::find(row.formats.begin(), row.formats.end(), back_end.format) != row.formats.end();
  }
  return true;
}

}  // namespace burin::cli
