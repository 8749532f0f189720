#include <algorithm>
#include <any>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/suggest.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/two_point/dimension.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/preset/family_parameters.hpp>
#include <burin/preset/load.hpp>
#include <cli/command.hpp>
#include <cli/figure_library.hpp>
#include <cli/figure_text.hpp>
#include <cli/file_io.hpp>
#include <cli/help.hpp>
#include <cli/motif_file.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

namespace two_point = curves::two_point;

constexpr std::array option_rows{
    OptionRow{"text", 0, "", "print the preset itself"},
    OptionRow{"parameter", 'D', "NAME=VALUE", "what is known of the curve of a family with this parameter", true},
    OptionRow{"motif", 0, "", "the motif of this name; with -o, the preset's motifs"},
    OptionRow{"primitive", 0, "", "the figure of this name, or of an SVG file"},
    OptionRow{"output", 'o', "FILE", "draw the motifs or the figure: .svg, .pdf, .png, or - for stdout"}};

constexpr std::array examples{
    Example{"burin show koch", "the knobs of a preset, with ranges and defaults"},
    Example{"burin show koch --text", "the preset itself"},
    Example{"burin show two-point", "the parameters of a curve family"},
    Example{"burin show four-parameter -D lambda=1/8 -D mu=1/8 -D omega=0", "how smooth a scheme's curves are"},
    Example{"burin show gosper", "source, dimension, marks and flags of a motif"},
    Example{"burin show dragon --motif -o motif.svg", "the motif of a preset, large, with its directions"},
    Example{"burin show leaf", "family, size and licence of a figure"},
    Example{"burin show leaf -o leaf.svg", "a figure, large, with its anchor"},
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

/// Of a family with parameters given, what is known of the curve; of a family alone, its parameters too.
ExitCode show_family(const curves::Family& family, const std::vector<std::string>& given, const Console& console) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      const std::string advice = fmt::format("-D needs a name and a value: -D name=value, not '{}'", text);
      return console.fail_usage({Problem{{"burin show"}, advice}}, "burin show");
    }
    values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  // Without data some families have nothing to draw; their parameters are told all the same.
  const Result<std::any> parameters = preset::family_parameters(family, values, data_reader("."));
  if (!parameters && !given.empty()) return console.fail(parameters.problems());
  std::string text = fmt::format("{}: {}\n", family.name, family.summary);
  if (!family.source.empty()) text += wrapped(fmt::format("source: {}", family.source), 0, 0);
  if (given.empty()) text += '\n' + fields_text(family.fields());
  if (family.theory == nullptr || !parameters) {
    if (given.empty()) return console.print(text);
    const std::string advice = fmt::format("of '{}' nothing is computed from parameters; leave out -D", family.name);
    return console.fail_usage({Problem{{"burin show"}, advice}}, "burin show");
  }
  return console.print(text + (given.empty() ? "\nof the curve with these defaults:\n" : "\n") +
                       family.theory(*parameters));
}

/// "1, 3": the sub-edges, from 1, that have a flag; "none".
std::string flagged_text(const std::vector<std::uint8_t>& flags) {
  std::string text;
  for (std::size_t j = 0; j < flags.size(); ++j) {
    if (flags[j] != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", j + 1);
  }
  return text.empty() ? "none" : text;
}

std::string motif_text(const two_point::NamedMotif& row) {
  const two_point::Motif motif = two_point::motif_from(row);
  std::string text = fmt::format("{}: {}\n", row.name, row.summary);
  if (!row.alias.empty()) text += fmt::format("also called: {}\n", row.alias);
  text += wrapped(fmt::format("source: {}", row.source), 0, 0);
  if (const std::optional<double> dimension = two_point::similarity_dimension(motif)) {
    text += fmt::format("dimension: {:.6f}", *dimension);
    text += row.dimension_note.empty() ? "\n" : fmt::format(" by its ratios only, since {}\n", row.dimension_note);
  }
  text += fmt::format("\nmotif = \"{}\" is short for\nmotif = {}\n", row.name, two_point::table_text(row));
  text += "\nmarks (along the edge, to the right of it):\n";
  for (const two_point::Mark& mark : motif.by_level.front().by_edge.front()) {
    text += fmt::format("  {:>9}  {:>9}\n", fixed_text(mark.alpha.low, 6), fixed_text(mark.beta.low, 6));
  }
  if (row.join) {
    text += fmt::format("drawn through the point ({}, {}) of every edge\n", shortest_text(row.join->x),
                        shortest_text(row.join->y));
  }
  if (row.sign) return text + fmt::format("sign: {}\n", params::ValueType<two_point::SignRule>::text(*motif.sign));
  return text + fmt::format("mirrored edges: {}\nedges built from their far end: {}\n", flagged_text(motif.flip),
                            flagged_text(motif.reverse));
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
  if (two_point::find_motif(name) != nullptr) {
    text += fmt::format("There is also a motif of this name: burin show {} --motif\n", name);
  }
  if (summary->knobs.empty()) return console.print(text + "\nIt has no knobs.\n");
  return console.print(text + fmt::format("\nknobs, turned with burin draw {} -D NAME=VALUE:\n", name) +
                       knobs_text(summary->knobs));
}

ExitCode unknown_name(const std::string& name, const std::vector<preset::FormatTable>& tables, const Console& console) {
  std::vector<std::string> names;
  for (const ShippedPreset& preset : library_presets()) names.push_back(preset.name);
  for (const curves::Family& family : curves::catalogue()) names.emplace_back(family.name);
  for (const preset::FormatTable& table : tables) names.emplace_back(table.name);
  for (const two_point::NamedMotif& motif : two_point::named_motifs()) names.emplace_back(motif.name);
  for (const LibraryFigure& figure : library_figures()) names.push_back(figure.name);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return console.fail({Problem{
      {"burin show"},
      fmt::format("no preset, family, motif, figure or table is called '{}'{}", name, suggestion(name, known))}});
}

/// --motif and --output.
ExitCode show_motif(const std::string& name, const Arguments& arguments, const Console& console) {
  if (const std::optional<std::string> path = arguments.value("output")) {
    return write_motif_file(name, *path, console);
  }
  if (const two_point::NamedMotif* row = two_point::find_motif(name)) return console.print(motif_text(*row));
  const std::string advice = fmt::format("no motif is called '{}'; to draw a preset's motifs add -o FILE.svg", name);
  return console.fail_usage({Problem{{"burin show --motif"}, advice}}, "burin show");
}

/// --primitive and --output.
ExitCode show_figure(const std::string& name, const Arguments& arguments, const Console& console) {
  const Result<primitives::Primitive> figure = read_figure(name);
  if (!figure) return console.fail(figure.problems());
  if (const std::optional<std::string> path = arguments.value("output")) {
    return write_figure_file(*figure, *path, console);
  }
  return console.print(figure_text(*figure));
}

/// What is shown when no option tells: the first kind of thing that has this name.
ExitCode show_whatever(const std::string& name, const Arguments& arguments, const Console& console) {
  if (is_preset_path(name) || is_library_preset(name)) return show_preset(name, false, console);
  if (const curves::Family* family = curves::find_family(name))
    return show_family(*family, arguments.values("parameter"), console);
  const std::vector<preset::FormatTable> tables = preset::format_tables();
  const auto table =
      std::find_if(tables.begin(), tables.end(), [&](const preset::FormatTable& t) { return t.name == name; });
  if (table != tables.end()) {
    return console.print(fmt::format("{}: {}\n\n", table->name, table->summary) + fields_text(table->fields));
  }
  if (const two_point::NamedMotif* row = two_point::find_motif(name)) return console.print(motif_text(*row));
  if (is_library_figure(name)) return show_figure(name, arguments, console);
  return unknown_name(name, tables, console);
}

ExitCode run(const Arguments& arguments, const Console& console) {
  if (arguments.words().size() != 1) {
    const std::string advice = "name one preset, family, motif, figure or table of the preset format";
    return console.fail_usage({Problem{{"burin show"}, advice}}, "burin show");
  }
  const std::string& name = arguments.words().front();
  const bool only_text = arguments.has("text");
  const bool motif = arguments.has("motif");
  const bool figure = arguments.has("primitive");
  if (arguments.has("parameter") && (only_text || motif || figure || curves::find_family(name) == nullptr)) {
    const std::string advice = fmt::format("-D NAME=VALUE goes with a curve family; '{}' is none", name);
    return console.fail_usage({Problem{{"burin show"}, advice}}, "burin show");
  }
  if (int{only_text} + int{motif} + int{figure} > 1) {
    return console.fail_usage({Problem{{"burin show"}, "--text, --motif and --primitive do not go together"}},
                              "burin show");
  }
  if (motif) return show_motif(name, arguments, console);
  if (figure) return show_figure(name, arguments, console);
  if (arguments.has("output")) {
    if (is_library_figure(name)) return show_figure(name, arguments, console);
    return console.fail_usage({Problem{{"burin show"}, "-o FILE needs --motif or the name of a figure"}}, "burin show");
  }
  return only_text ? show_preset(name, true, console) : show_whatever(name, arguments, console);
}

}  // namespace

Command show_command() {
  return {
      "show",
      "show a preset, family, motif, figure or table",
      "NAME [--text | -D NAME=VALUE | --motif|--primitive [-o FILE]]",
      "NAME is a preset (a name or a file), a curve family ('burin list families'), a motif ('burin list motifs'), "
      "a figure ('burin list primitives') or a table of the preset format: about, page, knob, pen, slot, layer. Where "
      "several have the name it is the first of these.\n\n"
      "Of a subdivision scheme (de-rham, four-point, four-parameter) it says how smooth the limit is: by the theorems "
      "of the paper, and proven and excluded by norms and spectral radii; -D gives the scheme its parameters.\n\n"
      "In a drawn motif the unit edge is dashed. A half arrow on an edge points the way in which it is built; its "
      "barb is on its right, or on its left where the edge is mirrored.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
