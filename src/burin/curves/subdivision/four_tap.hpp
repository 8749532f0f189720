#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <burin/curves/subdivision/cover.hpp>
#include <burin/curves/subdivision/reach.hpp>
#include <burin/curves/subdivision/scheme.hpp>

namespace burin::curves::subdivision {

/// The points before the first and after the last of an open curve that a scheme needs: a line through the end, the
/// curve reflected, the end again; or none: the outermost points given are themselves the ghosts.
enum class GhostRule : std::uint8_t { linear, reflect, replicate, given };

/// The ghost k steps beyond an end, from the end and the point k steps before it.
template <class Point>
Point ghost(GhostRule rule, const Point& end, const Point& inside) {
  if (rule == GhostRule::linear) return 2.0 * end - inside;
  return rule == GhostRule::reflect ? inside : end;
}

/// P'_{2i} = sum even_k P_{i-1+k} (k = 0..2), P'_{2i+1} = sum odd_k P_{i-1+k} (k = 0..3), both with weights of sum 1:
/// four-point and four-parameter schemes.
class FourTap {
 public:
  static constexpr std::size_t window = 6;
  static constexpr std::size_t start = 2;

  /// `remade`: the rule by which the ghosts of an open curve are made anew at each level; given: never, they are
  /// refined like other points.
  FourTap(const std::array<double, 3>& even, const std::array<double, 4>& odd, GhostRule remade, int levels)
      : even_(even), odd_(odd), remade_(remade) {
    reach_ = make_reach(window_maps(*this), levels);
  }

  template <class Point>
  void refine(const Point* old, std::size_t count, Point* fresh) const {
    for (std::size_t k = 0; k + 3 < count; ++k) {
      fresh[2 * k] = even_point(old + k);
      fresh[2 * k + 1] = odd_[0] * old[k] + odd_[1] * old[k + 1] + odd_[2] * old[k + 2] + odd_[3] * old[k + 3];
    }
    fresh[2 * (count - 3)] = even_point(old + count - 3);
  }

  template <class Point>
  void mend(const Piece<Point, window>& piece, std::array<Point, window + 1>& fresh) const {
    if (remade_ == GhostRule::given) return;
    // Refined, the ends themselves are at 2 (first) and 4 (last).
    for (std::size_t k = 1; k <= 2; ++k) {
      if (piece.ends.first) fresh[2 - k] = ghost(remade_, fresh[2], fresh[2 + k]);
      if (piece.ends.last) fresh[4 + k] = ghost(remade_, fresh[4], fresh[4 - k]);
    }
  }

  bool keeps_points() const { return even_ == std::array{0.0, 1.0, 0.0}; }

  template <class Point>
  Cover<Point> cover(const Piece<Point, window>& piece, int remaining) const {
    const auto k = static_cast<std::size_t>(remaining);
    if (piece.ends.first || piece.ends.last) return disc_of_piece(piece, start, reach_.at_ends[k]);
    const Cover<Point> disc = disc_of_piece(piece, start, reach_.inner[k]);
    if (reach_.bend.empty()) return disc;
    const double radius = scaled(reach_.bend[k], largest_difference(piece.window, 2));
    if (radius >= disc.radius) return disc;
    const Point begin = piece.window[start];
    const Point along = piece.window[start + 1] - begin;
    return {begin + reach_.from * along, begin + reach_.to * along, radius, 2.0 * radius};
  }

 private:
  template <class Point>
  Point even_point(const Point* old) const {
    return even_[0] * old[0] + even_[1] * old[1] + even_[2] * old[2];
  }

  std::array<double, 3> even_;
  std::array<double, 4> odd_;
  GhostRule remade_;
  Reach reach_;
};

}  // namespace burin::curves::subdivision
