#pragma once

#include <array>
#include <cstddef>

#include <burin/curves/refinement/cover.hpp>

/// Subdivision schemes whose new points are weighted sums of a few old ones, drawn depth first: a window of control
/// points determines one piece of the curve, and refining the window gives the windows of the piece's two halves. So a
/// curve of 2^levels points needs O(levels) windows of memory, and a piece can be left out or cut short by itself.
///
/// A scheme S is a value with
///   static constexpr std::size_t window;   how many points determine a piece
///   static constexpr std::size_t start;    which of them the piece begins at; it ends at the one after
///   void refine(const P* old, std::size_t count, P* fresh) const;
///       any run of points to the 2 count - window + 1 points that follow from it
///   void mend(const Piece<P, window>&, std::array<P, window + 1>& fresh) const;
///       what the rule for the ends of open curves changes in a refined window
///   bool keeps_points() const;             whether a level has the points of the one before, bit for bit
///   Cover<P> cover(const Piece<P, window>&, int remaining) const;
///       where the piece lies after `remaining` more levels
/// for every type of point P that can be added and multiplied by a number.
namespace burin::curves::subdivision {

/// Whether a piece touches an end of an open curve, where the scheme's rule for ends takes over.
struct Ends {
  bool first = false;
  bool last = false;
};

/// A part of the curve between two neighbouring points of a level: all finer points there follow from the window.
template <class Point, std::size_t Size>
struct Piece {
  std::array<Point, Size> window;
  Ends ends;
  int level = 0;
  bool closes = false;  ///< the last point of the piece is the one that a closed curve began with
};

template <class S, class Point>
using PieceOf = Piece<Point, S::window>;

/// The windows of both halves: the first one and the last one of `window` points in a row.
template <class S, class Point>
std::array<Point, S::window + 1> refined(const S& scheme, const PieceOf<S, Point>& piece) {
  std::array<Point, S::window + 1> fresh;
  scheme.refine(piece.window.data(), S::window, fresh.data());
  if (piece.ends.first || piece.ends.last) scheme.mend(piece, fresh);
  return fresh;
}

enum class Half : std::size_t { left, right };

template <class S, class Point>
PieceOf<S, Point> half_of(const PieceOf<S, Point>& parent, const std::array<Point, S::window + 1>& fresh, Half half) {
  PieceOf<S, Point> piece;
  for (std::size_t i = 0; i < S::window; ++i) piece.window[i] = fresh[i + static_cast<std::size_t>(half)];
  piece.ends = {parent.ends.first && half == Half::left, parent.ends.last && half == Half::right};
  piece.level = parent.level + 1;
  piece.closes = parent.closes && half == Half::right;
  return piece;
}

/// The window at the outermost descendant of a piece: its start (left) or its end (right) at the last level. Most
/// windows shrink to one point long before level 1000, where nothing changes any more.
template <class S, class Point>
std::array<Point, S::window> outermost_window(const S& scheme, PieceOf<S, Point> piece, Half half, int levels) {
  while (piece.level < levels) {
    const PieceOf<S, Point> next = half_of<S>(piece, refined(scheme, piece), half);
    if (next.window == piece.window) break;
    piece = next;
  }
  return piece.window;
}

/// The point of the last level that a piece begins with.
template <class S, class Point>
Point start_of(const S& scheme, const PieceOf<S, Point>& piece, int levels) {
  if (scheme.keeps_points()) return piece.window[S::start];
  return outermost_window(scheme, piece, Half::left, levels)[S::start];
}

}  // namespace burin::curves::subdivision
