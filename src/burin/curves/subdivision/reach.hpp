#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <burin/curves/subdivision/matrix.hpp>
#include <burin/curves/subdivision/scheme.hpp>

namespace burin::curves::subdivision {

/// A scheme as the linear maps from a window to those of its halves.
struct WindowMaps {
  struct Halves {
    Matrix left;
    Matrix right;
  };
  std::size_t window = 0;
  std::size_t start = 0;
  std::vector<Halves> by_ends;  ///< index: 1 if the piece touches the first end, plus 2 if it touches the last
};

/// How far the points of a piece can be from what is known of it, in differences of its window: found from all words of
/// up to six halvings, and from there on by repetition. Safe for every number of levels; infinite when it passes the
/// range of numbers. Source: the technique of curves.md A.4, with norms of matrices for ratios.
struct Reach {
  /// By levels still to come: the distance of the points, ends included, from the middle between the window's start
  /// and the point after it, in longest edges of the window.
  std::vector<double> inner;
  std::vector<double> at_ends;  ///< the same for pieces that touch an end

  /// For schemes that carry equally spaced points of a line into the like, and inside the curve only: the distance from
  /// the line through the window's start (0) and the point after it (1), between the parameters `from` and `to`, in
  /// largest second differences of the window. Empty for other schemes.
  std::vector<double> bend;
  double from = 0.0;
  double to = 1.0;
};

Reach make_reach(const WindowMaps& maps, int levels);

template <class S>
WindowMaps window_maps(const S& scheme) {
  WindowMaps maps{S::window, S::start, {}};
  for (const Ends ends : {Ends{}, Ends{true, false}, Ends{false, true}, Ends{true, true}}) {
    WindowMaps::Halves halves{Matrix(S::window), Matrix(S::window)};
    for (std::size_t column = 0; column < S::window; ++column) {
      Piece<double, S::window> piece{{}, ends, 0};
      piece.window[column] = 1.0;
      const std::array<double, S::window + 1> fresh = refined(scheme, piece);
      for (std::size_t row = 0; row < S::window; ++row) {
        halves.left.at(row, column) = fresh[row];
        halves.right.at(row, column) = fresh[row + 1];
      }
    }
    maps.by_ends.push_back(halves);
  }
  return maps;
}

/// The most that `factor` times a length can be: 0 whenever the length is, even for a factor beyond all numbers.
inline double scaled(double factor, double length) {
  return length == 0.0 ? 0.0 : factor * length;
}

}  // namespace burin::curves::subdivision
