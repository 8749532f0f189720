#include <algorithm>

#include <burin/curves/line_art/neighbours.hpp>

namespace burin::curves::line_art {

namespace {

double squared_distance(Vec2 p, const Segment& s) {
  const Vec2 d = s.to - s.from;
  const double dd = length_squared(d);
  const double t = dd > 0.0 ? std::clamp(dot(p - s.from, d) / dd, 0.0, 1.0) : 0.0;
  return length_squared(p - (s.from + t * d));
}

bool crosses(const Segment& s, const Segment& t) {
  const auto sides = [](const Segment& line, const Segment& ends) {
    const Vec2 d = line.to - line.from;
    return cross(d, ends.from - line.from) * cross(d, ends.to - line.from);
  };
  return sides(s, t) < 0.0 && sides(t, s) < 0.0;
}

/// Calls visit(cell) for the cells that the box of a and b, grown by `reach`, touches, until it says false.
template <class Visit>
bool each_cell(Vec2 a, Vec2 b, double reach, double side, const Visit& visit) {
  const Cell low = cell_of({std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach}, side);
  const Cell high = cell_of({std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}, side);
  for (std::int32_t row = low.row; row <= high.row; ++row) {
    for (std::int32_t column = low.column; column <= high.column; ++column) {
      if (!visit(Cell{column, row})) return false;
    }
  }
  return true;
}

}  // namespace

bool nearer_than(const Segment& s, const Segment& t, double limit) {
  if (crosses(s, t)) return true;
  const double nearest = std::min(
      {squared_distance(s.from, t), squared_distance(s.to, t), squared_distance(t.from, s), squared_distance(t.to, s)});
  return nearest < limit * limit;
}

bool Neighbours::is_free(Vec2 a, Vec2 b) const {
  return each_piece(a, b, side_, [&](Vec2 from, Vec2 to) {
    return each_cell(from, to, spacing_, side_, [&](const Cell& cell) {
      const auto found = edges_in_.find(cell);
      if (found == edges_in_.end()) return true;
      return std::none_of(found->second.begin(), found->second.end(), [&](std::uint32_t edge) {
        return nearer_than(edges_[edge], {from, to}, spacing_);
      });
    });
  });
}

void Neighbours::add(Vec2 a, Vec2 b) {
  const auto edge = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back({a, b});
  each_piece(a, b, side_, [&](Vec2 from, Vec2 to) {
    return each_cell(from, to, 0.0, side_, [&](const Cell& cell) {
      std::vector<std::uint32_t>& here = edges_in_[cell];
      if (here.empty() || here.back() != edge) here.push_back(edge);
      return true;
    });
  });
}

}  // namespace burin::curves::line_art
