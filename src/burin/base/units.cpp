#include <array>
#include <utility>

#include <burin/base/units.hpp>

namespace burin {

std::optional<double> mm_per_unit(std::string_view suffix) {
  static constexpr std::array<std::pair<std::string_view, double>, 8> units{{
      {"", 1.0},
      {"mm", 1.0},
      {"cm", 10.0},
      {"m", 1000.0},
      {"in", mm_per_inch},
      {"pt", mm_per_point},
      {"pc", 12.0 * mm_per_point},
      {"px", mm_per_css_pixel},
  }};
  for (const auto& [name, mm] : units) {
    if (name == suffix) return mm;
  }
  return std::nullopt;
}

std::size_t unit_suffix_begin(std::string_view length) {
  std::size_t begin = length.size();
  while (begin > 0) {
    const char c = length[begin - 1];
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) break;
    --begin;
  }
  return begin;
}

}  // namespace burin
