#include <burin/output/raster/colour_index.hpp>

namespace burin::output::raster {

std::optional<std::uint8_t> ColourIndex::add(Rgb rgb) {
  std::size_t slot = (rgb * 0x9E3779B1U) >> 22U;
  for (; slots_[slot] != free_slot; slot = (slot + 1) % slots_.size()) {
    if (rgb_of(colours_[slots_[slot]]) == rgb) return static_cast<std::uint8_t>(slots_[slot]);
  }
  if (colours_.size() == 256) return std::nullopt;
  slots_[slot] = static_cast<std::uint16_t>(colours_.size());
  colours_.push_back(colour_of(rgb));
  return static_cast<std::uint8_t>(slots_[slot]);
}

bool ColourIndex::add(std::span<const Rgb> pixels) {
  Rgb last = ~pixels.front();
  for (const Rgb rgb : pixels) {
    if (rgb != last && !add(rgb)) return false;
    last = rgb;
  }
  return true;
}

std::uint8_t* ColourIndex::translate(std::span<const Rgb> pixels, std::uint8_t* numbers) {
  Rgb last = ~pixels.front();
  std::uint8_t number = 0;
  for (const Rgb rgb : pixels) {
    if (rgb != last) {
      number = add(rgb).value_or(0);
      last = rgb;
    }
    *numbers++ = number;
  }
  return numbers;
}

}  // namespace burin::output::raster
