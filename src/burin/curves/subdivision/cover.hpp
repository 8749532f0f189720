#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <burin/curves/subdivision/reach.hpp>
#include <burin/curves/subdivision/scheme.hpp>

/// Measures of a window from which a scheme makes its cover.
namespace burin::curves::subdivision {

/// The greatest length of the differences of this order (1 or 2) of a window.
template <class Point, std::size_t Size>
double largest_difference(std::array<Point, Size> window, std::size_t order) {
  for (std::size_t step = 0; step < order; ++step) {
    for (std::size_t i = 0; i + 1 + step < Size; ++i) window[i] = window[i + 1] - window[i];
  }
  double largest = 0.0;
  for (std::size_t i = 0; i + order < Size; ++i) largest = std::max(largest, length_squared(window[i]));
  return std::sqrt(largest);
}

/// The disc about a point that holds the whole window.
template <class Point, std::size_t Size>
Cover<Point> disc_of_window(const std::array<Point, Size>& window, const Point& centre) {
  double farthest = 0.0;
  for (const Point& p : window) farthest = std::max(farthest, length_squared(p - centre));
  const double radius = std::sqrt(farthest);
  return {centre, centre, radius, 2.0 * radius};
}

/// A disc about the middle of a piece's first and next point; `steps` is its radius in longest edges of the window.
template <class Point, std::size_t Size>
Cover<Point> disc_of_piece(const Piece<Point, Size>& piece, std::size_t start, double steps) {
  const Point middle = 0.5 * (piece.window[start] + piece.window[start + 1]);
  const double radius = scaled(steps, largest_difference(piece.window, 1));
  return {middle, middle, radius, 2.0 * radius};
}

template <class Point>
double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = length_squared(along);
  const double t = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return distance(p, a + t * along);
}

}  // namespace burin::curves::subdivision
