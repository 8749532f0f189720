#include <algorithm>
#include <array>

#include <burin/output/raster/picture.hpp>

namespace burin::output::raster {

namespace {

/// Opacity in 1/2^16, of 64 samples: shares of ink are in 1/2^22.
constexpr unsigned share_bits = 22;

/// The opacity as a share of 64 * 2^16.
std::uint32_t sample_share(double opacity) {
  return static_cast<std::uint32_t>(std::clamp(opacity, 0.0, 1.0) * 65536.0 + 0.5);
}

Rgb mixed(Rgb under, Rgb ink, std::uint32_t share) {
  const std::uint32_t rest = (1U << share_bits) - share;
  Rgb all = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    const std::uint32_t mix = (under >> shift & 0xFFU) * rest + (ink >> shift & 0xFFU) * share;
    all |= (mix + (1U << (share_bits - 1U))) >> share_bits << shift;
  }
  return all;
}

}  // namespace

std::array<Rgb, 65> shades(Rgb under, Colour ink, double opacity) {
  std::array<Rgb, 65> all{};
  const std::uint32_t share = sample_share(opacity);
  for (std::uint32_t samples = 0; samples < all.size(); ++samples) {
    all[samples] = mixed(under, rgb_of(ink), samples * share);
  }
  return all;
}

void Picture::lay_over(MaskTiles& layer, const Kernel& kernel, Colour ink, double opacity) {
  const std::array<Rgb, 65> on_paper = shades(paper_, ink, opacity);
  const std::uint32_t share = sample_share(opacity);
  std::array<std::uint8_t, std::tuple_size_v<MaskTiles::Tile>> counts;
  for (int row = 0; row < layer.rows(); ++row) {
    for (int column = 0; column < layer.columns(); ++column) {
      const MaskTiles::Tile* const masks = layer.tile(column, row);
      if (masks == nullptr) continue;
      kernel.count(*masks, counts.data());
      layer.release(column, row);
      const bool is_paper = tiles_.tile(column, row) == nullptr;
      Tiles<Rgb>::Tile& pixels = tiles_.touched(column, row, paper_);
      if (is_paper) {
        std::transform(counts.begin(), counts.end(), pixels.begin(),
                       [&](std::uint8_t count) { return on_paper[count]; });
        continue;
      }
      for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] == 0) continue;
        pixels[k] = pixels[k] == paper_ ? on_paper[counts[k]] : mixed(pixels[k], rgb_of(ink), counts[k] * share);
      }
    }
  }
}

}  // namespace burin::output::raster
