#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <cli/formats.hpp>
#include <cli/output_target.hpp>
#include <cli/redraw_request.hpp>
#include <cli/single_request.hpp>

namespace burin::cli {

namespace {

using Options = std::vector<std::pair<std::string, std::string>>;

constexpr std::array own_rows{
    OptionRow{"data-folder", 0, "FOLDER",
              "read data files here, not beside FILE, in the current folder or the library"},
    OptionRow{"text", 0, "", "print the preset that FILE was drawn from, and draw nothing"},
};

/// What is typed takes the place of other recorded options besides its own: both cannot hold.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> displaced{{
    {"size", "dpi"},
    {"dpi", "size"},
    {"only", "skip"},
    {"skip", "only"},
    {"page", "enlarge"},
}};

std::string_view name_of_setting(std::string_view text) {
  return text.substr(0, text.find('='));
}

/// Whether what is typed takes the place of this recorded option.
bool is_replaced(const std::pair<std::string, std::string>& recorded, const Arguments& typed) {
  const auto& [option, value] = recorded;
  if (option == "knob" || option == "set") {
    const std::vector<std::string> now = typed.values(option);
    return std::any_of(now.begin(), now.end(), [&, &text = value](const std::string& setting) {
      return name_of_setting(setting) == name_of_setting(text);
    });
  }
  return typed.has(option) || std::any_of(displaced.begin(), displaced.end(), [&, &name = option](const auto& pair) {
           return pair.second == name && typed.has(pair.first);
         });
}

std::string recorded_value(const Recovered& recovered, std::string_view option) {
  for (const auto& [name, value] : recovered.options) {
    if (name == option) return value;
  }
  return {};
}

/// What was typed, as parse_arguments() found it.
Options typed_options(const Arguments& typed) {
  Options options;
  for (const OptionRow& row : draw_options()) {
    for (std::string& value : typed.values(row.name)) options.emplace_back(row.name, std::move(value));
  }
  return options;
}

/// A format for outputs whose name does not tell it, unless one was typed.
Options output_choices(const Recovered& recovered, const Arguments& typed, const std::string& file) {
  Options options;
  const std::string recorded_format = recorded_value(recovered, "format");
  const std::vector<std::string> paths = typed.values("output");
  const bool named = std::any_of(paths.begin(), paths.end(), [](const auto& path) { return !named_descriptor(path); });
  if (!named && !typed.has("format")) options.emplace_back("format", recorded_format);
  if (paths.empty()) {
    options.emplace_back("output", fmt::format("{}-redrawn.{}", std::filesystem::path(file).stem().string(),
                                               typed.value("format").value_or(recorded_format)));
  }
  return options;
}

bool is_format_choice(std::string_view option) {
  const std::vector<FormatOption>& rows = format_options();
  return option == "format" || option == "backend" ||
         std::any_of(rows.begin(), rows.end(), [&](const FormatOption& row) { return row.option == option; });
}

bool is_used(std::string_view option, const DrawRequest& request) {
  return std::any_of(request.outputs.begin(), request.outputs.end(),
                     [&](const RequestedOutput& output) { return uses_option(*output.back_end, option); });
}

}  // namespace

std::span<const OptionRow> redraw_options() {
  static const std::vector<OptionRow> rows = single_options(own_rows);
  return rows;
}

Result<DrawRequest> redraw_request(const Recovered& recovered, const Arguments& typed, const std::string& file) {
  Options options;
  Options format_choices;
  for (const auto& recorded : recovered.options) {
    if (is_replaced(recorded, typed)) continue;
    (is_format_choice(recorded.first) ? format_choices : options).push_back(recorded);
  }
  for (Options more : {typed_options(typed), output_choices(recovered, typed, file)}) {
    options.insert(options.end(), more.begin(), more.end());
  }
  const PreferredBackEnd recorded{recorded_value(recovered, "format"), recorded_value(recovered, "backend")};
  const auto read = [&] {
    return read_single_request(Arguments({recovered.preset.file}, options), "burin redraw", recorded);
  };

  // Which choices of the record are of use is known when the formats are.
  const Result<DrawRequest> outputs = read();
  if (!outputs) return outputs.problems();
  for (const auto& [option, value] : format_choices) {
    if (option != "format" && option != "backend" && is_used(option, *outputs)) options.emplace_back(option, value);
  }
  return read();
}

}  // namespace burin::cli
