#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <burin/output/raster/picture.hpp>

namespace burin::output::raster {

/// The colours of a picture, numbered as they are met, up to 256.
class ColourIndex {
 public:
  /// The number of a colour, a new one if need be. Nothing: there are 256 others.
  std::optional<std::uint8_t> add(Rgb rgb);

  /// Adds all of them. False: there are more than 256 colours.
  bool add(std::span<const Rgb> pixels);

  /// The numbers of some pixels; what comes behind them. Pre: all of them have been added.
  std::uint8_t* translate(std::span<const Rgb> pixels, std::uint8_t* numbers) const;

  const std::vector<Colour>& colours() const { return colours_; }

 private:
  /// A taken slot that has another colour sends on to the next.
  struct Slot {
    Rgb rgb = no_colour;
    std::uint8_t number = 0;
  };

  /// Where a colour is, or belongs.
  std::size_t place_of(Rgb rgb) const {
    std::size_t place = (rgb * 0x9E3779B1U) >> 22U;
    while (slots_[place].rgb != rgb && slots_[place].rgb != no_colour) place = (place + 1) % slots_.size();
    return place;
  }

  static constexpr Rgb no_colour = 0xFF000000;

  std::vector<Colour> colours_;
  std::array<Slot, 1024> slots_;  ///< by a hash of the colour
};

}  // namespace burin::output::raster
