#pragma once

#include <span>

#include <burin/geom/box2.hpp>
#include <burin/output/raster/ink.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output::raster {

/// How a line is drawn; lengths in pixels.
struct StrokeStyle {
  double width = 1.0;
  Cap cap = Cap::round;
  Join join = Join::round;
  double miter_limit = 4.0;
};

/// Cuts a line into shapes: a body for each segment, a cap or a join for each vertex. O(1) memory.
///
/// Positions are rounded to units, points that fall together are one. What lies very far outside the page is cut off
/// before rounding. A line without length is a dot: a disc for round caps, a square along the
/// axes for square ones, nothing for butt ones, as in SVG and with Cairo.
class PathStroker {
 public:
  /// `page`: in pixels; at most 2^17 wide and high. `ink` must outlive the stroker.
  PathStroker(Ink& ink, const Box2& page) : ink_(ink), page_(page), box_(page) {}

  /// For the lines that follow. Between lines only.
  void set_style(const StrokeStyle& style);
  /// Points outside do not show and cannot be rounded.
  const Box2& box() const { return box_; }

  /// begin to+ end. In pixels.
  void begin(bool closed);
  void to(Vec2 p);
  /// The same for many points, each times `scale`, faster.
  void to(std::span<const Vec2> points, double scale);
  /// `direction`: how a square dot lies.
  void end(Vec2 direction = {1.0, 0.0});

 private:
  void enter(Vec2 at);
  void step(Point p);
  bool round_line_to(std::span<const Vec2> points, double scale);
  void close();
  /// Each segment then has the disc about its start with it: all caps and joins but the cap of an open line's end.
  bool is_round() const { return style_.cap == Cap::round && style_.join == Join::round; }
  bool can_show(Point a, Point b) const;
  void cap(Point end, Point inner);
  void join(Point before, Point corner, Point after);
  void dot(Point at, Vec2 direction);

  Ink& ink_;
  Box2 page_;
  Box2 box_;
  PixelBox sight_;           ///< in units, not pixels; points outside have no ink on the page
  double half_width_ = 0.5;  ///< units
  StrokeStyle style_;
  RoundPen pen_{half_width_};

  bool closed_ = false;
  bool started_ = false;
  bool moved_ = false;   ///< the line has two different points
  bool inside_ = false;  ///< exact_ is in box_
  Vec2 exact_first_;
  Vec2 exact_;  ///< the last point

  // The run of points inside box_ that the last point belongs to.
  int run_length_ = 0;         ///< different points, 2 when there are more
  bool run_is_first_ = false;  ///< it began where the line did
  Point before_;
  Point last_;

  Point first_;
  Point second_;
  bool has_second_ = false;  ///< the line began inside box_, with first_ and second_
};

}  // namespace burin::output::raster
