#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/two_point/dimension.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/path/colour.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/palettes.hpp>
#include <cli/command.hpp>
#include <cli/figure_library.hpp>
#include <cli/file_io.hpp>
#include <cli/formats.hpp>
#include <cli/help.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

namespace {

constexpr std::array examples{
    Example{"burin list", "the shipped presets, with titles"},
    Example{"burin list motifs", "motifs by name, with their dimensions"},
    Example{"burin list primitives", "the figures that can be placed, with their families"},
    Example{"burin list formats", "what burin can write"},
};

using Rows = std::vector<std::pair<std::string, std::string>>;

/// What a preset says of itself; one that cannot be read is still listed, since the user may be looking for it.
std::string preset_line(const ShippedPreset& preset) {
  const Result<std::string> text = read_file(preset.path, preset.path, preset_limit_bytes);
  if (!text) return "cannot be read";
  const Result<preset::Summary> summary = preset::summarise({preset.path, *text});
  if (!summary) return fmt::format("has problems; see burin check {}", preset.name);
  const preset::About& about = summary->about;
  return about.title + (about.title.empty() || about.summary.empty() ? "" : ": ") + about.summary;
}

std::string list_presets() {
  Rows rows;
  for (const ShippedPreset& preset : library_presets()) rows.emplace_back(preset.name, preset_line(preset));
  if (!rows.empty()) return table_text(rows);
  std::string text = "no presets found; looked in:\n";
  for (const std::string& folder : library_folders()) text += "  " + folder + '\n';
  return text;
}

std::string list_families() {
  Rows rows;
  for (const curves::Family& family : curves::catalogue()) rows.emplace_back(family.name, family.summary);
  return table_text(rows);
}

/// Name, dimension and summary; other names in brackets.
std::string list_motifs() {
  namespace two_point = curves::two_point;
  Rows rows;
  for (const two_point::NamedMotif& row : two_point::named_motifs()) {
    std::string text(row.summary);
    if (const auto dimension = two_point::similarity_dimension(two_point::motif_from(row))) {
      text = fmt::format("D {:.3f}  {}", *dimension, text);
    }
    if (!row.alias.empty()) text += fmt::format(" (or {})", row.alias);
    rows.emplace_back(row.name, text);
  }
  return table_text(rows);
}

std::string list_formats() {
  Rows rows;
  for (const BackEnd* row : all_back_ends()) {
    const Result<const BackEnd*> standard = choose_back_end(row->format, std::nullopt);
    const bool is_default = standard && *standard == row;
    rows.emplace_back(std::string(row->format) + (is_default ? "" : fmt::format(" --backend {}", row->name)),
                      row->summary);
  }
  return table_text(rows);
}

std::string list_colours() {
  Rows rows;
  for (const std::string_view name : colour_names()) {
    const std::optional<Colour> colour = parse_colour(name);
    rows.emplace_back(name, colour ? colour_text(*colour) : std::string());
  }
  return table_text(rows);
}

/// Name, family and title; the user's own are marked.
std::string list_primitives() {
  Rows rows;
  for (const LibraryFigure& figure : library_figures()) {
    const Result<primitives::Primitive> read = read_figure(figure.name);
    std::string text = figure.is_own ? "yours: " : "";
    text += !read                  ? "has problems"
            : read->family.empty() ? read->title
                                   : fmt::format("{}: {}", read->family, read->title);
    rows.emplace_back(figure.name, text);
  }
  return table_text(rows);
}

/// Name, colours and summary.
std::string list_palettes() {
  Rows rows;
  for (const preset::Palette& row : preset::palettes()) {
    rows.emplace_back(
        row.name, fmt::format("paper {}, ink {}, accent {}, soft {}: {}", colour_text(row.paper), colour_text(row.ink),
                              colour_text(row.accent), colour_text(row.soft), row.summary));
  }
  return table_text(rows);
}

struct Topic {
  std::string_view name;
  std::string (*text)();
};

constexpr std::array topics{Topic{"presets", &list_presets},  Topic{"families", &list_families},
                            Topic{"motifs", &list_motifs},    Topic{"primitives", &list_primitives},
                            Topic{"formats", &list_formats},  Topic{"colors", &list_colours},
                            Topic{"palettes", &list_palettes}};

ExitCode run(const Arguments& arguments, const Console& console) {
  const std::vector<std::string>& words = arguments.words();
  if (words.size() > 1) {
    return console.fail_usage({Problem{{"burin list"}, "list one thing at a time"}}, "burin list");
  }
  const std::string wanted = words.empty() ? std::string(topics.front().name) : words.front();
  std::vector<std::string_view> names;
  for (const Topic& topic : topics) {
    if (topic.name == wanted) return console.print(topic.text());
    names.push_back(topic.name);
  }
  return console.fail_usage(
      {Problem{{"burin list"}, fmt::format("there is no list of '{}'{}", wanted, suggestion(wanted, names))}},
      "burin list");
}

}  // namespace

Command list_command() {
  return {"list",
          "list presets, families, motifs, figures, formats ...",
          "[WHAT]",
          "WHAT is presets (as without it), families, motifs, primitives, formats, colors or palettes.\n\n"
          "Presets are looked up in the folders of $BURIN_PATH, in $XDG_DATA_HOME/burin/presets, and among those that "
          "came with burin; primitives, which are figures to be placed, in $XDG_DATA_HOME/burin/primitives.",
          {},
          examples,
          &run};
}

}  // namespace burin::cli
