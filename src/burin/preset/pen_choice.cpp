#include <utility>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/preset/piece_values.hpp>

namespace burin::params {

namespace {

using preset::PenChoice;

/// The table of a banded choice.
struct Bands {
  std::string by;
  std::vector<double> at;
  std::vector<std::string> of;

  static constexpr auto fields() {
    return std::tuple{field("by", &Bands::by, "function of the place"),
                      field("at", &Bands::at, "bounds between the bands, ascending"),
                      field("of", &Bands::of, "pens, one more than bounds")};
  }
};

bool check_bands(const Value& value, const Bands& bands, ReadContext& context) {
  const Table& table = *value.table();
  for (const char* key : {"by", "at", "of"}) {
    if (table.find(key) == nullptr) {
      context.report(value.where, fmt::format("bands need '{}': {{ by = \"f(x,y)\", at = [...], of = [...] }}", key));
      return false;
    }
  }
  if (bands.of.size() != bands.at.size() + 1) {
    context.report(table.find("of")->where, fmt::format("{} bounds in 'at' need {} pens in 'of', found {}",
                                                        bands.at.size(), bands.at.size() + 1, bands.of.size()));
    return false;
  }
  for (std::size_t i = 1; i < bands.at.size(); ++i) {
    if (bands.at[i] > bands.at[i - 1]) continue;
    context.report((*table.find("at")->array())[i].where,
                   fmt::format("bounds must ascend: {} does not follow {}", shortest_text(bands.at[i]),
                               shortest_text(bands.at[i - 1])));
    return false;
  }
  return true;
}

}  // namespace

bool ValueType<PenChoice>::read(const Value& value, PenChoice& choice, ReadContext& context) {
  if (const std::string* name = value.text()) {
    choice = {{*name}, {}, {}};
    return true;
  }
  const Table* table = value.table();
  if (table == nullptr) return report_kind(value, "a pen or { by = \"f(x,y)\", at = [...], of = [...] }", context);
  Bands bands;
  if (!read_fields(*table, bands, "pen", context) || !check_bands(value, bands, context)) return false;
  const Result<expr::Expression> by =
      expr::Expression::compile(bands.by, preset::band_variables, table->find("by")->where);
  if (!by) {
    context.problems.insert(context.problems.end(), by.problems().begin(), by.problems().end());
    return false;
  }
  choice = {std::move(bands.of), std::move(bands.at), *by};
  return true;
}

std::string ValueType<PenChoice>::text(const PenChoice& choice) {
  if (choice.of.size() != 1) return {};
  return '"' + choice.of.front() + '"';
}

}  // namespace burin::params
