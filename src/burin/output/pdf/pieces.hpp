#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include <burin/output/fixed_point.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// The smallest step of a coordinate of a content stream, in mm: whole numbers count steps of a micrometre or, with
/// fewer decimals, more.
double unit_mm(int decimals);

/// The text of a content stream: operators, and paths in pieces. A piece is painted at once and counts from its first
/// point,
///
///     q 1 0 0 1 75000 148500 cm 0 0 m 12 -40 l ... S Q
///
/// so that numbers are short and exact in readers that keep them as floats. A contour of a stroke joins the piece
/// before it when it begins near.
///
/// Source: ISO 32000-1:2008, sections 8.4 and 8.5.
class Pieces {
 public:
  /// Pre: 0 <= decimals <= 6.
  explicit Pieces(int decimals);

  const Grid& grid() const { return grid_; }

  /// Operators outside a piece. Pre: !is_open().
  void add(std::string_view operators);

  /// How contours are painted from here on. Each fill is a piece of its own.
  void begin_path(Paint paint);
  /// A contour goes on from here. Nothing is written before it moves.
  void start(GridPoint at);
  /// Lines to each of `points`, but those that are equal to the one before them. Returns how many. Pre: can_be_rounded.
  std::size_t lines(std::span<const Vec2> points);
  bool line(GridPoint to);
  /// Ends a contour where it began.
  void close();
  /// Ends a contour that has not moved: a line of no length, which round caps make a dot.
  void dot();
  /// Paints the piece that is open, if any.
  void end_piece();

  /// Where the pen is.
  GridPoint at() const { return at_; }
  /// Whether a piece is begun and not painted.
  bool is_open() const { return open_; }
  /// Lines of the open piece.
  std::size_t segments() const { return open_ ? segments_ : 0; }

  std::string_view text() const { return {text_.get(), size_}; }
  /// Drops the text. The next may go on in the middle of a piece.
  void clear() { size_ = 0; }

 private:
  /// A number and the blank behind it.
  struct Text {
    char characters[8];
    std::uint8_t length;
  };
  static constexpr std::int64_t largest_ready = 2047;  ///< beyond it numbers are spelt one by one

  void make_room(std::size_t bytes);
  char* spell(char* to, std::int64_t value) const;
  char* number(char* to, std::int64_t value) const;
  char* operation(char* to, GridPoint point, char name) const;
  bool begins_near_piece() const;
  void write_start();

  Grid grid_;
  int decimals_;                   ///< of the numbers
  std::unique_ptr<Text[]> ready_;  ///< -largest_ready ... largest_ready
  std::unique_ptr<char[]> text_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;

  Paint paint_ = Paint::stroke;
  bool open_ = false;
  bool waits_ = false;  ///< the contour's move is not written yet
  std::size_t segments_ = 0;
  GridPoint origin_;
  GridPoint at_;
};

}  // namespace burin::output::pdf
