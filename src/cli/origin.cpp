#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/formats.hpp>
#include <cli/origin.hpp>

namespace burin::cli {

namespace {

/// What a character other than a quote becomes in a TOML string. A tab and, in a text of lines, a newline may stand as
/// they are.
std::string escaped(char c, bool keep_newline) {
  const auto code = static_cast<unsigned char>(c);
  if (c == '\\') return "\\\\";
  if (c == '\t' || (c == '\n' && keep_newline)) return std::string(1, c);
  if (code < 0x20 || code == 0x7f) return fmt::format("\\u{:04X}", code);
  return std::string(1, c);
}

std::string list_of(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_string(text);
  return '[' + list + ']';
}

std::string list_of_pairs(const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : pairs) texts.push_back(name + '=' + value);
  return list_of(texts);
}

std::string format_flags(const DrawRequest& request, const BackEnd& back_end) {
  std::string text = fmt::format("format = \"{}\"\nbackend = \"{}\"\n", back_end.format, back_end.name);
  if (uses_option(back_end, "dpi")) {
    text += request.longer_side_px ? fmt::format("size = \"{}px\"\n", fixed_text(*request.longer_side_px, 0))
                                   : fmt::format("dpi = \"{}\"\n", shortest_text(request.dots_per_inch));
  }
  if (uses_option(back_end, "decimals")) text += fmt::format("decimals = \"{}\"\n", request.decimals);
  if (request.view && uses_option(back_end, "view")) text += fmt::format("view = {}\n", toml_string(request.view_text));
  if (request.paper && uses_option(back_end, "paper")) text += "paper = true\n";
  if (request.defs && uses_option(back_end, "defs")) text += "defs = true\n";
  if (request.all_points) text += "all-points = true\n";
  if (!request.only.empty()) text += fmt::format("only = {}\n", list_of(request.only));
  if (!request.skip.empty()) text += fmt::format("skip = {}\n", list_of(request.skip));
  return text;
}

}  // namespace

std::string toml_string(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? "\\\"" : escaped(c, false);
  return all + '"';
}

std::string toml_text(std::string_view text) {
  std::string all = "\"\"\"\n";
  bool after_quote = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '"') {
      all += escaped(c, true);
      after_quote = false;
      continue;
    }
    // No two quotes may stand together, nor one before the closing three.
    const bool keep = !after_quote && i + 1 < text.size();
    all += keep ? "\"" : "\\\"";
    after_quote = keep;
  }
  return all + "\"\"\"";
}

std::string origin_record(const DrawRequest& request, const BackEnd& back_end, const PresetText& preset,
                          const ReadPiece& piece) {
  const preset::Overrides& overrides = request.overrides;
  std::string text =
      fmt::format("burin = \"{}\"\npreset = {}\nseed = \"{}\"\n", BURIN_VERSION, toml_string(preset.file), piece.seed);
  if (!overrides.knobs.empty()) text += fmt::format("knobs = {}\n", list_of_pairs(overrides.knobs));
  if (!overrides.keys.empty()) text += fmt::format("set = {}\n", list_of_pairs(overrides.keys));
  if (!overrides.pens.empty()) text += fmt::format("pens = {}\n", list_of_pairs(overrides.pens));
  if (overrides.page_size) text += fmt::format("page = {}\n", toml_string(*overrides.page_size));
  if (overrides.landscape) text += "landscape = true\n";
  if (overrides.margin) text += fmt::format("margin = {}\n", toml_string(*overrides.margin));
  if (overrides.enlarge) text += fmt::format("enlarge = {}\n", toml_string(*overrides.enlarge));
  text += format_flags(request, back_end);
  text += fmt::format("text = {}\n", toml_text(preset.source.text));
  for (const params::DataDigest& data : piece.data) {
    text += fmt::format("\n[[data]]\nname = {}\nsha256 = \"{}\"\n", toml_string(data.name), data.sha256);
  }
  return text;
}

Origin make_origin(const DrawRequest& request, const BackEnd& back_end, const PresetText& preset,
                   const ReadPiece& piece) {
  const std::string& title = piece.about.title;
  return {title.empty() ? preset.stem : title, piece.about.author, piece.about.summary,
          origin_record(request, back_end, preset, piece)};
}

}  // namespace burin::cli
