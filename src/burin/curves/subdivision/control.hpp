#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <burin/curves/subdivision/scheme.hpp>

namespace burin::curves::subdivision {

/// The control points of one curve, ghosts and all: every `window` of them in a row is a piece.
template <class Point>
struct Control {
  std::vector<Point> points;
  bool closed = false;
  std::size_t lead = 0;   ///< how many points before the first piece belong to the curve; closed: they end its last
  std::size_t trail = 0;  ///< open: how many after the end of the last piece
};

template <class S, class Point>
std::size_t piece_count(const Control<Point>& control) {
  return control.points.size() < S::window ? 0 : control.points.size() - S::window + 1;
}

/// Pre: index < piece_count.
template <class S, class Point>
PieceOf<S, Point> piece_at(const Control<Point>& control, std::size_t index) {
  PieceOf<S, Point> piece{};
  for (std::size_t i = 0; i < S::window; ++i) piece.window[i] = control.points[index + i];
  const bool is_last = index + 1 == piece_count<S>(control);
  piece.ends = {!control.closed && index == 0, !control.closed && is_last};
  piece.closes = control.closed && control.lead > 0 && is_last;
  return piece;
}

/// How many points a curve has beside those of its pieces. Points without pieces, open and shorter than a window, are
/// the curve as they stand.
template <class S, class Point>
std::size_t points_beside(const Control<Point>& control) {
  if (piece_count<S>(control) == 0) return control.points.size();
  return control.closed ? control.lead : control.lead + 1 + control.trail;
}

template <class S, class Point>
double points_at_level(const Control<Point>& control, int levels) {
  auto points = static_cast<double>(piece_count<S>(control));
  for (int level = 0; level < levels; ++level) points *= 2.0;
  return control.closed ? points : points + static_cast<double>(points_beside<S>(control));
}

/// A closed curve's points with as many repeated at both sides as the windows of a scheme need. `lead`: 1 for a curve
/// that begins with the last point of the piece before the first. Pre: not empty; lead <= 1.
template <class S, class Point>
Control<Point> closed_control(const std::vector<Point>& points, std::size_t lead) {
  Control<Point> control{{}, true, lead};
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count + S::window - 1; ++i) {
    control.points.push_back(points[(i + count * S::start - S::start + lead) % count]);
  }
  return control;
}

/// The points of the last level before the first piece of an open curve.
template <class S, class Point>
std::vector<Point> points_before(const S& scheme, const Control<Point>& control, int levels) {
  if (piece_count<S>(control) == 0) return control.points;
  if (control.lead == 0) return {};
  const auto window = outermost_window(scheme, piece_at<S>(control, 0), Half::left, levels);
  return {window.begin() + static_cast<std::ptrdiff_t>(S::start - control.lead),
          window.begin() + static_cast<std::ptrdiff_t>(S::start)};
}

/// The points of the last level from the end of the last piece on; none for a closed curve.
template <class S, class Point>
std::vector<Point> points_after(const S& scheme, const Control<Point>& control, int levels) {
  const std::size_t pieces = piece_count<S>(control);
  if (control.closed || pieces == 0) return {};
  const auto window = outermost_window(scheme, piece_at<S>(control, pieces - 1), Half::right, levels);
  const auto end = window.begin() + static_cast<std::ptrdiff_t>(S::start + 1);
  return {end, end + 1 + static_cast<std::ptrdiff_t>(control.trail)};
}

}  // namespace burin::curves::subdivision
