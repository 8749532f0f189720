#include <algorithm>
#include <array>

#include <burin/curves/two_point/motif.hpp>

/// The motifs that go by a name. Source: reference curves A.3 (Ding & Qi, Fig. 3, corrected where the paper misprints).
namespace burin::curves::two_point {

namespace {

constexpr double third = 1.0 / 3.0;
constexpr double sqrt3 = 1.73205080756887729353;
constexpr double terdragon_offset = 1.0 / (2.0 * sqrt3);

constexpr std::array<Vec2, 3> koch_marks{{{third, 0.0}, {0.5, sqrt3 / 6.0}, {2.0 * third, 0.0}}};
constexpr std::array<Vec2, 7> minkowski_marks{
    {{0.25, 0.0}, {0.25, 0.25}, {0.5, 0.25}, {0.5, 0.0}, {0.5, -0.25}, {0.75, -0.25}, {0.75, 0.0}}};
constexpr std::array<Vec2, 1> right_angle_marks{{{0.5, 0.5}}};
constexpr std::array<Vec2, 2> terdragon_marks{{{0.5, terdragon_offset}, {0.5, -terdragon_offset}}};
constexpr std::array<Vec2, 2> arrowhead_marks{{{0.25, sqrt3 / 4.0}, {0.75, sqrt3 / 4.0}}};

constexpr std::array<std::uint8_t, 2> second_reversed{0, 1};
constexpr std::array<std::uint8_t, 3> outer_flipped{1, 0, 1};

constexpr std::array<NamedMotif, 6> rows{{
    {"koch", "", "Koch's curve: an equilateral bump on the middle third", koch_marks, {}, {}},
    {"minkowski", "", "Minkowski's sausage: a square to the right, a square to the left", minkowski_marks, {}, {}},
    {"dragon",
     "heighway",
     "Heighway's dragon: right angles to both sides in turn",
     right_angle_marks,
     {},
     second_reversed},
    {"sierpinski",
     "arrowhead",
     "Sierpinski's arrowhead: half a hexagon, folded in and out",
     arrowhead_marks,
     outer_flipped,
     {}},
    {"levy", "", "Levy's C curve: right angles to one side", right_angle_marks, {}, {}},
    {"terdragon", "", "the terdragon: a Z of three equal edges", terdragon_marks, {}, {}},
}};

}  // namespace

std::span<const NamedMotif> named_motifs() {
  return rows;
}

const NamedMotif* find_motif(std::string_view name) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const NamedMotif& motif) {
    return motif.name == name || (!motif.alias.empty() && motif.alias == name);
  });
  return row == rows.end() ? nullptr : &*row;
}

Motif motif_from(const NamedMotif& row) {
  std::vector<Mark> marks;
  for (const Vec2 mark : row.marks) marks.push_back({{mark.x, mark.x}, {mark.y, mark.y}});
  Motif motif;
  motif.by_level = {Stage{{std::move(marks)}}};
  motif.flip.assign(row.flip.begin(), row.flip.end());
  motif.reverse.assign(row.reverse.begin(), row.reverse.end());
  motif.text = '"' + std::string(row.name) + '"';
  return motif;
}

}  // namespace burin::curves::two_point
