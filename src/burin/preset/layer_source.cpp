#include <algorithm>
#include <any>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/curves/svg/svg.hpp>
#include <burin/preset/layer_source.hpp>

namespace burin::preset {

namespace {

using params::ReadContext;
using params::Table;
using params::Value;

/// A source of a layer that is short for a curve of the family of the same name.
struct ShortSource {
  std::string_view key;
  std::string_view main_field;  ///< what a value that is no table stands for
  std::string_view expected;
};

constexpr std::array<ShortSource, 3> short_sources{
    {{"text", "text", "what is written, or a table with 'text'"},
     {"svg", "file", "the name of an SVG file, or a table with 'file'"},
     {"shape", "kind", "a kind of shape such as \"disc\", or a table with 'kind'"}}};

bool is_range(const Value& value) {
  return value.text() != nullptr && value.text()->find("..") != std::string::npos;
}

/// levels = "0..5": the same curve at each of them.
void read_levels(const Table& table, const Value& range, Layer& layer, ReadContext& context) {
  constexpr std::int64_t most_levels = 100;
  const std::string& text = *range.text();
  const std::size_t dots = text.find("..");
  std::int64_t first = 0;
  std::int64_t last = 0;
  const auto number = [&](std::string part, std::int64_t& target) {
    return params::ValueType<std::int64_t>::read({range.where, std::move(part)}, target, context);
  };
  if (!number(text.substr(0, dots), first) || !number(text.substr(dots + 2), last)) return;
  if (first > last || last - first >= most_levels) {
    context.report(range.where, fmt::format("'levels': '{}' is no range of at most {} levels, the coarsest first, such "
                                            "as \"0..5\"",
                                            text, most_levels));
    return;
  }
  layer.first_level = static_cast<int>(first);
  // The finest first: what is wrong with one is wrong with all, and reported once.
  for (std::int64_t level = last; level >= first; --level) {
    Table at_level = table;
    at_level.set("levels", {range.where, level});
    std::optional<std::any> parameters = layer.family->read(at_level, context, {"family"});
    if (!parameters) return;
    if (level == last) {
      layer.parameters = *std::move(parameters);
    } else {
      layer.coarser.insert(layer.coarser.begin(), *std::move(parameters));
    }
  }
}

void read_family_curve(const Table& table, const Where& where, Layer& layer, ReadContext& context) {
  layer.family = curves::read_family(table, where, context);
  if (layer.family == nullptr) return;
  if (const Value* levels = table.find("levels"); levels != nullptr && is_range(*levels)) {
    read_levels(table, *levels, layer, context);
  } else if (std::optional<std::any> parameters = layer.family->read(table, context, {"family"})) {
    layer.parameters = *std::move(parameters);
  }
}

void report_unknown_curve(const std::string& name, const Where& where, const Table* defines, ReadContext& context) {
  if (curves::find_family(name) != nullptr) {
    context.report(where, fmt::format("'{}' is a family; write curve = {{ family = \"{}\" }}", name, name));
    return;
  }
  std::vector<std::string_view> known;
  if (defines != nullptr) {
    for (const params::Entry& entry : defines->entries) {
      if (entry.value.table() != nullptr && entry.value.table()->find("family") != nullptr) known.push_back(entry.key);
    }
  }
  context.report(where, fmt::format("no curve '{}' in [define]{}", name, suggestion(name, known)));
}

void read_curve(const Value& value, const Table* defines, Layer& layer, ReadContext& context) {
  const Value* curve = &value;
  if (const std::string* name = value.text()) {
    curve = context.defined(*name);
    if (curve == nullptr) return report_unknown_curve(*name, value.where, defines, context);
  }
  const Table* table = curve->table();
  if (table == nullptr) {
    params::report_kind(*curve, "the name of a define or a table with 'family'", context);
    return;
  }
  read_family_curve(*table, curve->where, layer, context);
}

/// `text = "..."` and `text = { text = "...", ... }` are short for a curve of the family of that name.
void read_short_source(const Value& value, const ShortSource& source, Layer& layer, ReadContext& context) {
  Table table;
  if (value.table() != nullptr) {
    table = *value.table();
  } else if (value.text() != nullptr) {
    table.set(std::string(source.main_field), value);
  } else {
    params::report_kind(value, source.expected, context);
    return;
  }
  const Value* written = table.find("family");
  if (written != nullptr && (written->text() == nullptr || *written->text() != source.key)) {
    context.report(written->where, fmt::format("'{}' has no other family; draw curves by 'curve'", source.key));
    return;
  }
  table.set("family", {value.where, std::string(source.key)});
  read_family_curve(table, value.where, layer, context);
}

/// An SVG that is drawn as it paints itself is not painted by its layer too.
void check_own_paint(const Table& table, const Layer& layer, ReadContext& context) {
  const auto* svg = std::any_cast<curves::SvgParams>(&layer.parameters);
  const Value* fill = table.find("fill");
  if (svg == nullptr || fill == nullptr || svg->parts == data::SvgParts::outlines) return;
  context.report(fill->where,
                 "an svg fills itself, with the layer's pen; for an area in another pen make a layer with "
                 "parts = \"fills\", or fill its parts = \"outlines\"");
}

}  // namespace

std::vector<std::string_view> source_keys() {
  std::vector<std::string_view> keys{"curve", "piece"};
  for (const ShortSource& source : short_sources) keys.push_back(source.key);
  return keys;
}

void read_source(const Table& table, const std::string& name, const Table* defines, Layer& layer,
                 ReadContext& context) {
  std::vector<std::string_view> given;
  for (const std::string_view key : source_keys()) {
    if (table.find(key) != nullptr) given.push_back(key);
  }
  if (given.empty()) {
    context.report(layer.where,
                   fmt::format("layer '{}' draws nothing; give it a 'curve', 'text', 'svg', 'shape' or 'piece'", name));
  } else if (given.size() > 1) {
    context.report(table.find(given[1])->where,
                   fmt::format("layer '{}' has a '{}' and a '{}'; give each its own layer", name, given[0], given[1]));
  } else if (given[0] == "curve") {
    read_curve(*table.find("curve"), defines, layer, context);
  } else if (given[0] != "piece") {
    const auto source = std::find_if(short_sources.begin(), short_sources.end(),
                                     [&](const ShortSource& s) { return s.key == given[0]; });
    read_short_source(*table.find(source->key), *source, layer, context);
  }
  check_own_paint(table, layer, context);
}

}  // namespace burin::preset
