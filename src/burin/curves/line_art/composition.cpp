#include <burin/curves/line_art/composition.hpp>

namespace burin::curves::line_art {

namespace {

/// Rules between the fields; false after reporting.
bool check_composition(const Composition& composition, const params::Table& table, params::ReadContext& context) {
  const auto fail = [&](const char* key, const char* message) {
    context.report(table.find(key)->where, message);
    return false;
  };
  constexpr const char* needs_inside = "must have an inside: a rectangle, disc, ring or polygon";
  if (composition.inside && !composition.inside->is_area()) {
    return fail("inside", needs_inside);
  }
  for (const Region& region : composition.keep_out.all) {
    if (!region.is_area()) return fail("keep_out", needs_inside);
  }
  if (composition.tone && !composition.pen_width) {
    return fail("tone", "'tone' needs 'pen_width', the width of the pen in model units");
  }
  if (composition.pen_width && !composition.tone) {
    return fail("pen_width", "'pen_width' serves 'tone'; leave it out or give a 'tone'");
  }
  return true;
}

}  // namespace

}  // namespace burin::curves::line_art

namespace burin::params {

bool ValueType<curves::line_art::Composition>::read(const Value& value, curves::line_art::Composition& composition,
                                                    ReadContext& context) {
  const Value* written = &value;
  if (const std::string* word = value.text()) written = context.defined(*word);
  if (written == nullptr || written->table() == nullptr) {
    return report_kind(value, "a table such as { spacing = 0.01 }, or the name of a define", context);
  }
  return read_fields(*written->table(), composition, "compose", context) &&
         curves::line_art::check_composition(composition, *written->table(), context);
}

}  // namespace burin::params
