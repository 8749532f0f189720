#include <array>
#include <utility>

#include <burin/geom/clip.hpp>

namespace burin {

namespace {

/// Where from a (0) to b (1) the value `at` lies. Halves, so that no difference of finite numbers overflows.
double fraction(double a, double b, double at) {
  return (0.5 * at - 0.5 * a) / (0.5 * b - 0.5 * a);
}

/// (1 - t) a + t b: unlike a + t (b - a) it cannot overflow.
double between(double a, double b, double t) {
  return (1.0 - t) * a + t * b;
}

/// One border of a box: keeps the points whose coordinate `of` is not on the outer side of `at`.
struct Border {
  double Vec2::*of;
  double Vec2::*other;
  double at;
  bool upper;

  bool keeps(Vec2 p) const { return upper ? p.*of <= at : p.*of >= at; }
  Vec2 crossing(Vec2 a, Vec2 b) const {
    Vec2 p;
    p.*of = at;
    p.*other = between(a.*other, b.*other, fraction(a.*of, b.*of, at));
    return p;
  }
};

std::array<Border, 4> borders_of(const Box2& box) {
  return {{{&Vec2::x, &Vec2::y, box.low.x, false},
           {&Vec2::x, &Vec2::y, box.high.x, true},
           {&Vec2::y, &Vec2::x, box.low.y, false},
           {&Vec2::y, &Vec2::x, box.high.y, true}}};
}

void clip_at(const Border& border, const std::vector<Vec2>& polygon, std::vector<Vec2>& kept) {
  kept.clear();
  if (polygon.empty()) return;
  Vec2 before = polygon.back();
  bool before_kept = border.keeps(before);
  for (const Vec2 p : polygon) {
    const bool p_kept = border.keeps(p);
    if (p_kept != before_kept) kept.push_back(border.crossing(before, p));
    if (p_kept) kept.push_back(p);
    before = p;
    before_kept = p_kept;
  }
}

}  // namespace

std::optional<Segment> clip_segment(Vec2 a, Vec2 b, const Box2& box) {
  for (const Border& border : borders_of(box)) {
    const bool a_kept = border.keeps(a);
    const bool b_kept = border.keeps(b);
    if (!a_kept && !b_kept) return std::nullopt;
    if (!a_kept) a = border.crossing(a, b);
    if (!b_kept) b = border.crossing(a, b);
  }
  return Segment{a, b};
}

void clip_polygon(std::vector<Vec2>& polygon, std::vector<Vec2>& spare, const Box2& box) {
  for (const Border& border : borders_of(box)) {
    clip_at(border, polygon, spare);
    std::swap(polygon, spare);
  }
}

}  // namespace burin
