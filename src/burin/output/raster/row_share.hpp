#pragma once

namespace burin::output::raster {

/// The rows of pixels that one of several painters draws: stripes of 32 rows, in turns. Every painter has ink, wherever
/// a drawing is busy.
struct RowShare {
  int index = 0;
  int mask = 0;  ///< the number of painters, a power of two, less 1

  static constexpr int stripe_bits = 5;

  constexpr bool has(int row) const { return ((row >> stripe_bits) & mask) == index; }
  /// Whether it has one of the rows [first, end). Pre: first < end.
  constexpr bool has_any(int first, int end) const {
    if (mask == 0) return true;
    const int stripe = first >> stripe_bits;
    const int last = (end - 1) >> stripe_bits;
    return last - stripe >= mask || ((index - stripe) & mask) <= last - stripe;
  }
};

}  // namespace burin::output::raster
