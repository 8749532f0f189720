#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <cairo.h>

#include <burin/geom/box2.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output_cairo {

/// The largest page, pen width and reach of a stroke in device units. Cairo wraps silently at 2^23; a page with all
/// that lies on and around it stays below half of that.
inline constexpr double farthest = 1048576.0;

/// How contours are stroked; lengths in device units.
struct StrokeStyle {
  double width = 1.0;
  Cap cap = Cap::round;
  Join join = Join::round;
  double miter_limit = 4.0;
  std::vector<double> dashes{};
  double dash_offset = 0.0;
};

/// Strokes contours with Cairo: many short ones at once, since the soft edges of strokes drawn one over another darken
/// where they meet, and long ones in pieces, since one long path costs Cairo superlinear time and 640 bytes a segment.
///
/// Pieces lie over each other a little at a cut, so that it does not show; caps are drawn at the real ends only, every
/// join is drawn whole. Dashed contours are cut only where a vertex falls between two dashes. What lies too far outside
/// the page to show is cut off, so that no coordinate wraps (a dashed contour that is cut loses the join where it
/// closes). Memory: one piece; a dashed contour without a vertex between two dashes: all of it.
class Stroker {
 public:
  static constexpr std::size_t piece_segments = 8000;

  /// `page`: what can be seen, in device units. `grain`: inner points of a full line that are no farther than this from
  /// the last one are left out.
  Stroker(cairo_t* to, const Box2& page, double grain) : to_(to), page_(page), box_(page), grain_(grain) {}

  /// For the contours that follow. Between contours only.
  void set_style(const StrokeStyle& style);

  /// Draws what is held back. Between contours; before anything else is done to the surface.
  void flush();

  /// begin_contour add+ end_contour.
  void begin_contour(bool closed);
  /// The points times `device_per_mm` are the contour's next.
  void add(std::span<const Vec2> points, double device_per_mm);
  void end_contour();

 private:
  void start(Vec2 p);
  void step(Vec2 p);
  void step_across_border(Vec2 p, bool p_inside);
  void cut();
  void close();
  enum class Tail : bool { cut, real_end };
  void stroke_piece(Tail tail);
  void stroke_piece_with_caps(bool at_front, bool at_back);
  void stroke_dot(Vec2 at);
  void path_through_piece();

  /// How Cairo is to stroke the path it has been given so far.
  struct Gathered {
    cairo_line_cap_t cap = CAIRO_LINE_CAP_ROUND;
    std::optional<double> dash_phase{};  ///< unset: a full line
    friend bool operator==(const Gathered&, const Gathered&) = default;
  };
  void gather(const Gathered& as, std::size_t segments);
  bool dashed() const { return dash_period_ > 0.0; }
  double dash_phase(double length) const;
  bool between_dashes(double length) const;

  cairo_t* to_;
  Box2 page_;
  Box2 box_;  ///< the page and as far around it as a stroke can reach
  double grain_;
  StrokeStyle style_;
  double dash_period_ = 0.0;  ///< 0: a full line

  Gathered gathered_;
  std::size_t gathered_segments_ = 0;

  std::vector<Vec2> piece_;  ///< not drawn yet, all inside box_; empty while the contour is outside
  bool piece_starts_contour_ = false;
  double piece_begin_ = 0.0;  ///< length of the contour up to the piece; kept for dashes only
  bool closed_ = false;
  bool started_ = false;
  bool moved_ = false;   ///< the contour has two different points
  bool whole_ = false;   ///< the piece is all there is of the contour
  bool inside_ = false;  ///< last_ is in box_
  Vec2 first_;
  Vec2 second_;
  Vec2 last_;
  Vec2 newest_;          ///< last_, or a point near it that is left out so far
  double length_ = 0.0;  ///< length of the contour up to last_; kept for dashes only
};

}  // namespace burin::output_cairo
