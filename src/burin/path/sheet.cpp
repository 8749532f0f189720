#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/path/sheet.hpp>

namespace burin {

std::string layer_label(const Sheet& sheet, std::size_t layer) {
  BURIN_EXPECT(layer < sheet.layers.size());
  const std::size_t pen = sheet.layers[layer].pen;
  BURIN_EXPECT(pen < sheet.pens.size());
  return fmt::format("{} {} {}", pen + 1, sheet.pens[pen].name, fixed_text(sheet.pens[pen].width_mm, 3));
}

}  // namespace burin
