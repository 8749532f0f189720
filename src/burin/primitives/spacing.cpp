#include <cmath>
#include <limits>

#include <burin/base/check.hpp>
#include <burin/base/random.hpp>
#include <burin/primitives/spacing.hpp>

namespace burin::primitives {

namespace {

constexpr std::size_t first_slots = 256;
constexpr Vec2 no_point{std::numeric_limits<double>::quiet_NaN(), 0.0};
/// The side of a cell, in distances: most points then have all their neighbours in one or two cells.
constexpr double cell_distances = 4.0;
/// Points of a lattice that are just the distance apart stay so, however they are rounded.
constexpr double hair = 1e-9;
/// Cells further out would not be told apart.
constexpr double farthest_cell = 0x1p52;

bool is_free(Vec2 slot) {
  return std::isnan(slot.x);
}

}  // namespace

Spacing::Spacing(double distance) : distance_(distance), slots_(first_slots, no_point) {
  BURIN_EXPECT(distance > 0.0);
}

Spacing::Cell Spacing::cell_of(Vec2 p) const {
  const double side = cell_distances * distance_;
  return {static_cast<std::int64_t>(std::floor(p.x / side)), static_cast<std::int64_t>(std::floor(p.y / side))};
}

std::size_t Spacing::slot_of(Cell cell) const {
  return static_cast<std::size_t>(random_bits(0, cell.x, cell.y)) & (slots_.size() - 1);
}

bool Spacing::is_taken(Cell cell, Vec2 p) const {
  const double close = distance_ * (1.0 - hair);
  for (std::size_t slot = slot_of(cell); !is_free(slots_[slot]); slot = (slot + 1) & (slots_.size() - 1)) {
    if (length_squared(slots_[slot] - p) < close * close) return true;
  }
  return false;
}

void Spacing::insert(Vec2 p) {
  std::size_t slot = slot_of(cell_of(p));
  while (!is_free(slots_[slot])) slot = (slot + 1) & (slots_.size() - 1);
  slots_[slot] = p;
}

bool Spacing::take(Vec2 p) {
  if (!(std::abs(p.x) / distance_ < farthest_cell && std::abs(p.y) / distance_ < farthest_cell)) return false;
  const Cell low = cell_of(p - Vec2{distance_, distance_});
  const Cell high = cell_of(p + Vec2{distance_, distance_});
  for (std::int64_t y = low.y; y <= high.y; ++y) {
    for (std::int64_t x = low.x; x <= high.x; ++x) {
      if (is_taken({x, y}, p)) return false;
    }
  }
  full_ = taken_ == most_points;
  if (full_) return false;
  if (2 * (taken_ + 1) > slots_.size()) {
    std::vector<Vec2> old(2 * slots_.size(), no_point);
    old.swap(slots_);
    for (const Vec2 q : old) {
      if (!is_free(q)) insert(q);
    }
  }
  insert(p);
  ++taken_;
  return true;
}

}  // namespace burin::primitives
