#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/geom/vec2.hpp>

namespace burin::primitives {

/// Takes points that keep a distance from all taken before, the first come first served. Looks at the few cells of a
/// hashed grid around a point; 32 to 64 bytes a point taken, at most 256 MB.
class Spacing {
 public:
  static constexpr std::size_t most_points = std::size_t{1} << 22U;

  /// Two points are too close when they lie less than `distance` apart. Pre: above 0.
  explicit Spacing(double distance);

  /// Whether the point keeps its distance; it is taken then. False for points that are not finite, and when full.
  bool take(Vec2 p);

  /// Whether a point could not be taken for want of memory.
  bool full() const { return full_; }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  Cell cell_of(Vec2 p) const;
  std::size_t slot_of(Cell cell) const;
  bool is_taken(Cell cell, Vec2 p) const;
  void insert(Vec2 p);

  double distance_;
  std::vector<Vec2> slots_;  ///< open addressing; NaN: free
  std::size_t taken_ = 0;
  bool full_ = false;
};

}  // namespace burin::primitives
