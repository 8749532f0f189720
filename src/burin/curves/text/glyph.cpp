#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <burin/curves/text/glyph.hpp>
#include <burin/curves/text/hershey/hershey.hpp>
#include <burin/curves/text/recipes.hpp>
#include <burin/data/svg_path.hpp>

namespace burin::curves::lettering {

namespace {

/// A face: its letters, and how strokes of ours are drawn among them.
struct Face {
  const hershey::GlyphTexts& letters;
  std::string_view borrowed;  ///< characters taken from `lender`, which draws them better
  const hershey::GlyphTexts& lender;
  double slope = 0.0;  ///< to the right, for each unit up
  bool heavy = false;  ///< strokes are two lines
  bool ornate = false;
};

Face face_of(Font font) {
  using namespace hershey;
  // Serif's points hang above the baseline; ' of the other faces is no apostrophe.
  constexpr std::string_view quotes = "'`";
  switch (font) {
    case Font::sans:
      return {rowmans, {}, rowmans};
    case Font::sans_bold:
      return {rowmand, {}, rowmand, 0.0, true};
    case Font::serif:
      return {timesr, "'`,.:;", rowmans};
    case Font::serif_bold:
      return {timesrb, quotes, rowmand, 0.0, true};
    case Font::italic:
      return {timesi, quotes, rowmans, 2.0 / 7.0};
    case Font::italic_bold:
      return {timesib, quotes, rowmand, 2.0 / 7.0, true};
    case Font::script:
      return {scripts, {}, scripts, 1.0 / 3.0, false, true};
    case Font::script_bold:
      return {scriptc, {}, scriptc, 1.0 / 3.0, false, true};
    case Font::gothic:
      return {gothiceng, quotes, rowmand, 0.0, true, true};
  }
  return {rowmans, {}, rowmans};
}

/// From the pairs of letters of James Hurt's format.
Glyph decoded(std::string_view pairs) {
  const auto number = [&](std::size_t i) { return static_cast<double>(pairs[i] - 'R'); };
  const double left = number(0);
  Glyph glyph{number(1) - left, {}};
  bool pen_is_up = true;
  for (std::size_t i = 2; i + 1 < pairs.size(); i += 2) {
    if (pairs.substr(i, 2) == " R") {
      pen_is_up = true;
      continue;
    }
    if (pen_is_up) glyph.strokes.emplace_back();
    pen_is_up = false;
    glyph.strokes.back().push_back({number(i) - left, hershey::baseline_y - number(i + 1)});
  }
  return glyph;
}

/// Pre: printable ASCII.
Glyph letter_of(const Face& face, char32_t character) {
  const auto ascii = static_cast<char>(character);
  const bool borrowed = face.borrowed.find(ascii) != std::string_view::npos;
  return decoded((borrowed ? face.lender : face.letters)[static_cast<std::size_t>(character - U' ')]);
}

/// Slopes a glyph about the middle of its capitals, so that it stays between its borders.
void shear(Glyph& glyph, double slope) {
  for (Stroke& stroke : glyph.strokes) {
    for (Vec2& p : stroke) p.x += slope * (p.y - 0.5 * units_per_cap);
  }
}

void move(Glyph& glyph, Vec2 by) {
  for (Stroke& stroke : glyph.strokes) {
    for (Vec2& p : stroke) p = p + by;
  }
}

/// The two lines of a heavy stroke: out on one side of it, back on the other.
Stroke doubled(const Stroke& stroke) {
  constexpr double half_width = 0.5;
  const std::size_t last = stroke.size() - 1;
  const bool closed = stroke.front() == stroke.back();
  const auto normal = [&](std::size_t edge) {
    const Vec2 d = stroke[edge + 1] - stroke[edge];
    return Vec2{-d.y, d.x} * (1.0 / length(d));
  };
  Stroke left;
  Stroke right;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vec2 before = normal(i > 0 ? i - 1 : closed ? last - 1 : 0);
    const Vec2 after = normal(i < last ? i : closed ? 0 : last - 1);
    const Vec2 miter = (before + after) * (1.0 / std::max(0.5, 1.0 + dot(before, after)));
    left.push_back(stroke[i] + half_width * miter);
    right.push_back(stroke[i] - half_width * miter);
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  left.push_back(left.front());
  return left;
}

/// Strokes of ours, upright. Pre: `path` is one of the recipes'.
Glyph drawn(std::string_view path, bool heavy, double scale = 1.0) {
  constexpr double tolerance = 0.04;
  Result<std::vector<data::Subpath>> subpaths = data::parse_svg_path(path, tolerance, {});
  Glyph glyph;
  for (data::Subpath& subpath : *subpaths) {
    for (Vec2& p : subpath.points) p = scale * p;
    if (subpath.closed) subpath.points.push_back(subpath.points.front());
    glyph.strokes.push_back(heavy ? doubled(subpath.points) : std::move(subpath.points));
  }
  return glyph;
}

/// How far the ink of a part stays from the borders when it is a letter of its own.
constexpr double bearing = 3.0;

/// A part on its own, upright, with its pen at x = 0.
Glyph upright(const Face& face, const Part& part) {
  constexpr double height_of_small_letters = 14.0;
  if (part.letter == 0) {
    const double height = part.small ? letter_of(face, U'x').box().high.y : height_of_small_letters;
    Glyph glyph = drawn(part.path, face.heavy, height / height_of_small_letters);
    glyph.advance = glyph.box().high.x;
    return glyph;
  }
  Glyph glyph = letter_of(face, part.letter);
  shear(glyph, -face.slope);
  for (Stroke& stroke : glyph.strokes) {
    for (Vec2& p : stroke) {
      if (part.turned) p = Vec2{glyph.advance, height_of_small_letters} - p;
      p = part.scale * p;
    }
  }
  glyph.advance *= part.scale;
  return glyph;
}

void append(Glyph& whole, Glyph&& part) {
  std::move(part.strokes.begin(), part.strokes.end(), std::back_inserter(whole.strokes));
}

Glyph composed(const Face& face, std::span<const Part> parts) {
  Glyph whole;
  Box2 ink;  // of the last letter
  for (const Part& part : parts) {
    Glyph piece = upright(face, part);
    const Box2 box = piece.box();
    Vec2 by = part.by;
    switch (part.place) {
      case Place::next: {
        const double border = part.letter == 0 ? bearing : 0.0;
        by.x += whole.advance + (part.letter == 0 ? border - box.low.x : 0.0);
        whole.advance += part.letter == 0 ? box.width() + 2.0 * border : piece.advance;
        break;
      }
      case Place::joined:
        by.x += ink.high.x - box.low.x;
        whole.advance = by.x + piece.advance + (part.letter == 0 ? bearing : 0.0);
        break;
      case Place::left:
        by.x += ink.low.x;
        break;
      case Place::centre:
        by.x += ink.center().x - (part.letter == 0 ? 0.0 : box.center().x);
        break;
    }
    move(piece, by);
    if (part.place == Place::next || part.place == Place::joined) ink = piece.box();
    append(whole, std::move(piece));
  }
  shear(whole, face.slope);
  return whole;
}

/// Takes the dots away from i or j: the strokes wholly above the small letters.
Glyph take_dots(const Face& face, Glyph& letter) {
  const double above = letter_of(face, U'x').box().high.y + 1.0;
  const auto is_dot = [&](const Stroke& stroke) {
    return std::all_of(stroke.begin(), stroke.end(), [&](Vec2 p) { return p.y > above; });
  };
  const auto dots = std::stable_partition(letter.strokes.begin(), letter.strokes.end(),
                                          [&](const Stroke& stroke) { return !is_dot(stroke); });
  Glyph taken;
  taken.strokes.assign(std::move_iterator(dots), std::move_iterator(letter.strokes.end()));
  letter.strokes.erase(dots, letter.strokes.end());
  return taken;
}

/// The mark with its own x = 0, y = 0 at the origin.
Glyph mark_strokes(const Face& face, const Mark& mark) {
  if (mark.dots == 0) return mark.path.empty() ? Glyph{} : drawn(mark.path, face.heavy);
  Glyph i = upright(face, {.letter = U'i'});
  Glyph dot = take_dots(face, i);
  const Box2 box = dot.box();
  move(dot, -Vec2{box.center().x, box.low.y});
  if (mark.dots == 1) return dot;
  Glyph dots = dot;
  const double apart = 0.5 * box.width() + 2.0;
  move(dots, {-apart, 0.0});
  move(dot, {apart, 0.0});
  append(dots, std::move(dot));
  return dots;
}

Glyph marked(const Face& face, const MarkedLetter& letter) {
  Glyph whole = upright(face, {.letter = letter.letter});
  if ((letter.letter == U'i' || letter.letter == U'j') && !letter.mark.below) take_dots(face, whole);
  Glyph mark = mark_strokes(face, letter.mark);
  // The ink that the mark sits on: descenders do not count. A mark alone sits where it would on an x.
  Box2 ink;
  for (const Stroke& stroke : whole.strokes) {
    for (const Vec2 p : stroke) ink.add(Vec2{p.x, std::max(p.y, 0.0)});
  }
  const Box2 x = upright(face, {.letter = U'x'}).box();
  if (ink.empty()) ink = {{0.5 * whole.advance, 0.0}, {0.5 * whole.advance, x.high.y}};
  const double low = letter.mark.below ? whole.box().low.y : 0.0;
  move(mark, {ink.center().x, letter.mark.below ? std::min(low, 0.0) - letter.mark.gap : ink.high.y + letter.mark.gap});
  // A mark wider than its letter does not run into the neighbours.
  constexpr double least_bearing = 1.0;
  const Box2 box = mark.box();
  const double missing = std::max({0.0, least_bearing - box.low.x, box.high.x - (whole.advance - least_bearing)});
  append(whole, std::move(mark));
  move(whole, {missing, 0.0});
  whole.advance += 2.0 * missing;
  shear(whole, face.slope);
  return whole;
}

}  // namespace

Box2 Glyph::box() const {
  Box2 box;
  for (const Stroke& stroke : strokes) {
    for (const Vec2 p : stroke) box.add(p);
  }
  return box;
}

std::size_t Glyph::point_count() const {
  std::size_t count = 0;
  for (const Stroke& stroke : strokes) count += stroke.size();
  return count;
}

std::optional<Glyph> glyph_of(Font font, char32_t character) {
  const Face face = face_of(font);
  if (const std::span<const Part> parts = recipe_of(character, face.ornate); !parts.empty()) {
    return composed(face, parts);
  }
  if (character >= U' ' && character <= U'~') return letter_of(face, character);
  if (const MarkedLetter letter = marked_letter(character); letter.letter != 0) return marked(face, letter);
  return std::nullopt;
}

}  // namespace burin::curves::lettering
