#include <algorithm>

#include <burin/curves/text/recipes.hpp>

namespace burin::curves::lettering {

namespace {

constexpr Part letter(char32_t letter, Vec2 by = {}, double scale = 1.0) {
  return {.letter = letter, .by = by, .scale = scale};
}
constexpr Part joined(char32_t letter, Vec2 by = {}, double scale = 1.0) {
  return {.letter = letter, .place = Place::joined, .by = by, .scale = scale};
}
constexpr Part path(std::string_view path) {
  return {.path = path};
}
constexpr Part small_path(std::string_view path) {
  return {.path = path, .small = true};
}
constexpr Part at_left(std::string_view path) {
  return {.path = path, .place = Place::left};
}
constexpr Part at_centre(std::string_view path) {
  return {.path = path, .place = Place::centre};
}
constexpr Part dot_at(double y) {
  return {.letter = U'.', .place = Place::centre, .by = {0.0, y}};
}
constexpr Part turned(char32_t letter) {
  return {.letter = letter, .turned = true};
}

/// Raised figures reach the height of capitals.
constexpr double small = 0.55;
constexpr Vec2 raised{0.0, 9.45};
constexpr Part superscript(char32_t figure) {
  return letter(figure, raised, small);
}
constexpr Part bar_of_fraction{.path = "M0 0L11 21", .place = Place::joined, .by = {-1.5, 0.0}};
constexpr Part denominator(char32_t figure) {
  return joined(figure, {-1.5, 0.0}, small);
}

constexpr std::array recipes{
    Recipe{U'-', {path("M0 7H8")}},  // Hershey's is a minus
    Recipe{U'^', {path("M0 15L4.5 21L9 15")}},
    Recipe{U'\u00A0', {letter(U' ')}},
    Recipe{U'\u00A1', {turned(U'!')}},
    Recipe{U'\u00A2', {letter(U'c'), at_centre("M0 -3V17")}},
    Recipe{U'\u00A3', {path("M13 17C12.3 20 10.5 21 8.5 21C5 21 4 18 4.5 14C5 10 6 5 2 0H13.5M1 10.5H10")}},
    Recipe{U'\u00A4',
           {path("M12 10A5 5 0 1 1 2 10A5 5 0 1 1 12 10ZM1 4L3.5 6.5M13 4L10.5 6.5M1 16L3.5 13.5M13 16L10.5 13.5")}},
    Recipe{U'\u00A5', {letter(U'Y'), at_centre("M-6 8.5H6M-6 4.5H6")}},
    Recipe{U'\u00A6', {path("M0 -7V6M0 12V25")}},
    Recipe{U'\u00A7',
           {path("M10.5 18C10 20 9 21 7 21C4.6 21 3 19.6 3 17.6C3 13.4 12 12.4 12 8C12 6.2 10.8 5 9 4.4"
                 "M3.5 -1C4 -3 5 -4 7 -4C9.4 -4 11 -2.6 11 -0.6C11 3.6 2 4.6 2 9C2 10.8 3.2 12 5 12.6")}},
    Recipe{U'\u00A9',
           {path("M21 10.5A10.5 10.5 0 1 1 0 10.5A10.5 10.5 0 1 1 21 10.5ZM14.8 13.7A5.4 5.4 0 1 1 14.8 7.3")}},
    Recipe{U'\u00AA', {letter(U'a', {0.0, 12.5}, 0.6)}},
    Recipe{U'\u00AB', {path("M5 2L0 7L5 12M11 2L6 7L11 12")}},
    Recipe{U'\u00AC', {path("M0 10H13V5")}},
    Recipe{U'\u00AE',
           {path("M21 10.5A10.5 10.5 0 1 1 0 10.5A10.5 10.5 0 1 1 21 10.5Z"
                 "M7.5 5V16H11.5A3 3 0 0 0 11.5 10H7.5M11.5 10L14.5 5")}},
    Recipe{U'\u00B0', {path("M6 18A3 3 0 1 1 0 18A3 3 0 1 1 6 18Z")}},
    Recipe{U'\u00B1', {path("M7 4.5V17.5M0.5 11H13.5M0.5 0H13.5")}},
    Recipe{U'\u00B2', {superscript(U'2')}},
    Recipe{U'\u00B3', {superscript(U'3')}},
    Recipe{
        U'\u00B5',
        {small_path("M2 14V-7M2 4C2 1.5 3.5 0 6 0C9 0 11 2 12 4.5M12 14V3C12 1 12.7 0 14 0C14.6 0 15.2 0.2 15.6 0.6")}},
    Recipe{U'\u00B6', {path("M15 21H6A5.5 5.5 0 0 1 6 10H9M9 21V-4M12.5 21V-4")}},
    Recipe{U'\u00B7', {letter(U'.', {0.0, 8.0})}},
    Recipe{U'\u00B9', {superscript(U'1')}},
    Recipe{U'\u00BA', {letter(U'o', {0.0, 12.5}, 0.6)}},
    Recipe{U'\u00BB', {path("M0 2L5 7L0 12M6 2L11 7L6 12")}},
    Recipe{U'\u00BC', {superscript(U'1'), bar_of_fraction, denominator(U'4')}},
    Recipe{U'\u00BD', {superscript(U'1'), bar_of_fraction, denominator(U'2')}},
    Recipe{U'\u00BE', {superscript(U'3'), bar_of_fraction, denominator(U'4')}},
    Recipe{U'\u00BF', {turned(U'?')}},
    Recipe{U'\u00C6', {path("M0 0L10 21M4.3 9H10"), joined(U'E')}},
    Recipe{U'\u00D0', {letter(U'D'), at_left("M-2 10.5H7")}},
    Recipe{U'\u00D7', {path("M0 3L12 15M12 3L0 15")}},
    Recipe{U'\u00D8', {letter(U'O'), at_centre("M-8.5 -1.5L8.5 22.5")}},
    Recipe{U'\u00DE', {letter(U'I'), at_centre("M0 16.5H5C12 16.5 12 5.5 5 5.5H0")}},
    Recipe{U'\u00DF',
           {path("M2 0V15C2 19 4.5 21 7.5 21C10.5 21 12.5 19.3 12.5 17C12.5 14.5 10.5 13.5 9.2 12.2"
                 "C8.2 11.2 8.4 10.3 9.4 9.6C11.6 8 14 7 14 4C14 1.6 12.2 0 9.6 0C8 0 6.8 0.5 5.8 1.4")}},
    Recipe{U'\u00E6', {letter(U'a'), joined(U'e', {-1.0, 0.0})}},
    Recipe{U'\u00F0',
           {small_path("M13 7C13 11 10.5 14 7.5 14C4 14 2 11 2 7C2 3 4 0 7.5 0C11 0 13 3 13 7C13 13 10 18 5 21"
                       "M4.5 15.5L11.5 20")}},
    Recipe{U'\u00F7', {path("M0 9H14"), dot_at(13.0), dot_at(3.0)}},
    Recipe{U'\u00F8', {letter(U'o'), Part{.path = "M-6.5 -2L6.5 16", .place = Place::centre, .small = true}}},
    Recipe{U'\u00FE',
           {small_path("M2 21V-7M2 11C3.5 13 5.5 14 8 14C11.5 14 14 11 14 7C14 3 11.5 0 8 0C5.5 0 3.5 1 2 3")}},
    Recipe{U'\u0110', {letter(U'D'), at_left("M-2 10.5H7")}},
    Recipe{U'\u0111', {letter(U'd'), at_centre("M0 17.5H8.5")}},
    Recipe{U'\u0141', {letter(U'L'), at_left("M-1.5 7L7.5 13")}},
    Recipe{U'\u0142', {letter(U'l'), at_centre("M-3.5 8.5L3.5 13")}},
    Recipe{U'\u0152', {letter(U'O'), joined(U'E', {-4.0, 0.0})}},
    Recipe{U'\u0153', {letter(U'o'), joined(U'e', {-1.0, 0.0})}},
    Recipe{U'\u2010', {path("M0 7H8")}},
    Recipe{U'\u2011', {path("M0 7H8")}},
    Recipe{U'\u2013', {path("M0 7H13")}},
    Recipe{U'\u2014', {path("M0 7H24")}},
    Recipe{U'\u2018', {letter(U'`')}},
    Recipe{U'\u2019', {letter(U'\'')}},
    Recipe{U'\u201A', {letter(U'\'', {0.0, -18.0})}},
    Recipe{U'\u201C', {letter(U'`'), joined(U'`', {3.0, 0.0})}},
    Recipe{U'\u201D', {letter(U'\''), joined(U'\'', {3.0, 0.0})}},
    Recipe{U'\u201E', {letter(U'\'', {0.0, -18.0}), joined(U'\'', {3.0, -18.0})}},
    Recipe{
        U'\u2022',
        {path("M5 7.5A2.5 2.5 0 1 1 0 7.5A2.5 2.5 0 1 1 5 7.5ZM3.7 7.5A1.2 1.2 0 1 1 1.3 7.5A1.2 1.2 0 1 1 3.7 7.5Z")}},
    Recipe{U'\u2026', {letter(U'.'), letter(U'.'), letter(U'.')}},
    Recipe{U'\u202F', {letter(U' ', {}, 0.5)}},
    Recipe{U'\u2039', {path("M5 2L0 7L5 12")}},
    Recipe{U'\u203A', {path("M0 2L5 7L0 12")}},
    Recipe{U'\u20AC',
           {path("M15 18C13.5 20 11.7 21 9.7 21C5.7 21 3.5 16.5 3.5 10.5C3.5 4.5 5.7 0 9.7 0C11.7 0 13.5 1 15 3"
                 "M0.5 12.7H12M0.5 8.3H11")}},
    Recipe{U'\u2122', {letter(U'T', {0.0, 10.5}, 0.5), letter(U'M', {0.0, 10.5}, 0.5)}},
    Recipe{U'\u2190', {path("M18 9H0M5 13L0 9L5 5")}},
    Recipe{U'\u2192', {path("M0 9H18M13 13L18 9L13 5")}},
    Recipe{U'\u2212', {path("M0 9H14")}},
};

/// For letters that have no plain stems.
constexpr std::array ornate_recipes{
    Recipe{U'\u00C6', {letter(U'A'), joined(U'E', {-3.0, 0.0})}},
    Recipe{U'\u0152', {letter(U'O'), joined(U'E', {-2.0, 0.0})}},
};

constexpr Mark no_dot{};
constexpr Mark acute{.path = "M-1.5 0L2.5 5"};
constexpr Mark grave{.path = "M1.5 0L-2.5 5"};
constexpr Mark circumflex{.path = "M-4 0L0 4.5L4 0"};
constexpr Mark caron{.path = "M-4 4.5L0 0L4 4.5"};
constexpr Mark tilde{.path = "M-5 0.5C-4.5 2.5 -3.5 3.5 -2.2 3.5C0 3.5 0 0.5 2.2 0.5C3.5 0.5 4.5 1.5 5 3.5"};
constexpr Mark diaeresis{.dots = 2};
constexpr Mark dot{.dots = 1};
constexpr Mark ring{.path = "M2.3 2.3A2.3 2.3 0 1 1 -2.3 2.3A2.3 2.3 0 1 1 2.3 2.3Z", .gap = 1.2};
constexpr Mark breve{.path = "M-4 4C-3.5 -1.2 3.5 -1.2 4 4"};
constexpr Mark macron{.path = "M-4.5 1H4.5"};
constexpr Mark double_acute{.path = "M-4 0L-1 5M1 0L4.5 5"};
constexpr Mark cedilla{
    .path = "M0 0L-0.8 -2C1.6 -2 2.6 -3 2.3 -4.4C2 -5.9 0 -6.4 -2.2 -5.8", .below = true, .gap = 0.0};
constexpr Mark ogonek{.path = "M3 0C1 -1.5 0.4 -3.5 1.2 -4.8C2 -5.8 3.5 -5.6 4.5 -4.8", .below = true, .gap = 0.0};
constexpr Mark comma_below{.path = "M0.8 0C1.2 -2 0.5 -3.5 -1 -4.5", .below = true, .gap = 2.5};

/// The characters of `marked` are those of `letters` with the mark.
struct MarkRow {
  Mark mark;
  std::u32string_view marked;
  std::u32string_view letters;
};

constexpr std::array mark_rows{
    MarkRow{grave, U"ÀÈÌÒÙàèìòùǸǹ", U"AEIOUaeiouNn"},
    MarkRow{acute, U"ÁÉÍÓÚÝáéíóúýĆćĹĺŃńŔŕŚśŹź´", U"AEIOUYaeiouyCcLlNnRrSsZz "},
    MarkRow{circumflex, U"ÂÊÎÔÛâêîôûĈĉĜĝĤĥĴĵŜŝŴŵŶŷ", U"AEIOUaeiouCcGgHhJjSsWwYy"},
    MarkRow{tilde, U"ÃÑÕãñõĨĩŨũ", U"ANOanoIiUu"},
    MarkRow{diaeresis, U"ÄËÏÖÜäëïöüÿŸ¨", U"AEIOUaeiouyY "},
    MarkRow{ring, U"ÅåŮů", U"AaUu"},
    MarkRow{caron, U"ČčĎĚěŇňŘřŠšŤŽž", U"CcDEeNnRrSsTZz"},
    MarkRow{breve, U"ĂăĔĕĞğĬĭŎŏŬŭ", U"AaEeGgIiOoUu"},
    MarkRow{macron, U"ĀāĒēĪīŌōŪū¯", U"AaEeIiOoUu "},
    MarkRow{no_dot, U"ı", U"i"},
    MarkRow{dot, U"ĊċĖėĠġİŻż", U"CcEeGgIZz"},
    MarkRow{double_acute, U"ŐőŰű", U"OoUu"},
    MarkRow{cedilla, U"ÇçŞşŢţ¸", U"CcSsTt "},
    MarkRow{ogonek, U"ĄąĘęĮįŲų", U"AaEeIiUu"},
    MarkRow{comma_below, U"ĢĶķĻļŅņŖŗȘșȚț", U"GKkLlNnRrSsTt"},
};

template <class Rows>
std::span<const Part> find_recipe(const Rows& rows, char32_t character) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Recipe& r) { return r.character == character; });
  if (row == rows.end()) return {};
  const auto end = std::find_if(row->parts.begin(), row->parts.end(), [](const Part& part) { return part.empty(); });
  return {row->parts.begin(), end};
}

}  // namespace

std::span<const Part> recipe_of(char32_t character, bool ornate) {
  const std::span<const Part> own = ornate ? find_recipe(ornate_recipes, character) : std::span<const Part>{};
  return own.empty() ? find_recipe(recipes, character) : own;
}

MarkedLetter marked_letter(char32_t character) {
  for (const MarkRow& row : mark_rows) {
    const std::size_t at = row.marked.find(character);
    if (at != std::u32string_view::npos) return {row.letters[at], row.mark};
  }
  return {};
}

}  // namespace burin::curves::lettering
