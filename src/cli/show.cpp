#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/curves/family.hpp>
#include <burin/preset/load.hpp>
#include <cli/command.hpp>
#include <cli/help.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

constexpr std::array option_rows{OptionRow{"text", 0, "", "print the preset itself"}};

constexpr std::array examples{
    Example{"burin show koch", "the knobs of a preset, with ranges and defaults"},
    Example{"burin show koch --text", "the preset itself"},
    Example{"burin show two-point", "the parameters of a curve family"},
    Example{"burin show layer", "the keys of a [[layer]] in a preset"},
};

std::string fields_text(const std::vector<params::FieldInfo>& fields) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const params::FieldInfo& field : fields) {
    std::string text = fmt::format("{}\n{}", field.doc, field.type);
    if (!field.range.empty()) text += fmt::format(" in {}", field.range);
    if (!field.default_text.empty()) text += fmt::format(", default {}", field.default_text);
    rows.emplace_back(field.name, text);
  }
  return table_text(rows);
}

std::string family_text(const curves::Family& family) {
  return fmt::format("{}: {}\n", family.name, family.summary) +
         (family.source.empty() ? "" : fmt::format("source: {}\n", family.source)) + '\n' +
         fields_text(family.fields());
}

std::string knobs_text(const std::vector<preset::KnobInfo>& knobs) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const preset::KnobInfo& knob : knobs) {
    std::string text = knob.kind;
    if (!knob.range.empty()) text += fmt::format(" in {}", knob.range);
    if (!knob.default_text.empty()) text += fmt::format(", default {}", knob.default_text);
    if (!knob.doc.empty()) text = fmt::format("{}\n{}", knob.doc, text);
    rows.emplace_back(knob.name, text);
  }
  return table_text(rows);
}

ExitCode show_preset(const std::string& name, bool only_text, const Console& console) {
  const Result<PresetText> preset = read_preset(name);
  if (!preset) return console.fail(preset.problems());
  if (only_text) return console.print(preset->source.text);
  const Result<preset::Summary> summary = preset::summarise(preset->source);
  if (!summary) return console.fail(summary.problems());
  const preset::About& about = summary->about;
  std::string text = about.title.empty() ? preset->stem : about.title;
  if (!about.author.empty()) text += " by " + about.author;
  text += '\n';
  if (!about.summary.empty()) text += wrapped(about.summary, 0, 0);
  text += fmt::format("file: {}\n", preset->source.name);
  if (summary->knobs.empty()) return console.print(text + "\nIt has no knobs.\n");
  return console.print(text + fmt::format("\nknobs, turned with burin draw {} -D NAME=VALUE:\n", name) +
                       knobs_text(summary->knobs));
}

ExitCode unknown_name(const std::string& name, const std::vector<preset::FormatTable>& tables, const Console& console) {
  std::vector<std::string> names;
  for (const ShippedPreset& preset : library_presets()) names.push_back(preset.name);
  for (const curves::Family& family : curves::catalogue()) names.emplace_back(family.name);
  for (const preset::FormatTable& table : tables) names.emplace_back(table.name);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return console.fail({Problem{
      {"burin show"}, fmt::format("no preset, family or table is called '{}'{}", name, suggestion(name, known))}});
}

ExitCode run(const Arguments& arguments, const Console& console) {
  if (arguments.words().size() != 1) {
    return console.fail_usage({Problem{{"burin show"}, "name one preset, family or table of the preset format"}},
                              "burin show");
  }
  const std::string& name = arguments.words().front();
  const bool only_text = arguments.has("text");
  if (only_text || is_preset_path(name) || is_library_preset(name)) return show_preset(name, only_text, console);
  if (const curves::Family* family = curves::find_family(name)) return console.print(family_text(*family));
  const std::vector<preset::FormatTable> tables = preset::format_tables();
  const auto table =
      std::find_if(tables.begin(), tables.end(), [&](const preset::FormatTable& t) { return t.name == name; });
  if (table == tables.end()) return unknown_name(name, tables, console);
  return console.print(fmt::format("{}: {}\n\n", table->name, table->summary) + fields_text(table->fields));
}

}  // namespace

Command show_command() {
  return {"show",
          "show a preset's knobs, a family's parameters, a table's keys",
          "NAME [--text]",
          "NAME is a preset (a name or a file), a curve family ('burin list families'), or a table of the preset "
          "format: about, page, knob, pen, slot, layer.",
          option_rows,
          examples,
          &run};
}

}  // namespace burin::cli
