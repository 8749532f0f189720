#include <algorithm>
#include <cmath>
#include <limits>

#include <burin/output/raster/band_table.hpp>

namespace burin::output::raster {

namespace {

struct Change {
  std::int64_t at;
  Samples sample;
};

std::array<Change, 128> changes_of(const WholeBand& band) {
  // Sums are whole numbers: those from the first to the last one within the bounds.
  const auto first = static_cast<std::int64_t>(std::ceil(band.low));
  const auto last = static_cast<std::int64_t>(std::floor(band.high));
  std::array<Change, 128> changes;
  auto* change = changes.data();
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const int from_corner = band.a * sample_x(row, column) + band.b * sample_y(row, column);
      const Samples sample = sample_bit(row, column);
      *change++ = {first - from_corner, sample};
      *change++ = {last - from_corner + 1, sample};
    }
  }
  std::sort(changes.begin(), changes.end(), [](const Change& one, const Change& other) { return one.at < other.at; });
  return changes;
}

}  // namespace

BandTable::BandTable(const WholeBand& band, const PixelBox& corners) {
  const auto at = [](std::int64_t factor, int one, int other, bool greater) {
    return greater ? std::max(factor * one, factor * other) : std::min(factor * one, factor * other);
  };
  const std::int64_t least =
      at(band.a, corners.left, corners.right, false) + at(band.b, corners.top, corners.bottom, false);
  const std::int64_t most =
      at(band.a, corners.left, corners.right, true) + at(band.b, corners.top, corners.bottom, true);
  // Places use all 32 bits; the greatest number is left for the change that never comes.
  constexpr std::int64_t never = std::numeric_limits<std::uint32_t>::max();
  const std::int64_t scale = (never - 1) / (most - least + 1);
  at_origin_ = static_cast<std::uint32_t>(-least * scale);
  per_x_ = static_cast<std::uint32_t>(band.a * scale);
  per_y_ = static_cast<std::uint32_t>(band.b * scale);

  std::size_t count = 0;
  Samples inside = 0;
  for (const Change& change : changes_of(band)) {
    if (change.at > most) break;
    if (change.at > least) {
      const auto place = static_cast<std::uint32_t>((change.at - least) * scale);
      if (count == 0 || place != places_[count - 1]) {
        before_[count] = inside;
        places_[count++] = place;
      }
    }
    inside ^= change.sample;
  }
  before_[count] = inside;
  places_[count] = never;
  std::size_t change = 0;
  for (std::size_t bucket = 0; bucket < in_bucket_.size(); ++bucket) {
    while (places_[change] >> bucket_bits < bucket) ++change;
    in_bucket_[bucket] = static_cast<std::uint8_t>(change);
  }
}

}  // namespace burin::output::raster
