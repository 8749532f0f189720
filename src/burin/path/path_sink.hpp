#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <burin/geom/affine2.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/path/sheet.hpp>

namespace burin {

class Figure;

/// stop: no further call follows, the drawing is left unfinished.
enum class Flow : bool { stop, go };

/// ink is drawn, mask hides what lies under it, ink_and_mask does both.
enum class Role : std::uint8_t { ink, mask, ink_and_mask };

/// An index into Sheet::layers.
using LayerId = std::uint32_t;

struct PathHead {
  LayerId layer = 0;
  Role role = Role::ink;
  Paint paint = Paint::stroke;
  bool closed = false;      ///< every contour returns to its first point, which is not repeated
  std::uint16_t level = 0;  ///< refinement level, saturating
  friend bool operator==(const PathHead&, const PathHead&) = default;
};

/// Receives a drawing as it is made: (begin points+ [contour points+]* end | place)*, and room_for before any of them.
///
/// Layers come in ascending order. A span is valid during the call only. Every point is finite; a contour has at least
/// one point (one point alone is a dot). A sink needs O(1) state unless it says otherwise. Which space the points are
/// in (model units, y up, or page millimetres, y down) is settled where the sink is made.
class PathSink {
 public:
  PathSink() = default;
  PathSink(const PathSink&) = delete;
  PathSink& operator=(const PathSink&) = delete;
  virtual ~PathSink() = default;

  [[nodiscard]] virtual Flow begin(const PathHead& head) = 0;
  [[nodiscard]] virtual Flow points(std::span<const Vec2> points) = 0;
  /// Starts the next contour of the same path (a ring, an icon).
  [[nodiscard]] virtual Flow contour() = 0;
  [[nodiscard]] virtual Flow end() = 0;

  /// Memory of the sink's own where the next `count` points may be written before they are handed to points(), which
  /// then need not copy them: for a big drawing the copy costs more than the points. It is lent until the next call.
  /// The default, null, lends none; a sink that hands on the very points it takes may lend what the next one lends.
  [[nodiscard]] virtual Vec2* room_for(std::size_t count);

  /// Draws a figure with its points mapped by `at`. The default expands it into the four calls above; a sink that can
  /// name figures overrides it. The head's `closed` and `paint` are the figure's own, path by path.
  [[nodiscard]] virtual Flow place(const PathHead& head, const Figure& figure, const Affine2& at);
};

}  // namespace burin
