#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <burin/preset/layer_checks.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/layer_names.hpp>
#include <burin/preset/layer_source.hpp>
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

KnownNames known_names(const Piece& piece, const Array& layers, const std::vector<std::string>& names) {
  KnownNames known;
  for (const NamedPen& pen : piece.pens) known.pens.push_back(pen.name);
  for (const NamedSlot& slot : piece.slots) known.slots.push_back(slot.name);
  known.layers.assign(names.begin(), names.end());
  for (const Value& layer : layers) {
    for (const char* key : {"clip", "outside"}) {
      if (const std::string* name = text_at(layer.table(), key)) known.clips.push_back(*name);
    }
  }
  return known;
}

class LayerReader {
 public:
  /// `known` must hold a pen; `defines` may be null.
  LayerReader(const Piece& piece, const std::vector<NamedImage>& images, const Table* defines, KnownNames known,
              ReadContext& context)
      : piece_(piece), images_(images), defines_(defines), known_(std::move(known)), context_(context) {}

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
    const std::string* slot = text_at(table, "slot");
    const SlotFrame frame = slot_frame(piece_.page, slot_called(piece_, slot == nullptr ? "" : *slot));
    context_.functions = image_functions(images_, frame);
    params::read_fields(*table, layer.style, "layer '" + name + "'", context_, source_keys());
    layer.style.name = name;
    check_style(*table, layer.style, value.where, known_, context_);
    read_source(*table, name, defines_, layer, context_);
    settle_pens(layer);
    if (const Value* placing = table->find("primitives")) settle_primitives(*placing, layer);
    if (const Value* piece = table->find("piece")) return read_piece(*piece, *table, layer);
    return {std::move(layer)};
  }

  /// The pens of gradients and of other presets.
  const std::vector<NamedPen>& made_pens() const { return made_pens_; }

 private:
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
    if (pen.of.empty()) pen.of = {std::string(known_.pens.front())};
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

  std::vector<Layer> read_piece(const Value& value, const Table& table, const Layer& layer) {
    std::vector<NamedPen> pens = piece_.pens;
    pens.insert(pens.end(), made_pens_.begin(), made_pens_.end());
    const bool keeps_pen = table.find("pen") != nullptr;
    std::optional<NestedLayers> nested = read_nested_piece(value, layer, keeps_pen, pens, context_);
    if (!nested) return {};
    made_pens_.insert(made_pens_.end(), nested->pens.begin(), nested->pens.end());
    return std::move(nested->layers);
  }

  const Piece& piece_;
  const std::vector<NamedImage>& images_;
  const Table* defines_;
  KnownNames known_;
  std::vector<NamedPen> made_pens_;
  ReadContext& context_;
};

}  // namespace

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
  check_layer_names(*array, context);
  const Value* defines = root.find("define");
  LayerReader reader(piece, images, defines == nullptr ? nullptr : defines->table(), known_names(piece, *array, names),
                     context);
  for (std::size_t i = 0; i < array->size(); ++i) {
    for (Layer& layer : reader.read((*array)[i], names[i])) piece.layers.push_back(std::move(layer));
  }
  piece.pens.insert(piece.pens.end(), reader.made_pens().begin(), reader.made_pens().end());
}

}  // namespace burin::preset
