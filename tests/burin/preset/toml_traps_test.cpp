#include "preset_text.hpp"

namespace burin::preset {
namespace {

struct TrapCase {
  std::string_view text;
  std::string_view complaint;
};

void PrintTo(const TrapCase& trap, std::ostream* out) {
  *out << trap.text;
}

class TomlTrap : public ::testing::TestWithParam<TrapCase> {};

TEST_P(TomlTrap, IsExplained) {
  EXPECT_EQ(complaints(GetParam().text), "p.toml:" + std::string(GetParam().complaint) + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Usual, TomlTrap,
    ::testing::Values(
        TrapCase{"page = { size = \"a4\",\n  margin = 3 }",
                 "1:22: error: a line break inside { }; keep the braces on one line, or write a [table] of its own"},
        TrapCase{"page = { size = \"a4\" # c\n}",
                 "1:22: error: a line break inside { }; keep the braces on one line, or write a [table] of its own"},
        TrapCase{"page = { size = \"a4\", }", "1:23: error: a comma before the closing '}'; remove it"},
        TrapCase{"page = { size = \"a4\" margin = 3 }", "1:22: error: a ',' is missing between two keys in { }"},
        TrapCase{"page = { size = \"a4\"", "1:21: error: a '{' is not closed; add '}'"},
        TrapCase{"page = { size = 1 }}", "1:20: error: a '}' too many"},
        TrapCase{"paper = oat", "1:9: error: text needs quotes: \"oat\""},
        TrapCase{"paper = tomato", "1:9: error: text needs quotes: \"tomato\""},
        TrapCase{"page = { paper = oat, size = 1 }", "1:18: error: text needs quotes: \"oat\""},
        TrapCase{"gap = 30mm", "1:7: error: text needs quotes: \"30mm\""},
        TrapCase{"at = [1, 30mm]", "1:10: error: text needs quotes: \"30mm\""},
        TrapCase{"x = sqrt(3)/6  # c", "1:5: error: text needs quotes: \"sqrt(3)/6\""},
        TrapCase{"x = max(1, 2)", "1:5: error: text needs quotes: \"max(1, 2)\""},
        TrapCase{"x = 1/3", "1:5: error: text needs quotes: \"1/3\""},
        TrapCase{"x = $k", "1:5: error: text needs quotes: \"$k\""},
        TrapCase{"flag = True", "1:8: error: 'True' is written true"},
        TrapCase{"x = .5", "1:5: error: '.5' is written 0.5"}, TrapCase{"x = -.5", "1:5: error: '-.5' is written -0.5"},
        TrapCase{"x = 2.", "1:5: error: '2.' is written 2.0"}, TrapCase{"x = 007", "1:5: error: '007' is written 7"},
        TrapCase{"x = 99999999999999999999", "1:5: error: the number 99999999999999999999 is too large"},
        TrapCase{"x = 1e999", "1:5: error: the number 1e999 is too large"},
        TrapCase{"x = \u201Coat\u201D", "1:5: error: these are typographic quotes; use straight ones: \"...\""},
        TrapCase{"color = #fff", "1:9: error: # begins a comment; put a colour in quotes: \"#fff\""},
        TrapCase{"seed = 1\nseed = 2", "2:1: error: 'seed' is given twice; keep one of them"},
        TrapCase{"a = { b = 1, b = 2 }", "1:14: error: 'b' is given twice; keep one of them"},
        TrapCase{"[page]\nsize = 1\n[pens]\n[page]",
                 "4:1: error: [page] is written twice; put all its keys in one place"},
        TrapCase{"[layer]\na = 1\n[layer]\nb = 2",
                 "3:1: error: each layer begins with [[layer]], in two pairs of brackets"},
        TrapCase{"[layer]\na = 1\n[[layer]]\nb = 2",
                 "3:1: error: each layer begins with [[layer]], in two pairs of brackets"},
        TrapCase{"seed =", "1:7: error: a value is missing after '='"},
        TrapCase{"seed =\nx = 1", "1:7: error: a value is missing after '='"},
        TrapCase{"seed", "1:1: error: 'seed' has no value; write 'seed = ...'"},
        TrapCase{"  seed\nx = 1", "1:3: error: 'seed' has no value; write 'seed = ...'"},
        TrapCase{"seed 4", "1:6: error: '=' is missing between key and value"},
        TrapCase{"seed: 4", "1:5: error: write '=' between key and value, not ':'"},
        TrapCase{"seed = 1,\nx = 2", "1:9: error: no comma is needed between keys; each begins a line of its own"},
        TrapCase{"seed = 1 x = 2",
                 "1:10: error: something follows the value; text with blanks needs quotes, and the "
                 "next key a line of its own"},
        TrapCase{"a = \"oat\nb = 1", "1:9: error: the quotes are not closed on this line"},
        TrapCase{"a = 'oat", "1:9: error: the quotes are not closed on this line"},
        TrapCase{"a = \"\\d\"", "1:7: error: unknown escape; write \\\\ for a backslash, or use single quotes: '...'"},
        TrapCase{"a = [1, 2", "1:10: error: a '[' is not closed; add ']'"},
        TrapCase{"a = [1 2]", "1:8: error: a ',' or ']' is missing before this"},
        TrapCase{"a = [1,,2]", "1:8: error: a value is missing before this comma"},
        TrapCase{"[page\nsize = 1", "1:6: error: the table's name is not closed; add ']'"},
        TrapCase{"[[layer]\nx = 1", "1:9: error: the table's name is not closed; add ']]'"},
        TrapCase{"[]", "1:2: error: a table needs a name: [page]"},
        TrapCase{"= 3", "1:1: error: expected a key here: letters, digits, _ and -; others need quotes"},
        // Columns count bytes, also behind characters of several.
        TrapCase{"a = \"\u00E9\u00E9\", b",
                 "1:11: error: no comma is needed between keys; each begins a line of its own"}));

TEST(Toml, RefusesDatesAndNumbersThatAreNone) {
  EXPECT_EQ(complaints_in("about = { title = 2020-01-01, author = nan }\npage = { bleed = -inf }"),
            "p.toml:2:19: error: a date cannot be used here; put it in quotes if it is meant as text\n"
            "p.toml:2:40: error: 'nan' cannot be drawn; write a finite number\n"
            "p.toml:3:18: error: 'inf' cannot be drawn; write a finite number\n");
}

TEST(Toml, ASingleLayerInSingleBracketsIsExplained) {
  EXPECT_EQ(complaints("burin = 1\n[layer]\ncurve = \"x\"\n"),
            "p.toml:2:1: error: each layer begins with [[layer]], in two pairs of brackets\n");
}

TEST(Toml, TextsBeginInsideTheirQuotes) {
  EXPECT_EQ(complaints_in("page = { bleed = \"1 + bad\" }"),
            "p.toml:2:19: error: 'bleed': expected a length such as 15mm, 1.5cm, 0.5in or 2pt, found '1 + bad'\n");
  EXPECT_EQ(complaints_in("page = { paper = '''oatt''' }"),
            "p.toml:2:21: error: 'paper': 'oatt' is no color; did you "
            "mean 'oat'?\n");
  EXPECT_EQ(complaints_in("page.paper = \"\"\"\noatt\"\"\""),
            "p.toml:3:1: error: 'paper': 'oatt' is no color; did you "
            "mean 'oat'?\n");
}

}  // namespace
}  // namespace burin::preset
