#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/curves/two_point/motif.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::curves::two_point {

/// The vertices a turtle visits, and the letter that drew each edge.
struct TurtlePath {
  std::vector<Vec2> vertices{{0.0, 0.0}};
  std::string letters;
};

/// Whether a turtle knows this character: a letter, +, -, |, or a blank.
bool is_turtle_step(char c);

/// Letters draw an edge of length 1, + turns left and - right by the angle, | turns back; blanks are skipped.
/// Pre: every character is a turtle step.
TurtlePath walk_turtle(std::string_view word, double angle_degrees);

/// Marks from vertices: divided by the chord, alpha = Re, beta = -Im. Nothing when first and last coincide.
/// Pre: there is a vertex.
std::optional<std::vector<Mark>> marks_from_vertices(std::span<const Vec2> vertices);

/// One flag for each letter: 1 where it is among `chosen`.
std::vector<std::uint8_t> flags_of(std::string_view letters, std::string_view chosen);

}  // namespace burin::curves::two_point
