#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/path/sheet.hpp>

namespace burin::passes {

/// Parts of a segment, as parameters along it: 0 <= from < to <= 1.
struct Part {
  double from = 0.0;
  double to = 1.0;
};

/// Whether a line along the border of a shape counts as covered.
enum class Border : bool { is_outside, is_inside };

/// Closed shapes on the page, lying on one another in the order in which they were added, and indexed so that a segment
/// is compared only with the edges near it.
///
/// A shape belongs to an item: what is drawn as one (a placed figure, a path) and does not cover itself. Memory: 32
/// bytes an edge, and the index. Const queries may run in several threads, each with a Query of its own.
class Regions {
 public:
  using Item = std::uint64_t;

  /// Adds the area of a path: its contours are closed, `rule` (a fill) says what is inside. Contours of fewer than
  /// three points have no area. Items come in ascending order.
  void add(Item item, const std::vector<std::vector<Vec2>>& contours, Paint rule);

  /// To be called once, after the last add. O(edges).
  void build_index();

  bool empty() const { return shapes_.empty(); }
  std::size_t size() const { return shapes_.size(); }

  /// Room for an answer and its working memory.
  class Query {
   public:
    std::span<const Part> parts() const { return covered_; }

   private:
    friend class Regions;
    std::vector<Part> covered_;        ///< ascending, apart from one another
    std::vector<double> cuts_;         ///< where the segment may change sides
    std::vector<std::uint64_t> seen_;  ///< by shape: the number of the query that met it last
    std::uint64_t number_ = 0;
  };

  /// The parts of the segment a b that lie in shapes of items from `first_item` on. Borders are exact to 1e-9 mm. Time:
  /// proportional to the edges near the segment.
  void cover(Vec2 a, Vec2 b, Item first_item, Border border, Query& query) const;

  /// Whether the point lies in a shape of an item from `first_item` on.
  bool covers(Vec2 point, Item first_item, Border border, Query& query) const;

  /// The shapes of items from `first_item` on whose boxes touch `box`, ascending.
  std::vector<std::size_t> near(const Box2& box, Item first_item, Query& query) const;

  /// The contours of a shape, and its rule.
  const std::vector<std::vector<Vec2>>& contours(std::size_t shape) const { return shapes_[shape].contours; }
  Paint rule(std::size_t shape) const { return shapes_[shape].rule; }

 private:
  struct Edge {
    Vec2 from;
    Vec2 to;
  };
  /// A closed shape, its edges sorted into slabs by height: those of slab s are
  /// slab_edges_[slab_begins_[first_slab + s]] up to the next slab's.
  struct Shape {
    Item item = 0;
    Paint rule = Paint::fill_nonzero;
    Box2 box{};
    std::vector<std::vector<Vec2>> contours{};
    std::size_t first_edge = 0;
    std::size_t edge_count = 0;
    std::size_t first_slab = 0;
    std::size_t slab_count = 1;
    double slabs_per_mm = 0.0;

    std::size_t slab_at(double y) const;
  };

  /// Columns and rows of the grid, the last included.
  struct Cells {
    std::size_t left = 0;
    std::size_t right = 0;
    std::size_t top = 0;
    std::size_t bottom = 0;
    double count() const { return static_cast<double>(right - left + 1) * static_cast<double>(bottom - top + 1); }
  };

  void build_slabs(Shape& shape);
  Cells cells_of(const Box2& box) const;
  Box2 part_in_row(Vec2 a, Vec2 b, const Box2& box, std::size_t row) const;
  template <class Visit>
  void for_edges_between(const Shape& shape, double low_y, double high_y, const Visit& visit) const;
  template <class PartInRow, class Visit>
  void for_shapes_near(const Box2& box, Item first_item, Query& query, const PartInRow& part_in_row,
                       const Visit& visit) const;
  bool contains(const Shape& shape, Vec2 point, Border border) const;
  void cover_by(const Shape& shape, Vec2 a, Vec2 b, Border border, Query& query) const;

  std::vector<Shape> shapes_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> slab_edges_;  ///< counted from the shape's first edge
  std::vector<std::size_t> slab_begins_;

  /// A grid over all shapes but the wide ones, which would fill too many of its cells.
  Box2 grid_box_{};
  double cell_mm_ = 1.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> cell_shapes_;
  std::vector<std::size_t> cell_begins_;
  std::vector<std::uint32_t> wide_shapes_;
};

}  // namespace burin::passes
