#include <algorithm>
#include <array>

#include <burin/base/number_text.hpp>
#include <burin/primitives/placing_spec.hpp>

namespace burin::primitives {

void turn_by_level(PlacingSpec& spec, int first_level) {
  turn_by_level(spec.use, first_level);
  turn_by_level(spec.scale, first_level);
  turn_by_level(spec.rotate, first_level);
  turn_by_level(spec.when, first_level);
}

PositionUse variables_used(const PlacingSpec& spec) {
  PositionUse used = spec.use.used() | spec.scale.used() | spec.rotate.used() | spec.when.used();
  for (const PlaceLength& scale : spec.scale.of) used |= used_by(scale.value);
  for (const PlaceNumber& turn : spec.rotate.of) used |= used_by(turn.value);
  for (const PlaceNumber& when : spec.when.of) used |= used_by(when.value);
  return used;
}

bool uses_chance(const PlacingSpec& spec) {
  const PositionUse used = variables_used(spec);
  return spec.jitter.mm > 0.0 || spec.mirror == PlaceMirror::random || used[position_variable("rand")] ||
         used[position_variable("random")];
}

bool depends_on_slot(const PlacingSpec& spec) {
  const PositionUse used = variables_used(spec);
  constexpr std::array variables{position_variable("px"), position_variable("py"),  position_variable("pr"),
                                 position_variable("u"),  position_variable("v"),   position_variable("i"),
                                 position_variable("j"),  position_variable("copy")};
  return std::ranges::any_of(variables, [&](std::size_t variable) { return used[variable]; });
}

bool fills_every_place(const PlacingSpec& spec) {
  const bool always = spec.when.of.size() == 1 && spec.when.of.front().value.is_constant();
  const bool shown = std::ranges::find(spec.use.of, no_figure) == spec.use.of.end();
  return always && shown && !spec.distinct && !(spec.apart.mm > 0.0) && spec.scale.of.size() == 1 &&
         spec.scale.of.front().value.is_constant();
}

}  // namespace burin::primitives

namespace burin::params {

bool ValueType<primitives::Every>::read(const Value& value, primitives::Every& every, ReadContext& context) {
  if (value.text() != nullptr) {
    Length length;
    if (!ValueType<Length>::read(value, length, context)) return false;
    if (length.mm > 0.0) {
      every = {1, length.mm};
      return true;
    }
    context.report(value.where, "a length along the curve must be above 0");
    return false;
  }
  std::int64_t count = 0;
  if (!ValueType<std::int64_t>::read(value, count, context)) return false;
  if (count < 1) {
    context.report(value.where, "expected a whole number from 1, or a length such as \"6mm\"");
    return false;
  }
  every = {count, 0.0};
  return true;
}

std::string ValueType<primitives::Every>::text(const primitives::Every& every) {
  return every.length_mm > 0.0 ? ValueType<Length>::text({every.length_mm}) : std::to_string(every.count);
}

bool ValueType<primitives::PlacingSpec>::read(const Value& value, primitives::PlacingSpec& spec, ReadContext& context) {
  const Table* table = value.table();
  if (table == nullptr) return report_kind(value, "a table: { use = \"leaf\", every = \"6mm\" }", context);
  if (!read_fields(*table, spec, "primitives", context)) return false;
  if (spec.use.of.empty()) {
    context.report(value.where, "'use' is missing: which figure is placed, as in { use = \"leaf\" }");
    return false;
  }
  const auto excludes = [&](const char* key, const char* other) {
    context.report(table->find(key)->where, std::string("'") + key + "' does not go with " + other);
    return false;
  };
  const bool by_length = spec.every.length_mm > 0.0;
  if (by_length && table->find("at") != nullptr) return excludes("at", "a length in 'every'");
  if (spec.mode == primitives::PlaceMode::fresh && by_length) return excludes("mode", "a length in 'every'");
  if (spec.mode == primitives::PlaceMode::fresh && spec.at == primitives::PlaceAt::edges) {
    return excludes("mode", "at = \"edges\": only points are new");
  }
  return true;
}

}  // namespace burin::params
