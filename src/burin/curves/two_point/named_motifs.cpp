#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/curves/two_point/vertices.hpp>

/// The motifs that go by a name. Source: reference curves A.3. The papers' misprints stand beside the motifs they
/// misprint, as data of the same kind.
namespace burin::curves::two_point {

namespace {

constexpr double third = 1.0 / 3.0;
constexpr double sqrt3 = 1.73205080756887729353;

constexpr std::array<Vec2, 9> fret_points{{{0, 0}, {0, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 0}, {4, 0}}};
constexpr std::array<Vec2, 5> printed_koch_points{{{0, 0}, {third, 0}, {0.5, -sqrt3 / 6.0}, {third, 0}, {1, 0}}};
constexpr std::array<Vec2, 9> printed_minkowski_points{
    {{0, 0}, {0.25, 0}, {0.25, -0.25}, {0.5, -0.25}, {0.5, 0}, {0.5, -0.25}, {0.75, -0.25}, {0.75, 0}, {1, 0}}};
constexpr std::array<Vec2, 3> printed_dragon_points{{{0, 0}, {third, -0.5}, {1, 0}}};

constexpr std::array<NamedMotif, 33> rows{{
    {.name = "koch",
     .summary = "Koch's curve: an equilateral bump on the middle third",
     .source = "von Koch 1904; Ding & Qi, Fig. 3",
     .turtle = "F-F++F-F",
     .angle_degrees = 60},
    {.name = "cesaro",
     .summary = "Cesaro's curve: Koch's with a steeper bump; its angle is free",
     .source = "Cesaro 1905",
     .turtle = "F-F++F-F",
     .angle_degrees = 85},
    {.name = "minkowski",
     .alias = "quad8",
     .summary = "Minkowski's sausage: a square to the right, a square to the left",
     .source = "Mandelbrot, The Fractal Geometry of Nature, 1982, chapter 6; Ding & Qi, Fig. 3",
     .turtle = "F-F+F+FF-F-F+F"},
    {.name = "quad5",
     .alias = "quadratic-koch",
     .summary = "the quadratic Koch curve: a square on the middle third",
     .source = "Mandelbrot, The Fractal Geometry of Nature, 1982, chapter 6",
     .turtle = "F-F+F+F-F"},
    {.name = "quad18",
     .summary = "Mandelbrot's quadric curve of 18 edges",
     .source = "Mandelbrot, The Fractal Geometry of Nature, 1982, chapter 6",
     .turtle = "F+FF-FF-F-F+F+FF-F-F+F+FF+FF-F"},
    {.name = "quad32",
     .summary = "Mandelbrot's quadric curve of 32 edges",
     .source = "Mandelbrot, The Fractal Geometry of Nature, 1982, chapter 6",
     .turtle = "-F+F-F-F+F+FF-F+F+FF+F-F-FF+FF-FF+F+F-FF-F-F+FF-F-F+F+F-F+"},
    {.name = "levy",
     .alias = "c-curve",
     .summary = "Levy's C curve: right angles to one side",
     .source = "Cesaro 1906; Levy 1938",
     .turtle = "F+F"},
    {.name = "dragon",
     .alias = "heighway",
     .summary = "Heighway's dragon: right angles to both sides in turn",
     .source = "Heighway, Banks & Harter 1966; Davis & Knuth 1970; Ding & Qi, Fig. 3",
     .turtle = "A+B",
     .reverse = "B"},
    {.name = "polya",
     .alias = "triangle-sweep",
     .summary = "Polya's sweep of a right triangle: sides in turn by level",
     .source = "Polya 1913",
     .turtle = "A+A",
     .flip = "A"},
    {.name = "altpaper",
     .alias = "alternate-paper",
     .summary = "paper folded alternately: fills half a square, no edge twice",
     .source = "Davis & Knuth 1970",
     .turtle = "A+B",
     .flip = "AB",
     .reverse = "B"},
    {.name = "terdragon",
     .summary = "the terdragon: a Z of three equal edges",
     .source = "Davis & Knuth 1970",
     .turtle = "F+F-F",
     .angle_degrees = 120},
    {.name = "altterdragon",
     .alias = "alternate-terdragon",
     .summary = "the alternate terdragon: its Z to one side and to the other by level",
     .source = "Davis & Knuth 1970",
     .turtle = "F+F-F",
     .angle_degrees = 120,
     .flip = "F"},
    {.name = "sierpinski",
     .alias = "arrowhead",
     .summary = "Sierpinski's arrowhead: half a hexagon, folded in and out",
     .source = "Sierpinski 1915; Mandelbrot 1982; Ding & Qi, Fig. 3",
     .turtle = "-A+B+A",
     .angle_degrees = 60,
     .flip = "A"},
    {.name = "r5dragon",
     .summary = "the dragon of five edges: an S of right angles",
     .source = "Arndt, Matters Computational, 2010",
     .turtle = "F+F+F-F-F"},
    {.name = "gosper",
     .alias = "flowsnake",
     .summary = "Gosper's flowsnake: seven edges that fill a hexagon-like island",
     .source = "Gosper 1973; Gardner 1976",
     .turtle = "A-B--B+A++AA+B-",
     .angle_degrees = 60,
     .reverse = "B"},
    {.name = "gosper-side",
     .alias = "gosper-island",
     .summary = "a side of Gosper's island: a flat Z; on a hexagon the whole coast",
     .source = "Gosper; Gardner 1976; Mandelbrot 1982",
     .turtle = "F+F-F",
     .angle_degrees = 60},
    {.name = "quartet",
     .alias = "quintet",
     .summary = "Mandelbrot's quartet: five edges that fill a spiralling plus",
     .source = "Mandelbrot, The Fractal Geometry of Nature, 1982, chapter 7",
     .turtle = "A-B+A+AB",
     .reverse = "B"},
    {.name = "dekking",
     .summary = "Dekking's curve: 25 edges that fill a square and leave none out",
     .source = "Dekking, Recurrent Sets, 1982",
     .turtle = "AA+B+B-A-A+B+BA-B-AAB+A-B-AA-B+AB+B+A-A-BB",
     .reverse = "B"},
    {.name = "pentadendrite",
     .summary = "McWorter's pentadendrite: six edges, turns of a pentagon",
     .source = "McWorter & Tazelaar, Creating Fractals, BYTE, August 1987",
     .turtle = "F+F-F--F+F+F",
     .angle_degrees = 72},
    {.name = "pentigree",
     .summary = "McWorter's pentigree: six edges in the golden ratio",
     .source = "McWorter & Tazelaar, Creating Fractals, BYTE, August 1987",
     .turtle = "+F++F----F--F++F++F-",
     .angle_degrees = 36},
    {.name = "peano",
     .summary = "Peano's curve as it is mostly drawn: through the middles of peano9's edges",
     .source = "Peano 1890",
     .turtle = "A+B-A-B-A+B+A+B-A",
     .flip = "B",
     .join = Vec2{0.5, 0.0}},
    {.name = "peano9",
     .summary = "Peano's curve along the diagonal of its square",
     .source = "Peano 1890",
     .turtle = "A+B-A-B-A+B+A+B-A",
     .flip = "B"},
    {.name = "hilbert",
     .summary = "Hilbert's curve as it is mostly drawn: through the middles of its squares",
     .source = "Hilbert 1891",
     .turtle = "+A-BB-A",
     .flip = "A",
     .join = Vec2{0.5, -0.5}},
    {.name = "hilbert4",
     .summary = "Hilbert's curve, each edge the side of its square",
     .source = "Hilbert 1891",
     .turtle = "+A-BB-A",
     .flip = "A"},
    {.name = "sierpinski-curve",
     .summary = "Sierpinski's curve: through a point of every triangle of Polya's sweep",
     .source = "Sierpinski 1912",
     .turtle = "A+A",
     .flip = "A",
     .join = Vec2{0.5, 1.0 / 6.0}},
    {.name = "serpentine",
     .summary = "Wunderlich's serpentine: Peano's curve with every other square transposed",
     .source = "Wunderlich 1973",
     .turtle = "F+F-F-F-F+F+F+F-F",
     .join = Vec2{0.5, 0.0}},
    {.name = "meander",
     .summary = "Wunderlich's meander: nine squares, each run along a side",
     .source = "Wunderlich 1973",
     .turtle = "-AA+BBB++B-AA-B",
     .flip = "A",
     .join = Vec2{0.5, 0.5}},
    {.name = "cinco",
     .summary = "the Cinco curve: 25 squares, each run along a side",
     .source = "Dennis, Inverse Space-Filling Curve Partitioning of a Global Ocean Model, 2007",
     .turtle = "AA+BBB++B-AA-BB-AA-B++B-AAA++A+BB+A++A+BB+A",
     .flip = "B",
     .join = Vec2{0.5, -0.5}},
    {.name = "fret",
     .alias = "greek-key",
     .summary = "a Greek key, an ornament of one level",
     .source = "a fret of Greek vases",
     .points = fret_points,
     .dimension_note = "the copies overlap"},
    {.name = "koch-printed",
     .summary = "Koch's curve as Ding & Qi print it: alpha_3 = 1/3 for 2/3",
     .source = "Ding & Qi, section 3, misprint",
     .points = printed_koch_points,
     .dimension_note = "the copies overlap"},
    {.name = "minkowski-printed",
     .summary = "Minkowski's curve as printed: beta_5 = beta_6 = 1/4 for -1/4",
     .source = "Ding & Qi, section 3, misprint",
     .points = printed_minkowski_points,
     .dimension_note = "the copies overlap"},
    {.name = "dragon-printed",
     .summary = "the dragon as printed: alpha_1 = 1/3 for 1/2, sign by level and edge",
     .source = "Ding & Qi, section 3, misprint",
     .points = printed_dragon_points,
     .sign = SignRule::Kind::level_edge,
     .dimension_note = "the copies overlap"},
    {.name = "dragon-printed-sign",
     .summary = "the dragon with alpha_1 = 1/2 and the printed sign: paper folded alternately",
     .source = "Ding & Qi, section 3, misprint",
     .turtle = "F+F",
     .sign = SignRule::Kind::level_edge},
}};

/// "[[0, 0], [1, 2]]"
std::string points_text(std::span<const Vec2> points) {
  std::string text;
  for (const Vec2 p : points) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", shortest_text(p.x), shortest_text(p.y));
  }
  return '[' + text + ']';
}

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
  return motif_from(row, row.angle_degrees);
}

Motif motif_from(const NamedMotif& row, double angle_degrees) {
  const TurtlePath path = walk_turtle(row.turtle, angle_degrees);
  std::optional<std::vector<Mark>> marks =
      marks_from_vertices(row.turtle.empty() ? row.points : std::span<const Vec2>(path.vertices));
  BURIN_EXPECT(marks.has_value());
  Motif motif;
  motif.by_level = {Stage{{*std::move(marks)}}};
  if (!row.flip.empty()) motif.flip = flags_of(path.letters, row.flip);
  if (!row.reverse.empty()) motif.reverse = flags_of(path.letters, row.reverse);
  motif.join = row.join;
  if (row.sign) motif.sign = SignRule{*row.sign};
  motif.text = '"' + std::string(row.name) + '"';
  return motif;
}

std::string table_text(const NamedMotif& row) {
  std::string text =
      row.turtle.empty() ? "points = " + points_text(row.points) : fmt::format("turtle = \"{}\"", row.turtle);
  if (!row.turtle.empty() && row.angle_degrees != 90.0) {
    text += fmt::format(", angle = {}", shortest_text(row.angle_degrees));
  }
  if (!row.flip.empty()) text += fmt::format(", flip = \"{}\"", row.flip);
  if (!row.reverse.empty()) text += fmt::format(", reverse = \"{}\"", row.reverse);
  if (row.join) text += fmt::format(", join = [{}, {}]", shortest_text(row.join->x), shortest_text(row.join->y));
  if (row.sign) text += ", sign = " + params::ValueType<SignRule>::text(SignRule{*row.sign});
  return "{ " + text + " }";
}

}  // namespace burin::curves::two_point
