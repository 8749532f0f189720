#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <burin/output/fixed_point.hpp>

namespace burin::output {

/// The text of SVG path data, as short as SVG allows: relative commands, a command letter only where it changes, no
/// leading zero, and a space only where two numbers would run together ("m10 20 .5.25-1 3h.5").
///
/// Source: SVG 1.1, section 8.3.9 (grammar of path data).
class PathData {
 public:
  /// No move or line is longer than this in characters.
  static constexpr std::size_t longest_command = 48;

  /// Pre: 0 <= decimals <= 6.
  explicit PathData(int decimals);

  const Grid& grid() const { return grid_; }

  /// Where the next line starts.
  GridPoint at() const { return at_; }

  /// Starts the text of lines that will follow a move to `start`; the move itself is written later by move().
  void start(GridPoint start);

  struct Lines {
    char* end;          ///< behind the last character written
    std::size_t count;  ///< lines written; points equal to the one before them are left out
  };
  /// Writes a line to each of `points`. Pre: room for points.size() * longest_command characters; can_be_rounded.
  Lines lines(char* to, std::span<const Vec2> points);
  /// The same for one point on the grid.
  Lines line(char* to, GridPoint point);

  /// Writes "m" by `by`, and the separator that text begun by start() needs after it when its first character is
  /// `next`.
  char* move(char* to, GridPoint by, char next) const;

 private:
  /// What stands before a number, ordered by how much of the next number may follow it without a space.
  enum class Before : std::uint8_t { whole_number, pointed_number, letter };

  /// A number's text, and how it meets its neighbours.
  struct Text {
    char characters[8];
    std::uint8_t length;
    std::uint8_t begins;  ///< 0 "-", 1 ".", 2 a digit: needs a space when greater than Before
    Before leaves;
  };

  static constexpr std::int64_t largest_ready = 2047;  ///< beyond it numbers are spelt one by one

  static std::uint8_t begins(char first);
  Text ready_text(std::int64_t value) const;
  char* number(char* to, std::int64_t value, Before& before) const;
  char* one_line(char* to, std::int64_t dx, std::int64_t dy, char& command, Before& before) const;

  Grid grid_;
  std::vector<Text> ready_;  ///< -largest_ready ... largest_ready
  GridPoint at_;
  char command_ = 'l';
  Before before_ = Before::letter;
};

}  // namespace burin::output
