#include <algorithm>

#include <burin/output/raster/colour_index.hpp>

namespace burin::output::raster {

std::optional<std::uint8_t> ColourIndex::add(Rgb rgb) {
  Slot& slot = slots_[place_of(rgb)];
  if (slot.rgb == rgb) return slot.number;
  if (colours_.size() == 256) return std::nullopt;
  slot = {rgb, static_cast<std::uint8_t>(colours_.size())};
  colours_.push_back(colour_of(rgb));
  return slot.number;
}

bool ColourIndex::add(std::span<const Rgb> pixels) {
  return std::all_of(pixels.begin(), pixels.end(), [this](Rgb rgb) {
    // Most of them are known.
    return slots_[place_of(rgb)].rgb == rgb || add(rgb);
  });
}

std::uint8_t* ColourIndex::translate(std::span<const Rgb> pixels, std::uint8_t* numbers) const {
  return std::transform(pixels.begin(), pixels.end(), numbers,
                        [this](Rgb rgb) { return slots_[place_of(rgb)].number; });
}

}  // namespace burin::output::raster
