#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/curves/svg/svg.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/layers.hpp>
#include <burin/preset/nested_piece.hpp>
#include <burin/preset/pen_gradient.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/primitives/figure_spec.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::ReadContext;
using params::Table;
using params::Value;

const std::string* text_of(const Table* table, std::string_view key) {
  const Value* value = table == nullptr ? nullptr : table->find(key);
  return value == nullptr ? nullptr : value->text();
}

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

/// "layer" when the curve does not tell.
std::string implied_name(const Value& layer) {
  const Value* curve = layer.table() == nullptr ? nullptr : layer.table()->find("curve");
  if (curve == nullptr) {
    const auto source = std::find_if(short_sources.begin(), short_sources.end(), [&](const ShortSource& s) {
      return layer.table() != nullptr && layer.table()->find(s.key) != nullptr;
    });
    if (source != short_sources.end()) return std::string(source->key);
    return layer.table() != nullptr && layer.table()->find("piece") != nullptr ? "piece" : "layer";
  }
  if (curve->text() != nullptr) return *curve->text();
  for (const char* key : {"like", "family"}) {
    if (const std::string* name = text_of(curve->table(), key)) return *name;
  }
  return "layer";
}

/// The known names that a layer may use, as suggestions need them.
template <class Named>
std::vector<std::string_view> names_of(const std::vector<Named>& all) {
  std::vector<std::string_view> names;
  for (const Named& each : all) names.push_back(each.name);
  return names;
}

class LayerReader {
 public:
  LayerReader(const Piece& piece, const std::vector<NamedImage>& images, const Table* defines, const Array& layers,
              const std::vector<std::string>& layer_names, ReadContext& context)
      : piece_(piece),
        images_(images),
        pens_(names_of(piece.pens)),
        slots_(names_of(piece.slots)),
        layers_(layer_names),
        context_(context) {
    for (const Value& layer : layers) {
      for (const char* key : {"clip", "outside"}) {
        if (const std::string* name = text_of(layer.table(), key)) clips_.push_back(*name);
      }
    }
    if (defines == nullptr) return;
    for (const params::Entry& entry : defines->entries) {
      if (entry.value.table() != nullptr && entry.value.table()->find("family") != nullptr) {
        curve_defines_.push_back(entry.key);
      }
    }
  }

  /// One layer, or those of the preset that it draws.
  std::vector<Layer> read(const Value& value, const std::string& name) {
    Layer layer;
    layer.where = value.where;
    const Table* table = value.table();
    if (table == nullptr) {
      params::report_kind(value, "a table: [[layer]]", context_);
      return {};
    }
    // Images lie over the layer's own slot.
    const std::string* slot = text_of(table, "slot");
    const SlotFrame frame = slot_frame(piece_.page, slot_called(piece_, slot == nullptr ? "" : *slot));
    context_.functions = image_functions(images_, frame);
    params::read_fields(*table, layer.style, "layer '" + name + "'", context_, source_keys());
    layer.style.name = name;
    check_style(*table, layer.style, value.where);
    read_source(*table, layer, name);
    settle_pens(layer);
    if (const Value* placing = table->find("primitives")) settle_primitives(*placing, layer);
    if (const Value* piece = table->find("piece")) return read_piece(*piece, *table, layer);
    return {std::move(layer)};
  }

  /// The pens of gradients and of other presets.
  const std::vector<NamedPen>& made_pens() const { return made_pens_; }

 private:
  bool is_known(const Value& name, std::string_view what, const std::vector<std::string_view>& known) {
    const std::string* text = name.text();
    if (text == nullptr || std::find(known.begin(), known.end(), *text) != known.end()) return true;
    context_.report(name.where, known.empty() ? fmt::format("no {} '{}': the preset has no [{}s]", what, *text, what)
                                              : fmt::format("no {} '{}'{}", what, *text, suggestion(*text, known)));
    return false;
  }

  void check_pens(const Value& pen) {
    is_known(pen, "pen", pens_);
    const auto check_all = [&](const Value* list) {
      if (list == nullptr || list->array() == nullptr) return;
      for (const Value& each : *list->array()) {
        if (each.text() == nullptr || *each.text() != no_pen) is_known(each, "pen", pens_);
      }
    };
    check_all(&pen);
    if (pen.table() == nullptr) return;
    check_all(pen.table()->find("of"));
    for (const char* end : {"from", "to"}) {
      if (const Value* name = pen.table()->find(end)) is_known(*name, "pen", pens_);
    }
  }

  const NamedPen* pen_called(const std::string& name) const {
    const auto found = std::ranges::find(piece_.pens, name, &NamedPen::name);
    return found == piece_.pens.end() ? nullptr : &*found;
  }

  /// The first pen for a layer without one, pens of its own for a gradient, turns by level where there are several.
  void settle_pens(Layer& layer) {
    PenChoice& pen = layer.style.pen;
    const NamedPen* from = pen_called(pen.from);
    const NamedPen* to = pen_called(pen.to);
    if (from != nullptr && to != nullptr) {
      const std::size_t count = pen.at.empty() ? layer.level_count() : pen.at.size() + 1;
      if (count == 1) {
        context_.report(layer.where,
                        fmt::format("layer '{}': pens from '{}' to '{}' need several levels, as in levels = "
                                    "\"0..5\", or bands: 'by' and 'at'",
                                    layer.style.name, pen.from, pen.to));
      }
      for (NamedPen& made : pens_between(*from, *to, count)) {
        pen.of.push_back(made.name);
        const bool is_known = pen_called(made.name) != nullptr ||
                              std::ranges::find(made_pens_, made.name, &NamedPen::name) != made_pens_.end();
        if (!is_known) made_pens_.push_back(std::move(made));
      }
    }
    if (pen.of.empty()) pen.of = {std::string(pens_.front())};
    if (!layer.coarser.empty()) primitives::turn_by_level(pen, layer.first_level);
  }

  void settle_primitives(const Value& value, Layer& layer) {
    std::optional<primitives::PlacingSpec>& placing = layer.style.primitives;
    if (!placing || value.table() == nullptr) return;
    if (!layer.coarser.empty()) primitives::turn_by_level(*placing, layer.first_level);
    const Value& use = *value.table()->find("use");
    for (std::size_t i = 0; i < placing->use.of.size(); ++i) {
      const std::string& name = placing->use.of[i];
      layer.figures.push_back(name == primitives::no_figure ? nullptr : read_figure(name, name_place(use, i)));
    }
  }

  /// Where figure i of a `use` stands.
  static const Where& name_place(const Value& use, std::size_t i) {
    const Value* of = use.table() == nullptr ? &use : use.table()->find("of");
    return of->array() == nullptr ? of->where : (*of->array())[i].where;
  }

  std::shared_ptr<const Figure> read_figure(const std::string& name, const Where& where) {
    const std::optional<primitives::Primitive> found = primitives::read_figure(name, where, context_);
    return found ? found->figure : nullptr;
  }

  void check_style(const Table& table, const LayerStyle& style, const Where& where) {
    if (const Value* pen = table.find("pen")) check_pens(*pen);
    if (const Value* fill = table.find("fill")) is_known(*fill, "pen", pens_);
    if (const Value* slot = table.find("slot")) is_known(*slot, "slot", slots_);
    const Value* stroke = table.find("stroke");
    if (stroke != nullptr && stroke->text() != nullptr && style.stroke != "none") {
      context_.report(
          stroke->where,
          fmt::format("'stroke' is \"none\" or left out, not '{}'; the pen is chosen by 'pen'", style.stroke));
    } else if (style.stroke == "none" && table.find("fill") == nullptr && !style.hide && !is_clip(style.name)) {
      context_.report(stroke == nullptr ? where : stroke->where,
                      "without stroke and 'fill' the layer draws nothing, and it neither hides nor clips others");
    }
    if (const Value* hidden = table.find("hidden")) is_known(*hidden, "pen", pens_);
    for (const char* key : {"clip", "outside"}) {
      if (const Value* clip = table.find(key)) check_clip(*clip, style);
    }
    if (const Value* dashes = table.find("dashes")) check_dashes(*dashes, style);
  }

  /// Whether another layer is clipped by the one of this name.
  bool is_clip(const std::string& name) const { return std::ranges::find(clips_, name) != clips_.end(); }

  void check_clip(const Value& value, const LayerStyle& style) {
    const std::string* name = value.text();
    if (name == nullptr) return;
    if (*name == style.name) {
      context_.report(value.where, fmt::format("layer '{}' cannot be clipped by itself", *name));
      return;
    }
    const std::vector<std::string_view> known(layers_.begin(), layers_.end());
    if (std::ranges::find(layers_, *name) == layers_.end()) {
      context_.report(value.where, fmt::format("no layer '{}'{} A plain shape is a table: {{ shape = \"disc\", r = "
                                               "\"70mm\" }}",
                                               *name, suggestion(*name, known)));
    }
  }

  void check_dashes(const Value& value, const LayerStyle& style) {
    constexpr std::size_t most_dashes = 64;
    double total_mm = 0.0;
    bool negative = false;
    for (const params::Length& length : style.dashes) {
      total_mm += length.mm;
      negative = negative || length.mm < 0.0;
    }
    const bool read = value.array() != nullptr && style.dashes.size() == value.array()->size();
    if (negative) {
      context_.report(value.where, "dashes cannot be shorter than 0");
    } else if (style.dashes.size() > most_dashes) {
      context_.report(value.where, fmt::format("at most {} dashes are allowed", most_dashes));
    } else if (read && !(total_mm > 0.0)) {
      context_.report(value.where, "dashes need a length above 0; leave them out for a full line");
    }
  }

  void read_curve(const Value& value, Layer& layer) {
    const Value* curve = &value;
    if (const std::string* name = value.text()) {
      curve = context_.defined(*name);
      if (curve == nullptr) return report_unknown_curve(*name, value.where);
    }
    const Table* table = curve->table();
    if (table == nullptr) {
      params::report_kind(*curve, "the name of a define or a table with 'family'", context_);
      return;
    }
    read_family(*table, curve->where, layer);
  }

  static std::vector<std::string_view> source_keys() {
    std::vector<std::string_view> keys{"curve", "piece"};
    for (const ShortSource& source : short_sources) keys.push_back(source.key);
    return keys;
  }

  /// The one source that a layer has.
  void read_source(const Table& table, Layer& layer, const std::string& name) {
    std::vector<std::string_view> given;
    for (const std::string_view key : source_keys()) {
      if (table.find(key) != nullptr) given.push_back(key);
    }
    if (given.empty()) {
      context_.report(
          layer.where,
          fmt::format("layer '{}' draws nothing; give it a 'curve', 'text', 'svg', 'shape' or 'piece'", name));
    } else if (given.size() > 1) {
      context_.report(
          table.find(given[1])->where,
          fmt::format("layer '{}' has a '{}' and a '{}'; give each its own layer", name, given[0], given[1]));
    } else if (given[0] == "curve") {
      read_curve(*table.find("curve"), layer);
    } else if (given[0] != "piece") {
      const auto source = std::find_if(short_sources.begin(), short_sources.end(),
                                       [&](const ShortSource& s) { return s.key == given[0]; });
      read_short_source(*table.find(source->key), *source, layer);
    }
    check_own_paint(table, layer);
  }

  std::vector<Layer> read_piece(const Value& value, const Table& table, const Layer& layer) {
    std::vector<NamedPen> pens = piece_.pens;
    pens.insert(pens.end(), made_pens_.begin(), made_pens_.end());
    const bool keeps_pen = table.find("pen") != nullptr;
    std::optional<NestedLayers> nested = read_nested_piece(value, layer, keeps_pen, pens, context_);
    if (!nested) return {};
    made_pens_.insert(made_pens_.end(), nested->pens.begin(), nested->pens.end());
    return std::move(nested->layers);
  }

  /// `text = "..."` and `text = { text = "...", ... }` are short for a curve of the family of that name.
  void read_short_source(const Value& value, const ShortSource& source, Layer& layer) {
    Table table;
    if (value.table() != nullptr) {
      table = *value.table();
    } else if (value.text() != nullptr) {
      table.set(std::string(source.main_field), value);
    } else {
      params::report_kind(value, source.expected, context_);
      return;
    }
    const Value* written = table.find("family");
    if (written != nullptr && (written->text() == nullptr || *written->text() != source.key)) {
      context_.report(written->where, fmt::format("'{}' has no other family; draw curves by 'curve'", source.key));
      return;
    }
    table.set("family", {value.where, std::string(source.key)});
    read_family(table, value.where, layer);
  }

  /// An SVG that is drawn as it paints itself is not painted by its layer too.
  void check_own_paint(const Table& table, const Layer& layer) {
    const auto* svg = std::any_cast<curves::SvgParams>(&layer.parameters);
    const Value* fill = table.find("fill");
    if (svg == nullptr || fill == nullptr || svg->parts == data::SvgParts::outlines) return;
    context_.report(fill->where,
                    "an svg fills itself, with the layer's pen; for an area in another pen make a layer with "
                    "parts = \"fills\", or fill its parts = \"outlines\"");
  }

  void read_family(const Table& table, const Where& where, Layer& layer) {
    const Value* family = table.find("family");
    if (family == nullptr) {
      context_.report(where, fmt::format("a curve needs a 'family'{}", suggestion("", family_names())));
      return;
    }
    if (family->text() == nullptr) {
      params::report_kind(*family, "the name of a family", context_);
      return;
    }
    layer.family = curves::find_family(*family->text());
    if (layer.family == nullptr) {
      context_.report(family->where,
                      fmt::format("no family '{}'{}", *family->text(), suggestion(*family->text(), family_names())));
      return;
    }
    if (const Value* levels = table.find("levels"); levels != nullptr && is_range(*levels)) {
      read_levels(table, *levels, layer);
    } else if (std::optional<std::any> parameters = layer.family->read(table, context_, {"family"})) {
      layer.parameters = *std::move(parameters);
    }
  }

  static bool is_range(const Value& value) {
    return value.text() != nullptr && value.text()->find("..") != std::string::npos;
  }

  /// levels = "0..5": the same curve at each of them.
  void read_levels(const Table& table, const Value& range, Layer& layer) {
    constexpr std::int64_t most_levels = 100;
    const std::string& text = *range.text();
    const std::size_t dots = text.find("..");
    std::int64_t first = 0;
    std::int64_t last = 0;
    const auto number = [&](std::string part, std::int64_t& target) {
      return params::ValueType<std::int64_t>::read({range.where, std::move(part)}, target, context_);
    };
    if (!number(text.substr(0, dots), first) || !number(text.substr(dots + 2), last)) return;
    if (first > last || last - first >= most_levels) {
      context_.report(range.where,
                      fmt::format("'levels': '{}' is no range of at most {} levels, the coarsest first, such "
                                  "as \"0..5\"",
                                  text, most_levels));
      return;
    }
    layer.first_level = static_cast<int>(first);
    // The finest first: what is wrong with one is wrong with all, and reported once.
    for (std::int64_t level = last; level >= first; --level) {
      Table at_level = table;
      at_level.set("levels", {range.where, level});
      std::optional<std::any> parameters = layer.family->read(at_level, context_, {"family"});
      if (!parameters) return;
      if (level == last) {
        layer.parameters = *std::move(parameters);
      } else {
        layer.coarser.insert(layer.coarser.begin(), *std::move(parameters));
      }
    }
  }

  void report_unknown_curve(const std::string& name, const Where& where) {
    if (curves::find_family(name) != nullptr) {
      context_.report(where, fmt::format("'{}' is a family; write curve = {{ family = \"{}\" }}", name, name));
      return;
    }
    context_.report(where, fmt::format("no curve '{}' in [define]{}", name, suggestion(name, curve_defines_)));
  }

  static std::vector<std::string_view> family_names() {
    std::vector<std::string_view> names;
    for (const curves::Family& family : curves::catalogue()) names.push_back(family.name);
    return names;
  }

  const Piece& piece_;
  const std::vector<NamedImage>& images_;
  std::vector<NamedPen> made_pens_;
  std::vector<std::string_view> pens_;
  std::vector<std::string_view> slots_;
  const std::vector<std::string>& layers_;
  std::vector<std::string> clips_;  ///< the layers that others are clipped by
  std::vector<std::string_view> curve_defines_;
  ReadContext& context_;
};

void report_repeated_names(const Array& layers, ReadContext& context) {
  std::set<std::string> seen;
  for (const Value& layer : layers) {
    const std::string* name = text_of(layer.table(), "name");
    if (name == nullptr || name->empty() || seen.insert(*name).second) continue;
    context.report(layer.table()->find("name")->where,
                   fmt::format("two layers are called '{}'; give each a name of its own", *name));
  }
}

}  // namespace

std::vector<std::string> layer_names(const Array& layers) {
  std::set<std::string> taken;
  std::map<std::string, int> last_numbers;
  std::vector<std::string> names;
  for (const Value& layer : layers) {
    const std::string* name = text_of(layer.table(), "name");
    names.push_back(name == nullptr ? std::string{} : *name);
    if (name != nullptr) taken.insert(*name);
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!names[i].empty()) continue;
    const std::string base = implied_name(layers[i]);
    names[i] = base;
    int& number = last_numbers[base];
    while (!taken.insert(names[i]).second) names[i] = fmt::format("{} {}", base, ++number + 1);
  }
  return names;
}

void read_layers(const Table& root, const std::vector<std::string>& names, const Where& file,
                 const std::vector<NamedImage>& images, Piece& piece, ReadContext& context) {
  const Value* section = root.find("layer");
  const Array* array = section == nullptr ? nullptr : section->array();
  if (section == nullptr || (array != nullptr && array->empty())) {
    context.report(section == nullptr ? file : section->where, "a preset needs at least one [[layer]]");
    return;
  }
  if (array == nullptr) {
    context.report(section->where, "each layer begins with [[layer]], in two pairs of brackets");
    return;
  }
  report_repeated_names(*array, context);
  const Value* defines = root.find("define");
  LayerReader reader(piece, images, defines == nullptr ? nullptr : defines->table(), *array, names, context);
  for (std::size_t i = 0; i < array->size(); ++i) {
    for (Layer& layer : reader.read((*array)[i], names[i])) piece.layers.push_back(std::move(layer));
  }
  piece.pens.insert(piece.pens.end(), reader.made_pens().begin(), reader.made_pens().end());
}

}  // namespace burin::preset
