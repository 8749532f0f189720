#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/params/fields.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/preset/sections.hpp>

namespace burin::preset {

namespace {

using params::Entry;
using params::ReadContext;
using params::Table;
using params::Value;

/// The table [name]; null when it is missing or, which is reported, no table.
const Table* section(const Table& root, std::string_view name, ReadContext& context) {
  const Value* value = root.find(name);
  if (value == nullptr) return nullptr;
  if (value->table() == nullptr) {
    context.report(value->where, fmt::format("'{}' is a table: [{}], not {}", name, name, value->kind_name()));
  }
  return value->table();
}

/// Reads each entry of [section] into a Spec; calls keep(name, spec, table).
template <class Spec, class Keep>
void read_named(const Table& root, std::string_view name, std::string_view what, ReadContext& context, Keep keep) {
  const Table* table = section(root, name, context);
  if (table == nullptr) return;
  for (const Entry& entry : table->entries) {
    Spec spec;
    const Table* inner = entry.value.table();
    if (inner == nullptr) {
      context.report(entry.value.where,
                     fmt::format("{} '{}' is a table in braces, not {}", what, entry.key, entry.value.kind_name()));
    } else {
      params::read_fields(*inner, spec, fmt::format("{} '{}'", what, entry.key), context);
    }
    keep(entry.key, std::move(spec), inner);
  }
}

void check_live_area(const Table* table, const PageSpec& page, const Where& file, ReadContext& context) {
  const auto written = [&](std::string_view key) { return table == nullptr ? nullptr : table->find(key); };
  const Value* margin = written("margin");
  const Value* size = written("size");
  const Where& where = margin != nullptr ? margin->where : size != nullptr ? size->where : file;
  const auto check = [&](double first_mm, double second_mm, double side_mm, std::string_view side) {
    if (first_mm + second_mm < side_mm) return;
    context.report(where, fmt::format("margins of {} mm and {} mm leave nothing of the page's {} of {} mm{}",
                                      shortest_text(first_mm), shortest_text(second_mm), side, shortest_text(side_mm),
                                      margin == nullptr ? "; set 'margin'" : ""));
  };
  check(page.margin.left_mm, page.margin.right_mm, page.size.width_mm, "width");
  check(page.margin.top_mm, page.margin.bottom_mm, page.size.height_mm, "height");
}

void check_slot(const Table& table, const SlotSpec& slot, ReadContext& context) {
  if (slot.frame) {
    const auto& [x0, y0, x1, y1] = *slot.frame;
    if (!(x0 < x1 && y0 < y1)) {
      context.report(table.find("frame")->where, "a frame is [x0, y0, x1, y1] with x0 < x1 and y0 < y1");
    }
  }
  if (slot.frame && slot.scale) {
    context.report(table.find("scale")->where, "a slot has 'frame' or 'scale', not both");
  }
}

void check_pen(const Table& table, const PenSpec& pen, ReadContext& context) {
  if (!pen.cmyk) return;
  for (const double percent : *pen.cmyk) {
    if (percent >= 0.0 && percent <= 100.0) continue;
    context.report(table.find("cmyk")->where,
                   fmt::format("'cmyk': an ink of {} percent is outside [0, 100]", shortest_text(percent)));
  }
}

}  // namespace

About read_about(const Table& root, ReadContext& context) {
  About about;
  if (const Table* table = section(root, "about", context)) params::read_fields(*table, about, "about", context);
  return about;
}

PageSpec read_page(const Table& root, const Where& file, const Palette* palette, ReadContext& context) {
  PageSpec page;
  if (palette != nullptr) page.paper = palette->paper;
  const std::size_t before = context.problems.size();
  const Table* table = section(root, "page", context);
  if (table != nullptr) params::read_fields(*table, page, "page", context);
  if (page.landscape && page.size.width_mm < page.size.height_mm) std::swap(page.size.width_mm, page.size.height_mm);
  if (context.problems.size() == before) check_live_area(table, page, file, context);
  return page;
}

PageSize read_enlarge(const std::string& size, ReadContext& context) {
  PageSize page;
  params::ValueType<PageSize>::read({{"--enlarge " + size}, size}, page, context);
  return page;
}

std::vector<NamedPen> read_pens(const Table& root, const Palette* palette, ReadContext& context) {
  std::vector<NamedPen> pens;
  const auto give_colour = [palette](const std::string& name, PenSpec& pen) {
    const Colour* colour = palette == nullptr ? nullptr : ink_of(*palette, name);
    if (colour != nullptr) pen.color = *colour;
  };
  read_named<PenSpec>(root, "pens", "pen", context, [&](const std::string& name, PenSpec pen, const Table* table) {
    if (table != nullptr) check_pen(*table, pen, context);
    if (table != nullptr && table->find("color") == nullptr) give_colour(name, pen);
    pens.push_back({name, std::move(pen)});
  });
  if (!pens.empty()) return pens;
  pens.push_back({"ink", {}});
  if (palette != nullptr) pens.insert(pens.end(), {{"accent", {}}, {"soft", {}}});
  for (auto& [name, pen] : pens) give_colour(name, pen);
  return pens;
}

std::vector<NamedSlot> read_slots(const Table& root, ReadContext& context) {
  std::vector<NamedSlot> slots;
  read_named<SlotSpec>(root, "slots", "slot", context, [&](const std::string& name, SlotSpec slot, const Table* table) {
    if (table != nullptr) check_slot(*table, slot, context);
    slots.push_back({name, std::move(slot)});
  });
  return slots;
}

}  // namespace burin::preset
