#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <burin/base/sha256.hpp>
#include <burin/base/suggest.hpp>
#include <burin/preset/defines.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/knobs.hpp>
#include <burin/preset/layer_names.hpp>
#include <burin/preset/layers.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/overrides.hpp>
#include <burin/preset/sections.hpp>
#include <burin/preset/substitute.hpp>
#include <burin/preset/toml.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::Entry;
using params::ReadContext;
using params::Table;
using params::Value;

constexpr std::int64_t edition = 1;

void check_edition(const Table& root, const Where& file, Findings& findings) {
  const Value* written = root.find("burin");
  if (written == nullptr) {
    findings.report(file, "the edition is missing; begin the preset with the line: burin = 1");
    return;
  }
  const auto* number = std::get_if<std::int64_t>(&written->data);
  if (number == nullptr) {
    findings.report(written->where, fmt::format("the edition is a whole number, not {}; write burin = {}",
                                                written->kind_name(), edition));
  } else if (*number != edition) {
    findings.report(written->where,
                    fmt::format("edition {} is unknown; this burin reads edition {}", *number, edition));
  }
}

void check_top_level(const Table& root, Findings& findings) {
  for (const Entry& entry : root.entries) {
    if (std::find(top_level_keys.begin(), top_level_keys.end(), entry.key) != top_level_keys.end()) continue;
    findings.report(entry.where,
                    fmt::format("unknown key '{}' in the preset{}", entry.key, suggestion(entry.key, top_level_keys)));
  }
}

std::uint64_t read_seed(const Table& root, const Overrides& overrides, Findings& findings) {
  std::uint64_t seed = Piece{}.seed;
  if (const Value* written = root.find("seed")) {
    const auto* number = std::get_if<std::int64_t>(&written->data);
    if (number == nullptr || *number < 0) {
      findings.report(written->where, "a seed is a whole number from 0 to 9223372036854775807");
    } else {
      seed = static_cast<std::uint64_t>(*number);
    }
  }
  return overrides.seed.value_or(seed);
}

/// Reads data files for values and notes what was read.
ReadFile noting(const ReadFile& read_file, std::vector<params::DataDigest>& data) {
  return [read_file, &data](std::string_view name) -> Result<std::string> {
    if (!read_file) return Problem{{}, fmt::format("data file '{}' cannot be read here", name)};
    Result<std::string> bytes = read_file(name);
    const bool noted = std::any_of(data.begin(), data.end(), [&](const auto& digest) { return digest.name == name; });
    if (bytes && !noted) data.push_back({std::string(name), sha256_hex(*bytes)});
    return bytes;
  };
}

/// The tree of a preset on its way to a piece, with what was found wrong.
struct Reading {
  Where file;  ///< the preset as a whole
  Table root;
  Findings findings;
  std::vector<params::DataDigest> data;

  ReadContext context(const ReadFile& read_file) {
    return {.problems = findings.problems,
            .evaluate = [](std::string_view text, const Where& where) { return expr::evaluate_constant(text, where); },
            .defined = [this](std::string_view name) -> const Value* {
              const Value* section = root.find("define");
              return section == nullptr || section->table() == nullptr ? nullptr : section->table()->find(name);
            },
            .read_file = noting(read_file, data)};
  }

  /// What is wrong, if anything, with the lines of `text`.
  std::optional<Problems> trouble(std::string_view text) const {
    Problems problems = findings.sorted(file.file);
    if (problems.empty()) return std::nullopt;
    attach_source(problems, file.file, text);
    return problems;
  }
};

void check_defines(const Table& root, Findings& findings) {
  const Value* section = root.find("define");
  if (section == nullptr || section->table() != nullptr) return;
  findings.report(section->where, fmt::format("'define' is a table: [define], not {}", section->kind_name()));
}

/// The knobs of a preset, and whether the seed went into what they were put in.
struct SetKnobs {
  std::vector<Knob> knobs;
  bool seed_was_used = false;
};

/// Sets the knobs and puts them in everywhere but in [knobs].
SetKnobs set_knobs(Reading& reading, std::uint64_t seed, const Overrides& overrides, ReadContext& context) {
  std::vector<Knob> knobs = read_knobs(reading.root, seed, overrides, context);
  Substitution substitution(knobs, seed, reading.findings);
  for (Entry& entry : reading.root.entries) {
    if (entry.key != "knobs") substitution.apply(entry.value);
  }
  return {std::move(knobs), substitution.seed_was_used()};
}

/// What captions may quote: the piece's seed does not make it random there, as it only labels the drawing.
std::vector<params::Placeholder> placeholders(const Piece& piece, const std::vector<Knob>& knobs) {
  std::vector<params::Placeholder> all{{"title", piece.about.title},
                                       {"author", piece.about.author},
                                       {"summary", piece.about.summary},
                                       {"seed", std::to_string(piece.seed)}};
  for (const Knob& knob : knobs) {
    if (knob.value) all.push_back({knob.name, scalar_text(*knob.value)});
  }
  return all;
}

Piece read_piece(Reading& reading, const Overrides& overrides, const ReadFile& read_file) {
  Findings& findings = reading.findings;
  Table& root = reading.root;
  apply_overrides(root, overrides, findings);
  check_edition(root, reading.file, findings);
  check_top_level(root, findings);
  check_defines(root, findings);
  ReadContext context = reading.context(read_file);
  context.nesting = overrides.nesting;
  Piece piece;
  piece.seed = read_seed(root, overrides, findings);
  const SetKnobs set = set_knobs(reading, piece.seed, overrides, context);
  piece.seed_in_values = set.seed_was_used;
  const Value* layers = root.find("layer");
  const std::vector<std::string> names =
      layers == nullptr || layers->array() == nullptr ? std::vector<std::string>{} : layer_names(*layers->array());
  resolve_likes(root, findings);
  piece.about = read_about(root, context);
  context.placeholders = placeholders(piece, set.knobs);
  const Palette* palette = read_palette(root, context);
  piece.page = read_page(root, reading.file, palette, context);
  if (overrides.enlarge) piece.enlarge_onto = read_enlarge(*overrides.enlarge, context);
  piece.pens = read_pens(root, palette, context);
  piece.slots = read_slots(root, context);
  read_layers(root, names, reading.file, read_images(root, context), piece, context);
  piece.warnings = std::move(context.warnings);
  return piece;
}

}  // namespace

Result<Piece> load(const Source& source, const Overrides& overrides, const ReadFile& read_file) {
  const std::string_view text = without_byte_order_mark(source.text);
  Reading reading{{source.name}, {}, {}, {}};
  Piece piece;
  if (std::optional<Table> root = parse_toml(text, source.name, reading.findings)) {
    reading.root = *std::move(root);
    piece = read_piece(reading, overrides, read_file);
  }
  if (std::optional<Problems> problems = reading.trouble(text)) return *std::move(problems);
  piece.data = std::move(reading.data);
  return piece;
}

Result<Summary> summarise(const Source& source, const Overrides& overrides) {
  const std::string_view text = without_byte_order_mark(source.text);
  Reading reading{{source.name}, {}, {}, {}};
  Summary summary;
  if (std::optional<Table> root = parse_toml(text, source.name, reading.findings)) {
    reading.root = *std::move(root);
    check_edition(reading.root, reading.file, reading.findings);
    ReadContext context = reading.context({});
    // Only what a summary tells is read; knobs stand in the texts of [about].
    std::erase_if(reading.root.entries, [](const Entry& entry) {
      return entry.key != "about" && entry.key != "knobs" && entry.key != "seed";
    });
    summary.seed = read_seed(reading.root, overrides, reading.findings);
    for (const Knob& knob : set_knobs(reading, summary.seed, overrides, context).knobs)
      summary.knobs.push_back(knob.info());
    summary.about = read_about(reading.root, context);
  }
  if (std::optional<Problems> problems = reading.trouble(text)) return *std::move(problems);
  return summary;
}

}  // namespace burin::preset
