#include <cmath>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/two_point/vertices.hpp>

namespace burin::curves::two_point {

namespace {

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

Amount constant(double value) {
  return {value, value, std::nullopt};
}

}  // namespace

bool is_turtle_step(char c) {
  return is_letter(c) || c == '+' || c == '-' || c == '|' || c == ' ';
}

TurtlePath walk_turtle(std::string_view word, double angle_degrees) {
  TurtlePath path;
  int heading = 0;
  int half_turns = 0;
  for (const char c : word) {
    BURIN_EXPECT(is_turtle_step(c));
    if (c == '+') {
      ++heading;
    } else if (c == '-') {
      --heading;
    } else if (c == '|') {
      half_turns ^= 1;
    } else if (is_letter(c)) {
      const double degrees = angle_degrees * heading + 180.0 * half_turns;
      path.vertices.push_back(path.vertices.back() + Vec2{math::cos_degrees(degrees), math::sin_degrees(degrees)});
      path.letters += c;
    }
  }
  return path;
}

std::optional<std::vector<Mark>> marks_from_vertices(std::span<const Vec2> vertices) {
  const Vec2 chord = vertices.back() - vertices.front();
  const double norm = length_squared(chord);
  if (norm == 0.0) return std::nullopt;
  std::vector<Mark> marks;
  for (std::size_t j = 1; j + 1 < vertices.size(); ++j) {
    const Vec2 p = vertices[j] - vertices.front();
    marks.push_back({constant(dot(p, chord) / norm), constant(-cross(chord, p) / norm)});
  }
  return marks;
}

std::vector<std::uint8_t> flags_of(std::string_view letters, std::string_view chosen) {
  std::vector<std::uint8_t> flags;
  for (const char c : letters) flags.push_back(chosen.find(c) == std::string_view::npos ? 0 : 1);
  return flags;
}

}  // namespace burin::curves::two_point
