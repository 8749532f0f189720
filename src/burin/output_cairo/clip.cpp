#include <algorithm>
#include <burin/output_cairo/clip.hpp>
#include <utility>

namespace burin::output_cairo {

namespace {

/// Where from a (0) to b (1) the value `at` lies. Halves, so that no difference of finite numbers overflows.
double fraction(double a, double b, double at) {
  return (0.5 * at - 0.5 * a) / (0.5 * b - 0.5 * a);
}

/// (1 - t) a + t b: unlike a + t (b - a) it cannot overflow.
double between(double a, double b, double t) {
  return (1.0 - t) * a + t * b;
}

/// Narrows [enter, leave] to where a..b lies in [low, high]; false when that is nowhere.
bool narrow(double a, double b, double low, double high, double& enter, double& leave) {
  if (std::max(a, b) < low || std::min(a, b) > high) return false;
  if (a < low) enter = std::max(enter, fraction(a, b, low));
  if (a > high) enter = std::max(enter, fraction(a, b, high));
  if (b < low) leave = std::min(leave, fraction(a, b, low));
  if (b > high) leave = std::min(leave, fraction(a, b, high));
  return enter <= leave;
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
  double enter = 0.0;
  double leave = 1.0;
  if (!narrow(a.x, b.x, box.low.x, box.high.x, enter, leave)) return std::nullopt;
  if (!narrow(a.y, b.y, box.low.y, box.high.y, enter, leave)) return std::nullopt;
  const auto at = [&](double t) {
    return Vec2{std::clamp(between(a.x, b.x, t), box.low.x, box.high.x),
                std::clamp(between(a.y, b.y, t), box.low.y, box.high.y)};
  };
  return Segment{enter > 0.0 ? at(enter) : a, leave < 1.0 ? at(leave) : b};
}

void clip_polygon(std::vector<Vec2>& polygon, std::vector<Vec2>& spare, const Box2& box) {
  const Border borders[] = {{&Vec2::x, &Vec2::y, box.low.x, false},
                            {&Vec2::x, &Vec2::y, box.high.x, true},
                            {&Vec2::y, &Vec2::x, box.low.y, false},
                            {&Vec2::y, &Vec2::x, box.high.y, true}};
  for (const Border& border : borders) {
    clip_at(border, polygon, spare);
    std::swap(polygon, spare);
  }
}

}  // namespace burin::output_cairo
