#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <burin/curves/fractal_interpolation/error_bounds.hpp>

/// Where the graph can be: ranges of phi over cells. A cell is an address: the image of the whole under the maps of its
/// digits; it has as many digits as it is deep.
namespace burin::curves::fractal_interpolation {

/// Ranges of phi over all cells down to a depth, and what the maps do to deeper ones.
struct Enclosures {
  std::vector<std::vector<Interval>> by_depth;  ///< [depth][digits read as a number]
  std::vector<Stretch> stretches;

  std::size_t depth() const { return by_depth.size() - 1; }
};

/// The ranges follow from one another by the functional equation, so that they are as tight as the cells are small: a
/// few thousand of them, one level at least.
Enclosures make_enclosures(const Interpolant& f);

/// theta of the left ends of all cells of one depth, in order, and 1.
std::vector<double> cell_ends(const Interpolant& f, std::size_t depth);

/// The left end of a cell, and a range of phi over it.
struct CellBox {
  GraphPoint left;
  double width = 1.0;  ///< in theta
  Interval range;
};

/// O(number of digits).
CellBox cell_box(const Interpolant& f, const Enclosures& enclosures, std::span<const std::uint32_t> digits);

/// The left end alone, bit-equal to point_at(f, digits, 0).
GraphPoint cell_left(const Interpolant& f, std::span<const std::uint32_t> digits);

}  // namespace burin::curves::fractal_interpolation
