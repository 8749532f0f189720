#include <algorithm>
#include <cmath>

#include <burin/base/check.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/passes/regions.hpp>

namespace burin::passes {

namespace {

/// Nearer than this a point is on a border, and a part of a segment too short to ask for.
constexpr double border_mm = 1e-9;
/// Shapes are held within this, where differences of coordinates still mean something.
constexpr double farthest_mm = 1e9;

constexpr std::size_t edges_per_slab = 8;
constexpr std::size_t most_slabs = 1 << 14;
constexpr double most_cells_of_a_shape = 64.0;

/// Which of `count` equal steps from `low` holds `at`, the first and the last reaching out to infinity.
std::size_t step_at(double at, double low, double steps_per_mm, std::size_t count) {
  const double step = (at - low) * steps_per_mm;
  return step > 0.0 ? std::min(static_cast<std::size_t>(std::min(step, 1e9)), count - 1) : 0;
}

/// Sorts the parts and makes one of those that overlap or have no more than `gap` between them: shapes that share a
/// border leave nothing between them.
void join_parts(std::vector<Part>& parts, double gap) {
  if (parts.size() < 2) return;
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.from < b.from; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].from <= parts[kept].to + gap) {
      parts[kept].to = std::max(parts[kept].to, parts[i].to);
    } else {
      parts[++kept] = parts[i];
    }
  }
  parts.resize(kept + 1);
}

bool is_inside(int winding, Paint rule) {
  return rule == Paint::fill_evenodd ? winding % 2 != 0 : winding != 0;
}

}  // namespace

std::size_t Regions::Shape::slab_at(double y) const {
  return step_at(y, box.low.y, slabs_per_mm, slab_count);
}

void Regions::add(Item item, const std::vector<std::vector<Vec2>>& contours, Paint rule) {
  BURIN_EXPECT(shapes_.empty() || shapes_.back().item <= item);
  BURIN_EXPECT(cell_begins_.empty());
  Shape shape{.item = item, .rule = rule, .first_edge = edges_.size()};
  for (const std::vector<Vec2>& contour : contours) {
    if (contour.size() < 3) continue;
    std::vector<Vec2>& kept = shape.contours.emplace_back();
    for (const Vec2 p : contour) {
      kept.push_back({std::clamp(p.x, -farthest_mm, farthest_mm), std::clamp(p.y, -farthest_mm, farthest_mm)});
      shape.box.add(kept.back());
    }
    for (std::size_t i = 0; i < kept.size(); ++i) edges_.push_back({kept[i], kept[i + 1 == kept.size() ? 0 : i + 1]});
  }
  shape.edge_count = edges_.size() - shape.first_edge;
  if (shape.edge_count == 0) return;
  build_slabs(shape);
  shapes_.push_back(std::move(shape));
}

void Regions::build_slabs(Shape& shape) {
  shape.slab_count = std::clamp<std::size_t>(shape.edge_count / edges_per_slab, 1, most_slabs);
  shape.slabs_per_mm = shape.box.height() > 0.0 ? static_cast<double>(shape.slab_count) / shape.box.height() : 0.0;
  shape.first_slab = slab_begins_.size();
  const auto slabs_of = [&](const Edge& edge) {
    const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
    return std::pair(shape.slab_at(low), shape.slab_at(high));
  };
  // Counted first, then filled in from behind, so that every list comes out in order.
  std::vector<std::size_t> begins(shape.slab_count + 1, 0);
  for (std::size_t e = 0; e < shape.edge_count; ++e) {
    const auto [low, high] = slabs_of(edges_[shape.first_edge + e]);
    for (std::size_t slab = low; slab <= high; ++slab) ++begins[slab];
  }
  std::size_t end = slab_edges_.size();
  for (std::size_t& begin : begins) begin = end += begin;
  slab_edges_.resize(end);
  for (std::size_t e = shape.edge_count; e-- > 0;) {
    const auto [low, high] = slabs_of(edges_[shape.first_edge + e]);
    for (std::size_t slab = low; slab <= high; ++slab) slab_edges_[--begins[slab]] = static_cast<std::uint32_t>(e);
  }
  slab_begins_.insert(slab_begins_.end(), begins.begin(), begins.end());
}

Regions::Cells Regions::cells_of(const Box2& box) const {
  const double cells_per_mm = 1.0 / cell_mm_;
  return {.left = step_at(box.low.x, grid_box_.low.x, cells_per_mm, columns_),
          .right = step_at(box.high.x, grid_box_.low.x, cells_per_mm, columns_),
          .top = step_at(box.low.y, grid_box_.low.y, cells_per_mm, rows_),
          .bottom = step_at(box.high.y, grid_box_.low.y, cells_per_mm, rows_)};
}

void Regions::build_index() {
  BURIN_EXPECT(cell_begins_.empty());
  double sizes_mm = 0.0;
  for (const Shape& shape : shapes_) {
    grid_box_.add(shape.box);
    sizes_mm += std::max(shape.box.width(), shape.box.height());
  }
  cell_begins_.push_back(0);
  if (shapes_.empty()) return;
  const auto count = static_cast<double>(shapes_.size());
  cell_mm_ = std::max({sizes_mm / count, std::sqrt(grid_box_.width() / (4.0 * count) * grid_box_.height()),
                       std::max(grid_box_.width(), grid_box_.height()) / (4.0 * count), border_mm});
  columns_ = static_cast<std::size_t>(grid_box_.width() / cell_mm_) + 1;
  rows_ = static_cast<std::size_t>(grid_box_.height() / cell_mm_) + 1;
  const auto for_cells_of = [&](const Shape& shape, const auto& visit) {
    const Cells cells = cells_of(shape.box);
    if (cells.count() > most_cells_of_a_shape) return false;
    for (std::size_t row = cells.top; row <= cells.bottom; ++row) {
      for (std::size_t column = cells.left; column <= cells.right; ++column) visit(row * columns_ + column);
    }
    return true;
  };
  cell_begins_.assign(columns_ * rows_ + 1, 0);
  for (std::uint32_t s = 0; s < shapes_.size(); ++s) {
    if (!for_cells_of(shapes_[s], [&](std::size_t cell) { ++cell_begins_[cell]; })) wide_shapes_.push_back(s);
  }
  std::size_t end = 0;
  for (std::size_t& begin : cell_begins_) begin = end += begin;
  cell_shapes_.resize(end);
  for (auto s = static_cast<std::uint32_t>(shapes_.size()); s-- > 0;) {
    for_cells_of(shapes_[s], [&](std::size_t cell) { cell_shapes_[--cell_begins_[cell]] = s; });
  }
}

/// Calls visit(edge), once each, for the edges that have points between these heights.
template <class Visit>
void Regions::for_edges_between(const Shape& shape, double low_y, double high_y, const Visit& visit) const {
  const std::size_t first = shape.slab_at(low_y);
  const std::size_t last = shape.slab_at(high_y);
  const Edge* edges = edges_.data() + shape.first_edge;
  for (std::size_t slab = first; slab <= last; ++slab) {
    const std::size_t end = slab_begins_[shape.first_slab + slab + 1];
    for (std::size_t i = slab_begins_[shape.first_slab + slab]; i < end; ++i) {
      const Edge& edge = edges[slab_edges_[i]];
      const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
      if (high < low_y || low > high_y) continue;
      // An edge of several slabs is met in the first of those asked for.
      if (slab > first && shape.slab_at(low) < slab) continue;
      visit(edge);
    }
  }
}

/// Calls visit(shape), once each and in no order, until it returns false, for the shapes that touch `box` and come near
/// part_in_row(row), a box, in some row of the grid.
template <class PartInRow, class Visit>
void Regions::for_shapes_near(const Box2& box, Item first_item, Query& query, const PartInRow& part_in_row,
                              const Visit& visit) const {
  BURIN_EXPECT(!cell_begins_.empty());
  query.seen_.resize(shapes_.size(), 0);
  ++query.number_;
  const auto meets = [&](std::uint32_t s) {
    if (query.seen_[s] == query.number_) return true;
    query.seen_[s] = query.number_;
    return shapes_[s].item < first_item || !shapes_[s].box.touches(box) || visit(s);
  };
  for (const std::uint32_t s : wide_shapes_) {
    if (!meets(s)) return;
  }
  if (!grid_box_.touches(box)) return;
  const Cells cells = cells_of(box);
  for (std::size_t row = cells.top; row <= cells.bottom; ++row) {
    const Cells part = cells_of(part_in_row(row));
    for (std::size_t cell = row * columns_ + part.left; cell <= row * columns_ + part.right; ++cell) {
      for (std::size_t i = cell_begins_[cell]; i < cell_begins_[cell + 1]; ++i) {
        if (!meets(cell_shapes_[i])) return;
      }
    }
  }
}

/// A box around what the segment, with `box` around it, has in this row of the grid; the outer rows reach beyond it.
Box2 Regions::part_in_row(Vec2 a, Vec2 b, const Box2& box, std::size_t row) const {
  if (row == 0 || row + 1 == rows_ || a.y == b.y) return box;
  const double low_y = grid_box_.low.y + cell_mm_ * static_cast<double>(row);
  Box2 part;
  for (const double y : {low_y, low_y + cell_mm_}) {
    part.add(lerp(a, b, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0)));
  }
  return part.grown(1e-6 * cell_mm_);
}

bool Regions::contains(const Shape& shape, Vec2 point, Border border) const {
  if (!shape.box.contains(point)) return false;
  int winding = 0;
  bool on_border = false;
  for_edges_between(shape, point.y - border_mm, point.y + border_mm, [&](const Edge& edge) {
    const Vec2 along = edge.to - edge.from;
    const double side = cross(along, point - edge.from);
    const auto [low_x, high_x] = std::minmax(edge.from.x, edge.to.x);
    on_border = on_border || (std::abs(side) <= border_mm * length(along) && point.x >= low_x - border_mm &&
                              point.x <= high_x + border_mm);
    if ((edge.from.y <= point.y) == (edge.to.y <= point.y)) return;
    if (edge.to.y > edge.from.y) {
      if (side > 0.0) ++winding;
    } else if (side < 0.0) {
      --winding;
    }
  });
  return on_border ? border == Border::is_inside : is_inside(winding, shape.rule);
}

/// Adds the parts of the segment that lie in the shape. It is cut wherever it may cross the border, and each piece is
/// asked for its middle: a crossing too many, as at a vertex, does no harm.
void Regions::cover_by(const Shape& shape, Vec2 a, Vec2 b, Border border, Query& query) const {
  const Vec2 along = b - a;
  const double length_mm = length(along);
  std::vector<double>& cuts = query.cuts_;
  cuts.clear();
  const double shortest = border_mm / length_mm;
  const auto cut_at = [&](Vec2 p) {
    const double t = dot(p - a, along) / (length_mm * length_mm);
    if (t > shortest && t < 1.0 - shortest) cuts.push_back(t);
  };
  const auto [low_y, high_y] = std::minmax(a.y, b.y);
  for_edges_between(shape, low_y - border_mm, high_y + border_mm, [&](const Edge& edge) {
    const double from_side = cross(along, edge.from - a);
    const double to_side = cross(along, edge.to - a);
    if (std::max(std::abs(from_side), std::abs(to_side)) <= border_mm * length_mm) {
      cut_at(edge.from);
      cut_at(edge.to);
    } else if ((from_side >= 0.0) != (to_side >= 0.0)) {
      cut_at(edge.from + from_side / (from_side - to_side) * (edge.to - edge.from));
    }
  });
  std::sort(cuts.begin(), cuts.end());
  cuts.push_back(1.0);
  double from = 0.0;
  double covered_from = 0.0;
  bool covered = false;
  for (const double to : cuts) {
    if (to < 1.0 && to - from <= shortest) continue;
    const bool now = contains(shape, lerp(a, b, 0.5 * (from + to)), border);
    if (covered && !now) query.covered_.push_back({covered_from, from});
    if (now && !covered) covered_from = from;
    covered = now;
    from = to;
  }
  if (covered) query.covered_.push_back({covered_from, 1.0});
}

void Regions::cover(Vec2 a, Vec2 b, Item first_item, Border border, Query& query) const {
  std::vector<Part>& covered = query.covered_;
  covered.clear();
  if (a == b) {
    if (covers(a, first_item, border, query)) covered.push_back({0.0, 1.0});
    return;
  }
  Box2 box;
  box.add(a);
  box.add(b);
  const auto in_row = [&](std::size_t row) { return part_in_row(a, b, box, row); };
  for_shapes_near(box, first_item, query, in_row, [&](std::uint32_t s) {
    cover_by(shapes_[s], a, b, border, query);
    return covered.empty() || covered.back().from > 0.0 || covered.back().to < 1.0;
  });
  join_parts(covered, border_mm / distance(a, b));
}

bool Regions::covers(Vec2 point, Item first_item, Border border, Query& query) const {
  bool found = false;
  const Box2 box{point, point};
  for_shapes_near(
      box, first_item, query, [&](std::size_t) { return box; },
      [&](std::uint32_t s) {
        found = contains(shapes_[s], point, border);
        return !found;
      });
  return found;
}

std::vector<std::size_t> Regions::near(const Box2& box, Item first_item, Query& query) const {
  std::vector<std::size_t> found;
  for_shapes_near(
      box, first_item, query, [&](std::size_t) { return box; },
      [&](std::uint32_t s) {
        found.push_back(s);
        return true;
      });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace burin::passes
