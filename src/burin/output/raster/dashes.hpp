#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <burin/output/raster/path_stroker.hpp>

namespace burin::output::raster {

/// Cuts a line into dashes and hands them to a stroker. As in SVG and with Cairo: on, off, on ... from `offset` on, an
/// odd list is read twice; a dash without length is a dot that lies along the line; a closed line that begins and ends
/// in a dash has no caps there. Memory: the first dash of a closed line.
class Dashes {
 public:
  explicit Dashes(PathStroker& stroker) : stroker_(stroker) {}

  /// In pixels; none: a full line. A pattern shorter than 1/256 pixel is a full line: no dash of it could show.
  void set_pattern(const std::vector<double>& lengths, double offset);

  /// begin to+ end, as PathStroker's.
  void begin(bool closed);
  void to(Vec2 p);
  void to(std::span<const Vec2> points, double scale);
  void end();

 private:
  bool is_full_line() const { return period_ == 0.0; }
  void restart_pattern(double along);
  void walk(Vec2 from, Vec2 to);
  void next_dash(Vec2 at, Vec2 direction);
  void lift(Vec2 direction);
  void draw_to(Vec2 p);

  PathStroker& stroker_;
  std::vector<double> lengths_;
  double offset_ = 0.0;
  double period_ = 0.0;

  std::size_t dash_ = 0;  ///< index into lengths_; even: on
  double left_ = 0.0;     ///< of that dash
  bool down_ = false;     ///< a dash is being drawn

  bool closed_ = false;
  bool started_ = false;
  bool moved_ = false;
  bool keeps_first_ = false;  ///< the dash being drawn is the first of a closed line: it goes to first_dash_
  Vec2 first_;
  Vec2 last_;
  double length_ = 0.0;  ///< of the line so far
  std::vector<Vec2> first_dash_;
};

}  // namespace burin::output::raster
