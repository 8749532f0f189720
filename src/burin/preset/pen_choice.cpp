#include <burin/preset/piece_values.hpp>

namespace burin::params {

namespace {

using preset::PenChoice;

/// A gradient: pens between two, one for each level, or for each band.
struct Gradient {
  std::string from;
  std::string to;

  static constexpr auto fields() {
    return std::tuple{field("from", &Gradient::from, "the first pen"), field("to", &Gradient::to, "the last pen")};
  }
};

bool read_gradient(const Value& value, PenChoice& choice, ReadContext& context) {
  Gradient gradient;
  if (!read_fields(*value.table(), gradient, "pen", context, {"by", "at"})) return false;
  if (gradient.from.empty() || gradient.to.empty()) {
    context.report(value.where, "a gradient of pens needs 'from' and 'to': { from = \"ink\", to = \"red\" }");
    return false;
  }
  PenChoice read;
  read.from = gradient.from;
  read.to = gradient.to;
  const bool has_bands = value.table()->find("by") != nullptr || value.table()->find("at") != nullptr;
  if (has_bands && !read_bounds(value, {"from", "to"}, read.at, read.by, context)) return false;
  choice = std::move(read);
  return true;
}

}  // namespace

bool ValueType<PenChoice>::read(const Value& value, PenChoice& choice, ReadContext& context) {
  const Table* table = value.table();
  if (table != nullptr && (table->find("from") != nullptr || table->find("to") != nullptr)) {
    return read_gradient(value, choice, context);
  }
  choice.from.clear();
  choice.to.clear();
  return ValueType<primitives::Choice<std::string>>::read(value, choice, context);
}

std::string ValueType<PenChoice>::text(const PenChoice& choice) {
  return ValueType<primitives::Choice<std::string>>::text(choice);
}

}  // namespace burin::params
