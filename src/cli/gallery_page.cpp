#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/xml_text.hpp>
#include <cli/gallery_page.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t columns = 4;
constexpr int overview_px = 180;

/// Text in which Markdown sees no marks.
std::string markdown_text(std::string_view text) {
  constexpr std::string_view marks = "\\`*_[]<>|&~#";
  std::string marked;
  for (const char c : text) {
    if (marks.find(c) != std::string_view::npos) marked += '\\';
    marked += c == '\n' ? ' ' : c;
  }
  return marked;
}

/// `text` as code where that can be, in a table too.
std::string code_text(std::string_view text) {
  if (text.empty()) return {};
  if (text.find_first_of("`|\n") != std::string_view::npos) return markdown_text(text);
  return fmt::format("`{}`", text);
}

const std::string& title_of(const GalleryEntry& entry) {
  return entry.summary.about.title.empty() ? entry.name : entry.summary.about.title;
}

/// Markdown has no table without a head, and no picture of a given size: so this is HTML.
std::string overview(const std::vector<GalleryEntry>& entries) {
  std::string text = "<table>\n";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const GalleryEntry& entry = entries[i];
    const bool upright = entry.page.height_mm > entry.page.width_mm;
    if (i % columns == 0) text += "<tr>\n";
    text += fmt::format(
        "<td align=\"center\" valign=\"bottom\"><a href=\"#{0}\"><img src=\"{0}.png\" {1}=\"{2}\" alt=\"{3}\"></a><br>"
        "<a href=\"#{0}\">{3}</a></td>\n",
        entry.name, upright ? "height" : "width", overview_px, xml_text(title_of(entry)));
    if (i % columns == columns - 1 || i + 1 == entries.size()) text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string facts(const GalleryEntry& entry) {
  std::string text = fmt::format("{} × {} mm, seed {}", fixed_text(entry.page.width_mm, 3),
                                 fixed_text(entry.page.height_mm, 3), entry.seed);
  if (!entry.uses_seed) text += " (nothing in it is random)";
  if (!entry.preset_path.empty()) text += fmt::format(", preset [{0}.toml]({1})", entry.name, entry.preset_path);
  const std::string& author = entry.summary.about.author;
  if (!author.empty()) text += ", by " + markdown_text(author);
  return text + ".\n";
}

std::string knobs_table(const std::vector<preset::KnobInfo>& knobs) {
  if (knobs.empty()) return "It has no knobs.\n";
  std::string text = "| knob | what it does | takes | default |\n|---|---|---|---|\n";
  for (const preset::KnobInfo& knob : knobs) {
    const std::string range = knob.range.empty() ? "" : " in " + markdown_text(knob.range);
    text += fmt::format("| `{}` | {} | {}{} | {} |\n", knob.name, markdown_text(knob.doc), markdown_text(knob.kind),
                        range, code_text(knob.default_text));
  }
  return text;
}

std::string section(const GalleryEntry& entry) {
  std::string text = fmt::format("<a id=\"{}\"></a>\n\n## {}\n\n", entry.name, markdown_text(title_of(entry)));
  if (!entry.summary.about.summary.empty()) text += markdown_text(entry.summary.about.summary) + "\n\n";
  text += fmt::format("[![{0}]({1}.png)]({1}.svg)\n\n", markdown_text(title_of(entry)), entry.name);
  text += fmt::format("    burin draw {0} --paper --defs -o {0}.svg\n\n", entry.name);
  return text + facts(entry) + '\n' + knobs_table(entry.summary.knobs);
}

}  // namespace

std::string gallery_page(const std::vector<GalleryEntry>& entries) {
  std::string text = fmt::format(
      "# Gallery\n\n<!-- 'burin gallery' writes this folder: change the presets and run it again. -->\n\n"
      "{} {} that burin draws, each from one small text file. A command below draws the piece again, to the byte; a "
      "knob "
      "is turned with `-D NAME=VALUE`, and what is random changes with `--seed`. A click on a picture opens the "
      "drawing "
      "itself.\n\n",
      entries.size(), entries.size() == 1 ? "piece" : "pieces");
  text += overview(entries);
  for (const GalleryEntry& entry : entries) text += '\n' + section(entry);
  return text;
}

std::string digests_text(const std::vector<GalleryEntry>& entries) {
  std::string text;
  for (const GalleryEntry& entry : entries) text += fmt::format("{}  {}\n", entry.dump_sha256, entry.name);
  return text;
}

std::vector<std::string> names_in_digests(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t blanks = line.find("  ");
    if (blanks != std::string_view::npos) names.emplace_back(line.substr(blanks + 2));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return names;
}

}  // namespace burin::cli
