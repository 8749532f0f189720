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
  ColourIndex() { slots_.fill(free_slot); }

  /// The number of a colour, a new one if need be. Nothing: there are 256 others.
  std::optional<std::uint8_t> add(Rgb rgb);

  /// Adds all of them. False: there are more than 256 colours.
  bool add(std::span<const Rgb> pixels);

  /// The numbers of some pixels; what comes behind them. Pre: all of them have been added.
  std::uint8_t* translate(std::span<const Rgb> pixels, std::uint8_t* numbers);

  const std::vector<Colour>& colours() const { return colours_; }

 private:
  static constexpr std::uint16_t free_slot = 256;

  std::vector<Colour> colours_;
  std::array<std::uint16_t, 1024> slots_;  ///< numbers by a hash of the colour; a taken slot sends on to the next
};

}  // namespace burin::output::raster
