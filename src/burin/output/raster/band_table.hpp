#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <burin/output/raster/sample_grid.hpp>

namespace burin::output::raster {

/// low <= a x + b y <= high in whole numbers.
struct WholeBand {
  int a;
  int b;
  double low;
  double high;
};

/// The samples of a pixel in a band, looked up by where the pixel's corner is. As a x + b y grows there, samples enter
/// the band and leave it one after the other: 128 changes, each at a whole number. Exact, and faster than to compute
/// the samples where a band is asked for often.
class BandTable {
 public:
  BandTable() = default;
  /// `corners`: where they may be, in units; both ends count. Pre: there a x + b y is within 2^30, as are the bounds.
  BandTable(const WholeBand& band, const PixelBox& corners);

  /// A corner's place in the table; a sum of what it is at the origin, by x, and by y.
  std::uint32_t place(int x, int y) const {
    return at_origin_ + per_x_ * static_cast<std::uint32_t>(x) + per_y_ * static_cast<std::uint32_t>(y);
  }
  std::uint32_t place_per_pixel() const { return per_x_ * units_per_pixel; }
  std::uint32_t place_per_row() const { return per_y_ * units_per_pixel; }

  Samples samples(std::uint32_t place) const {
    std::size_t change = in_bucket_[place >> bucket_bits];
    // Hardly any bucket has more than two: these without a branch.
    change += static_cast<std::size_t>(place >= places_[change]);
    change += static_cast<std::size_t>(place >= places_[change]);
    while (place >= places_[change]) ++change;
    return before_[change];
  }

 private:
  static constexpr std::size_t most_changes = 128;
  static constexpr unsigned bucket_bits = 23;

  std::uint32_t at_origin_ = 0;
  std::uint32_t per_x_ = 0;
  std::uint32_t per_y_ = 0;
  std::array<std::uint8_t, std::size_t{1} << (32U - bucket_bits)> in_bucket_{};  ///< the first change from there on
  std::array<std::uint32_t, most_changes + 1> places_{};                         ///< of the changes; one never comes
  std::array<Samples, most_changes + 1> before_{};                               ///< the samples before each
};

}  // namespace burin::output::raster
