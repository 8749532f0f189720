#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// What is changed in a preset from outside before it is read.
struct Overrides {
  std::vector<std::pair<std::string, std::string>> knobs;  ///< -D name=value
  std::vector<std::pair<std::string, std::string>> keys;   ///< --set page.margin=10mm, layer.NAME.opacity=0.5
  std::vector<std::pair<std::string, std::string>> pens;   ///< "ink.width", "0.4mm": where the preset has such a pen
  std::optional<std::uint64_t> seed;
  std::optional<std::string> page_size;
  bool landscape = false;
  std::optional<std::string> margin;
  std::optional<std::string> enlarge;  ///< a page to scale the finished sheet onto, pens and all
  int nesting = 0;                     ///< how many presets this one is drawn within
};

/// A preset as text, with the name it goes by in messages.
struct Source {
  std::string name;  ///< "presets/koch.toml", "koch", "-"
  std::string text;
};

/// Reads a preset: everything wrong with it is reported at once, with source lines, and nothing is drawn. `read_file`
/// reads its data files. At most 256 KiB of text.
Result<Piece> load(const Source& source, const Overrides& overrides, const ReadFile& read_file);

/// A knob as a preset declares it: for `burin show`, sliders and completion.
struct KnobInfo {
  std::string name;
  std::string kind;  ///< "whole number", "number", "color", "text", "true or false", "random"
  std::string default_text;
  std::string range;  ///< "[0, 1000]" or the choices
  std::string doc;
};

struct Summary {
  About about;
  std::uint64_t seed = 1;
  std::vector<KnobInfo> knobs;
};

/// What a preset says of itself, without reading its data files or layers. Of the overrides only knobs and the seed
/// count: a knob that cannot take its value is a problem.
Result<Summary> summarise(const Source& source, const Overrides& overrides = {});

/// A table of the preset format, for help and docs: "about", "page", "knob", "pen", "slot", "layer", "base", "motif".
struct FormatTable {
  std::string_view name;
  std::string_view summary;
  std::vector<params::FieldInfo> fields;
};
std::vector<FormatTable> format_tables();

}  // namespace burin::preset
