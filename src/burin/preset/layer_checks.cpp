#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/layer_checks.hpp>

namespace burin::preset {

namespace {

using params::ReadContext;
using params::Table;
using params::Value;

bool is_known(const Value& name, std::string_view what, const std::vector<std::string_view>& known,
              ReadContext& context) {
  const std::string* text = name.text();
  if (text == nullptr || std::find(known.begin(), known.end(), *text) != known.end()) return true;
  context.report(name.where, known.empty() ? fmt::format("no {} '{}': the preset has no [{}s]", what, *text, what)
                                           : fmt::format("no {} '{}'{}", what, *text, suggestion(*text, known)));
  return false;
}

void check_pens(const Value& pen, const KnownNames& known, ReadContext& context) {
  is_known(pen, "pen", known.pens, context);
  const auto check_all = [&](const Value* list) {
    if (list == nullptr || list->array() == nullptr) return;
    for (const Value& each : *list->array()) {
      if (each.text() == nullptr || *each.text() != no_pen) is_known(each, "pen", known.pens, context);
    }
  };
  check_all(&pen);
  if (pen.table() == nullptr) return;
  check_all(pen.table()->find("of"));
  for (const char* end : {"from", "to"}) {
    if (const Value* name = pen.table()->find(end)) is_known(*name, "pen", known.pens, context);
  }
}

void check_clip(const Value& value, const LayerStyle& style, const KnownNames& known, ReadContext& context) {
  const std::string* name = value.text();
  if (name == nullptr) return;
  if (*name == style.name) {
    context.report(value.where, fmt::format("layer '{}' cannot be clipped by itself", *name));
    return;
  }
  if (std::ranges::find(known.layers, *name) == known.layers.end()) {
    context.report(value.where, fmt::format("no layer '{}'{} A plain shape is a table: {{ shape = \"disc\", r = "
                                            "\"70mm\" }}",
                                            *name, suggestion(*name, known.layers)));
  }
}

void check_dashes(const Value& value, const LayerStyle& style, ReadContext& context) {
  constexpr std::size_t most_dashes = 64;
  double total_mm = 0.0;
  bool negative = false;
  for (const params::Length& length : style.dashes) {
    total_mm += length.mm;
    negative = negative || length.mm < 0.0;
  }
  const bool read = value.array() != nullptr && style.dashes.size() == value.array()->size();
  if (negative) {
    context.report(value.where, "dashes cannot be shorter than 0");
  } else if (style.dashes.size() > most_dashes) {
    context.report(value.where, fmt::format("at most {} dashes are allowed", most_dashes));
  } else if (read && !(total_mm > 0.0)) {
    context.report(value.where, "dashes need a length above 0; leave them out for a full line");
  }
}

}  // namespace

void check_style(const params::Table& table, const LayerStyle& style, const Where& where, const KnownNames& known,
                 ReadContext& context) {
  if (const Value* pen = table.find("pen")) check_pens(*pen, known, context);
  if (const Value* fill = table.find("fill")) is_known(*fill, "pen", known.pens, context);
  if (const Value* slot = table.find("slot")) is_known(*slot, "slot", known.slots, context);
  const bool is_clip = std::ranges::find(known.clips, style.name) != known.clips.end();
  const Value* stroke = table.find("stroke");
  if (stroke != nullptr && stroke->text() != nullptr && style.stroke != "none") {
    context.report(stroke->where,
                   fmt::format("'stroke' is \"none\" or left out, not '{}'; the pen is chosen by 'pen'", style.stroke));
  } else if (style.stroke == "none" && table.find("fill") == nullptr && !style.hide && !is_clip) {
    context.report(stroke == nullptr ? where : stroke->where,
                   "without stroke and 'fill' the layer draws nothing, and it neither hides nor clips others");
  }
  if (const Value* hidden = table.find("hidden")) is_known(*hidden, "pen", known.pens, context);
  for (const char* key : {"clip", "outside"}) {
    if (const Value* clip = table.find(key)) check_clip(*clip, style, known, context);
  }
  if (const Value* dashes = table.find("dashes")) check_dashes(*dashes, style, context);
}

}  // namespace burin::preset
