#include <fmt/format.h>

#include <burin/path/oklch.hpp>
#include <burin/preset/pen_gradient.hpp>

namespace burin::preset {

std::vector<NamedPen> pens_between(const NamedPen& from, const NamedPen& to, std::size_t count) {
  std::vector<NamedPen> pens{from};
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    NamedPen pen{fmt::format("{} to {} {}/{}", from.name, to.name, i + 1, count), {}};
    pen.pen.color = mix_colours(from.pen.color, to.pen.color, share);
    pen.pen.width.mm = between(from.pen.width.mm, to.pen.width.mm);
    if (from.pen.cmyk && to.pen.cmyk) {
      pen.pen.cmyk.emplace();
      for (std::size_t ink = 0; ink < 4; ++ink) {
        (*pen.pen.cmyk)[ink] = between((*from.pen.cmyk)[ink], (*to.pen.cmyk)[ink]);
      }
    }
    pens.push_back(std::move(pen));
  }
  if (count > 1) pens.push_back(to);
  return pens;
}

}  // namespace burin::preset
