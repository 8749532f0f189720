#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <burin/geom/vec2.hpp>
#include <burin/geom/vec3.hpp>
#include <burin/params/fields.hpp>

/// What reading a region in the plane and one in space have in common.
namespace burin::curves::line_art {

/// One region or several.
template <class Region>
struct OneOrSeveral {
  std::vector<Region> all;
};

/// Whether a region written as a table has one key of these. False after reporting.
inline bool check_one_key(const params::Table& table, std::string_view what, const std::vector<params::FieldInfo>& keys,
                          const Where& where, params::ReadContext& context) {
  if (table.entries.size() == 1) return true;
  std::string names;
  for (const params::FieldInfo& key : keys) {
    const char* join = names.empty() ? "" : &key == &keys.back() ? " and " : ", ";
    names += join + ('\'' + std::string(key.name) + '\'');
  }
  context.report(where, std::string(what) + " needs exactly one of " + names);
  return false;
}

/// How long polylines are from the first one's beginning to the end of each edge. Empty after reporting.
template <class Polylines>
std::vector<double> lengths_along(const Polylines& polylines, const Where& where, params::ReadContext& context) {
  std::vector<double> lengths;
  double total = 0.0;
  for (const auto& polyline : polylines) {
    for (std::size_t e = 0; e < polyline.edge_count(); ++e) {
      total += distance(polyline.edge_begin(e), polyline.edge_end(e));
      lengths.push_back(total);
    }
  }
  if (total > 0.0) return lengths;
  context.report(where, "the line has no length; give it as 'point'");
  return {};
}

}  // namespace burin::curves::line_art

/// A region, or a list of tables, lists and names of them.
template <class Region>
struct burin::params::ValueType<burin::curves::line_art::OneOrSeveral<Region>> {
  using Regions = burin::curves::line_art::OneOrSeveral<Region>;

  static std::string name() { return ValueType<Region>::name() + " or list of them"; }

  static bool read(const Value& value, Regions& regions, ReadContext& context) {
    const Array* array = value.array();
    const bool is_list = array != nullptr && !array->empty() &&
                         (array->front().table() != nullptr || array->front().array() != nullptr ||
                          (array->front().text() != nullptr && context.defined(*array->front().text()) != nullptr));
    if (is_list) return ValueType<std::vector<Region>>::read(value, regions.all, context);
    Region one;
    if (!ValueType<Region>::read(value, one, context)) return false;
    regions.all = {std::move(one)};
    return true;
  }

  static std::string text(const Regions& regions) {
    return regions.all.size() == 1 ? ValueType<Region>::text(regions.all.front()) : std::string();
  }
};
