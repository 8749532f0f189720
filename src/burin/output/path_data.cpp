#include <cstring>

#include <burin/output/path_data.hpp>

namespace burin::output {

PathData::PathData(int decimals) : grid_(decimals) {
  ready_.reserve(2 * largest_ready + 1);
  for (std::int64_t value = -largest_ready; value <= largest_ready; ++value) ready_.push_back(ready_text(value));
}

std::uint8_t PathData::begins(char first) {
  if (first == '.') return 1;
  return first >= '0' && first <= '9' ? 2 : 0;
}

PathData::Text PathData::ready_text(std::int64_t value) const {
  Text text{};
  const char* const end = spell_fixed(text.characters, value, grid_.decimals());
  text.length = static_cast<std::uint8_t>(end - text.characters);
  text.begins = begins(text.characters[0]);
  text.leaves = std::memchr(text.characters, '.', text.length) ? Before::pointed_number : Before::whole_number;
  return text;
}

char* PathData::number(char* to, std::int64_t value, Before& before) const {
  char text[24];
  const auto length = static_cast<std::size_t>(spell_fixed(text, value, grid_.decimals()) - text);
  if (begins(text[0]) > static_cast<std::uint8_t>(before)) *to++ = ' ';
  std::memcpy(to, text, length);
  before = std::memchr(text, '.', length) ? Before::pointed_number : Before::whole_number;
  return to + length;
}

void PathData::start(GridPoint start) {
  at_ = start;
  command_ = 'l';  // what a move is followed by may leave out its letter
  before_ = Before::letter;
}

char* PathData::move(char* to, GridPoint by, char next) const {
  Before before = Before::letter;
  *to++ = 'm';
  to = number(to, by.x, before);
  to = number(to, by.y, before);
  if (begins(next) > static_cast<std::uint8_t>(before)) *to++ = ' ';
  return to;
}

/// Pre: (dx, dy) is not (0, 0). A level or upright line is never shorter as "l" than as "h" or "v".
char* PathData::one_line(char* to, std::int64_t dx, std::int64_t dy, char& command, Before& before) const {
  const char wanted = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
  if (wanted != command) {
    *to++ = wanted;
    command = wanted;
    before = Before::letter;
  }
  if (wanted != 'v') to = number(to, dx, before);
  if (wanted != 'h') to = number(to, dy, before);
  return to;
}

PathData::Lines PathData::line(char* to, GridPoint point) {
  const std::int64_t dx = point.x - at_.x;
  const std::int64_t dy = point.y - at_.y;
  at_ = point;
  if (dx == 0 && dy == 0) return {to, 0};
  return {one_line(to, dx, dy, command_, before_), 1};
}

PathData::Lines PathData::lines(char* to, std::span<const Vec2> points) {
  const Grid grid = grid_;
  const Text* const ready = ready_.data() + largest_ready;
  const auto is_ready = [](std::int64_t value) {
    return static_cast<std::uint64_t>(value + largest_ready) <= 2 * static_cast<std::uint64_t>(largest_ready);
  };
  std::size_t count = 0;
  GridPoint at = at_;  // in locals: a write through a char* might change any member
  char command = command_;
  Before before = before_;
  for (const Vec2 p : points) {
    const GridPoint point = grid(p);
    const std::int64_t dx = point.x - at.x;
    const std::int64_t dy = point.y - at.y;
    at = point;
    if ((dx | dy) == 0) continue;
    ++count;
    if (!is_ready(dx) || !is_ready(dy)) {
      to = one_line(to, dx, dy, command, before);
      continue;
    }
    // one_line() without its branches, which the processor would guess wrong along a curve.
    const bool writes_x = dx != 0;
    const bool writes_y = dy != 0;
    const char wanted = writes_x ? (writes_y ? 'l' : 'h') : 'v';
    const bool changes = wanted != command;
    *to = wanted;
    to += changes;
    command = wanted;
    before = changes ? Before::letter : before;
    const auto put = [&](const Text& text, bool writes) {
      *to = ' ';
      to += writes && text.begins > static_cast<std::uint8_t>(before);
      std::memcpy(to, text.characters, sizeof text.characters);
      to += writes ? text.length : 0;
      before = writes ? text.leaves : before;
    };
    put(ready[dx], writes_x);
    put(ready[dy], writes_y);
  }
  at_ = at;
  command_ = command;
  before_ = before;
  return {to, count};
}

}  // namespace burin::output
