#pragma once

#include <algorithm>
#include <limits>

#include <burin/geom/affine2.hpp>
#include <burin/geom/vec2.hpp>

namespace burin {

/// An axis-parallel box, borders included. The default box is empty: it contains nothing and grows from nothing.
struct Box2 {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  friend constexpr bool operator==(const Box2&, const Box2&) = default;

  static constexpr Box2 everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{-inf, -inf}, {inf, inf}};
  }

  constexpr bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  constexpr double width() const { return high.x - low.x; }
  constexpr double height() const { return high.y - low.y; }
  constexpr Vec2 center() const { return {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}; }

  constexpr void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr void add(const Box2& other) {
    if (other.empty()) return;
    add(other.low);
    add(other.high);
  }
  constexpr bool contains(Vec2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
  /// Whether the disc of radius r about c has a point in the box (a box about the disc is tested: no false "no").
  constexpr bool touches_disc(Vec2 c, double r) const {
    return c.x + r >= low.x && c.x - r <= high.x && c.y + r >= low.y && c.y - r <= high.y;
  }
  constexpr bool contains_disc(Vec2 c, double r) const {
    return c.x - r >= low.x && c.x + r <= high.x && c.y - r >= low.y && c.y + r <= high.y;
  }
  /// Whether the boxes share a point. An empty box touches nothing.
  constexpr bool touches(const Box2& other) const {
    return other.low.x <= high.x && other.high.x >= low.x && other.low.y <= high.y && other.high.y >= low.y;
  }
  constexpr Box2 grown(double by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
};

/// What lies in both; may be empty.
constexpr Box2 intersection(const Box2& a, const Box2& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

/// The smallest box around the image of `box`.
constexpr Box2 image_box(const Affine2& map, const Box2& box) {
  Box2 image;
  if (box.empty()) return image;
  image.add(map(box.low));
  image.add(map({box.high.x, box.low.y}));
  image.add(map(box.high));
  image.add(map({box.low.x, box.high.y}));
  return image;
}

}  // namespace burin
