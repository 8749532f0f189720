#include <algorithm>
#include <array>
#include <cstring>

#include <burin/base/check.hpp>
#include <burin/output/pdf/pieces.hpp>

namespace burin::output::pdf {

namespace {

constexpr int decimals_of_unit = 3;  ///< a micrometre
constexpr std::size_t longest_number = 24;
constexpr std::size_t longest_line = 2 * longest_number + 2;
constexpr std::size_t batch = 1024;

std::string_view operator_of(Paint paint) {
  constexpr std::array<std::string_view, 3> names{"S\nQ\n", "f\nQ\n", "f*\nQ\n"};
  return names[static_cast<std::size_t>(paint)];
}

}  // namespace

double unit_mm(int decimals) {
  return 2.0 * half_unit_mm(std::min(decimals, decimals_of_unit));
}

Pieces::Pieces(int decimals)
    : grid_(decimals),
      decimals_(std::max(0, decimals - decimals_of_unit)),
      ready_(std::make_unique<Text[]>(2 * largest_ready + 1)) {
  for (std::int64_t value = -largest_ready; value <= largest_ready; ++value) {
    Text& text = ready_[static_cast<std::size_t>(value + largest_ready)];
    text.length = static_cast<std::uint8_t>(spell(text.characters, value) - text.characters);
  }
}

void Pieces::make_room(std::size_t bytes) {
  if (size_ + bytes <= room_) return;
  const std::size_t room = std::max(size_ + bytes, 2 * room_);
  std::unique_ptr<char[]> text(new char[room]);
  std::copy_n(text_.get(), size_, text.get());
  text_ = std::move(text);
  room_ = room;
}

void Pieces::add(std::string_view operators) {
  BURIN_EXPECT(!open_);
  make_room(operators.size());
  std::copy_n(operators.data(), operators.size(), text_.get() + size_);
  size_ += operators.size();
}

char* Pieces::spell(char* to, std::int64_t value) const {
  to = spell_fixed(to, value, decimals_);
  *to++ = ' ';
  return to;
}

char* Pieces::number(char* to, std::int64_t value) const {
  if (value < -largest_ready || value > largest_ready) return spell(to, value);
  const Text& text = ready_[static_cast<std::size_t>(value + largest_ready)];
  std::memcpy(to, text.characters, sizeof text.characters);
  return to + text.length;
}

char* Pieces::operation(char* to, GridPoint point, char name) const {
  to = number(number(to, point.x - origin_.x), point.y - origin_.y);
  *to++ = name;
  *to++ = '\n';
  return to;
}

void Pieces::begin_path(Paint paint) {
  if (paint != Paint::stroke || paint != paint_) end_piece();
  paint_ = paint;
}

void Pieces::start(GridPoint at) {
  at_ = at;
  waits_ = true;
}

bool Pieces::begins_near_piece() const {
  return std::abs(at_.x - origin_.x) <= largest_ready && std::abs(at_.y - origin_.y) <= largest_ready;
}

/// Writes the move to where the contour begins, in a new piece when that is far from the open one.
void Pieces::write_start() {
  waits_ = false;
  if (paint_ == Paint::stroke && open_ && !begins_near_piece()) end_piece();
  make_room(4 * longest_line);
  char* to = text_.get() + size_;
  if (!open_) {
    constexpr std::string_view translation = "q\n1 0 0 1 ";
    to = std::copy(translation.begin(), translation.end(), to);
    origin_ = {};
    to = number(number(to, at_.x), at_.y);
    origin_ = at_;
    to = std::copy_n("cm\n", 3, to);
    open_ = true;
    segments_ = 0;
  }
  to = operation(to, at_, 'm');
  size_ = static_cast<std::size_t>(to - text_.get());
}

std::size_t Pieces::lines(std::span<const Vec2> points) {
  const Grid grid = grid_;
  std::size_t count = 0;
  while (!points.empty()) {
    if (waits_) {
      const auto moves = std::ranges::find_if(points, [&](Vec2 p) { return grid(p) != at_; });
      points = points.subspan(static_cast<std::size_t>(moves - points.begin()));
      if (points.empty()) break;
      write_start();
    }
    const auto some = points.first(std::min(points.size(), batch));
    points = points.subspan(some.size());
    make_room(some.size() * longest_line);
    char* to = text_.get() + size_;
    GridPoint at = at_;
    for (const Vec2 p : some) {
      const GridPoint next = grid(p);
      if (next == at) continue;
      at = next;
      ++count;
      to = operation(to, at, 'l');
    }
    at_ = at;
    size_ = static_cast<std::size_t>(to - text_.get());
  }
  segments_ += count;
  return count;
}

bool Pieces::line(GridPoint to) {
  if (to == at_) return false;
  if (waits_) write_start();
  make_room(longest_line);
  char* const end = operation(text_.get() + size_, to, 'l');
  size_ = static_cast<std::size_t>(end - text_.get());
  at_ = to;
  ++segments_;
  return true;
}

void Pieces::close() {
  BURIN_EXPECT(open_ && !waits_);
  make_room(2);
  std::copy_n("h\n", 2, text_.get() + size_);
  size_ += 2;
  ++segments_;
}

void Pieces::dot() {
  BURIN_EXPECT(waits_);
  write_start();
  make_room(longest_line);
  char* const end = operation(text_.get() + size_, at_, 'l');
  size_ = static_cast<std::size_t>(end - text_.get());
  ++segments_;
}

void Pieces::end_piece() {
  if (!open_) return;
  open_ = false;
  add(operator_of(paint_));
}

}  // namespace burin::output::pdf
