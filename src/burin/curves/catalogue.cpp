#include <algorithm>
#include <array>

#include <burin/base/suggest.hpp>
#include <burin/curves/de_rham.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/four_parameter.hpp>
#include <burin/curves/four_point.hpp>
#include <burin/curves/fractal_interpolation/fractal_interpolation.hpp>
#include <burin/curves/line_art/line_art.hpp>
#include <burin/curves/line_art/line_art_3d.hpp>
#include <burin/curves/shape.hpp>
#include <burin/curves/svg/svg.hpp>
#include <burin/curves/text/text.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/curves/two_point_3d/two_point_3d.hpp>

namespace burin::curves {

std::span<const Family> catalogue() {
  static const std::array<Family, 13> families{
      two_point_family(),      two_point_3d_family(),          de_rham_family(),  four_point_family(),
      four_parameter_family(), fractal_interpolation_family(), line_art_family(), line_art_boundary_family(),
      line_art_3d_family(),    line_art_boundary_3d_family(),  text_family(),     svg_family(),
      shape_family(),
  };
  return families;
}

namespace {

/// Other names that families go by.
struct Alias {
  std::string_view name;
  std::string_view family;
};

/// The paper spells Dehlinger its own way.
constexpr std::array<Alias, 2> aliases{{{"delinger", "line-art"}, {"delinger-boundary", "line-art-boundary"}}};

}  // namespace

const Family* find_family(std::string_view name) {
  for (const Alias& alias : aliases) {
    if (alias.name == name) name = alias.family;
  }
  const std::span<const Family> families = catalogue();
  const auto row = std::find_if(families.begin(), families.end(), [&](const Family& f) { return f.name == name; });
  return row == families.end() ? nullptr : &*row;
}

const Family* read_family(const params::Table& table, const Where& where, params::ReadContext& context) {
  std::vector<std::string_view> names;
  for (const Family& family : catalogue()) names.push_back(family.name);
  const params::Value* value = table.find("family");
  if (value == nullptr) {
    context.report(where, "a curve needs a 'family'" + suggestion("", names));
    return nullptr;
  }
  const std::string* name = value->text();
  if (name == nullptr) {
    params::report_kind(*value, "the name of a family", context);
    return nullptr;
  }
  const Family* const family = find_family(*name);
  if (family == nullptr) context.report(value->where, "no family '" + *name + '\'' + suggestion(*name, names));
  return family;
}

}  // namespace burin::curves
