#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/tone_field.hpp>

namespace burin::curves::line_art {

namespace {

/// Cells of this many pen widths: fine enough for a face, coarse enough that a line fits into each several times.
constexpr double pen_widths_a_cell = 12.0;
/// Edges are counted where they lie in pieces of this many cells.
constexpr double cells_a_piece = 0.25;
constexpr double darkest = 0.95;

}  // namespace

ToneField::ToneField(const FieldFunction& tone, double pen_width)
    : tone_(tone), pen_width_(pen_width), side_(pen_widths_a_cell * pen_width) {}

ToneField::Room& ToneField::room_at(Vec2 p) {
  const Cell cell = cell_of(p, side_);
  const auto [found, is_new] = rooms_.try_emplace(cell);
  if (is_new) {
    const Vec2 centre{(cell.column + 0.5) * side_, (cell.row + 0.5) * side_};
    const double tone = tone_({.at = centre});
    const double share = tone > 0.0 ? std::min(tone, darkest) : 0.0;  // NaN: none
    found->second.whole = -math::log(1.0 - share) / pen_width_ * side_ * side_;
    found->second.left = found->second.whole;
  }
  return found->second;
}

void ToneField::draw_in(Room& room, double length) {
  room.left -= length;
  taken_.push_back({&room, length});
}

bool ToneField::take(Vec2 a, Vec2 b) {
  const std::size_t before = mark();
  const bool fits = each_piece(a, b, cells_a_piece * side_, [&](Vec2 from, Vec2 to) {
    Room& room = room_at(lerp(from, to, 0.5));
    const double piece = distance(from, to);
    // Half of a piece too much is as often half of one too little.
    if (!(room.left >= 0.5 * piece) || room.whole == 0.0) return false;
    draw_in(room, piece);
    return true;
  });
  if (!fits) give_back(before);
  return fits;
}

void ToneField::add_ends(Vec2 first, Vec2 last) {
  const double half_disc_as_length = math::pi / 8.0 * pen_width_;
  for (const Vec2 end : {first, last}) draw_in(room_at(end), half_disc_as_length);
}

void ToneField::give_back(std::size_t mark) {
  while (taken_.size() > mark) {
    taken_.back().room->left += taken_.back().length;
    taken_.pop_back();
  }
}

}  // namespace burin::curves::line_art
