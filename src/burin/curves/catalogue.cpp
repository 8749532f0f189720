#include <algorithm>
#include <array>

#include <burin/curves/de_rham.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/four_parameter.hpp>
#include <burin/curves/four_point.hpp>
#include <burin/curves/text/text.hpp>
#include <burin/curves/two_point/two_point.hpp>

namespace burin::curves {

std::span<const Family> catalogue() {
  static const std::array<Family, 5> families{
      two_point_family(), de_rham_family(), four_point_family(), four_parameter_family(), text_family(),
  };
  return families;
}

const Family* find_family(std::string_view name) {
  const std::span<const Family> families = catalogue();
  const auto row = std::find_if(families.begin(), families.end(), [&](const Family& f) { return f.name == name; });
  return row == families.end() ? nullptr : &*row;
}

}  // namespace burin::curves
