#include <cmath>
#include <set>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

Overrides turned(std::string name, std::string text) {
  Overrides overrides;
  overrides.knobs.emplace_back(std::move(name), std::move(text));
  return overrides;
}

/// The title of a piece whose title is made of knobs.
std::string title(std::string_view knobs, std::string_view title, const Overrides& overrides = {}) {
  return piece_of("about.title = '" + std::string(title) + "'\n[knobs]\n" + std::string(knobs), overrides).about.title;
}

TEST(Knob, OfEveryKindIsPutIntoText) {
  EXPECT_EQ(title("k = { default = 4 }", "a $k b"), "a 4 b");
  EXPECT_EQ(title("k = { default = -4 }", "1 - $k"), "1 - (-4)");
  EXPECT_EQ(title("k = { default = 0.25 }", "${k}x"), "0.25x");
  EXPECT_EQ(title("k = { default = -0.0 }", "<$k>"), "<0>");
  EXPECT_EQ(title("k = { default = \"koch\" }", "$k"), "koch");
  EXPECT_EQ(title("k = { default = \"oat\", kind = \"color\" }", "$k!"), "oat!");
  EXPECT_EQ(title("k = { default = \"3mm\", kind = \"length\" }", "$k!"), "3mm!");
  EXPECT_EQ(title("k = { default = true }", "$k!"), "true!");
  EXPECT_EQ(title("k = { default = \"a$b\" }", "$k$$"), "a$b$");
}

TEST(Knob, AloneKeepsItsType) {
  EXPECT_TRUE(piece_of("page.landscape = \"$k\"\n[knobs]\nk = { default = true }").page.landscape);
  EXPECT_EQ(piece_of("page.bleed = \"${k}\"\n[knobs]\nk = { default = 3 }").page.bleed.mm, 3.0);
  EXPECT_EQ(piece_of("page.bleed = \"($k*2)mm\"\n[knobs]\nk = { default = 3 }").page.bleed.mm, 6.0);
  EXPECT_EQ(complaints_in("about.title = \"$k\"\n[knobs]\nk = { default = 3 }"),
            "p.toml:2:16: error: 'title': expected a text, found a whole number\n");
}

TEST(Knob, IsTurnedFromOutside) {
  EXPECT_EQ(title("k = { default = 4, max = 9 }", "$k!", turned("k", "7")), "7!");
  EXPECT_EQ(title("k = { default = 4 }", "$k!", turned("k", "2*3")), "6!");
  EXPECT_EQ(title("k = { default = 4.0 }", "$k!", turned("k", "sqrt(4)/8")), "0.25!");
  EXPECT_EQ(title("k = { default = \"a\" }", "$k!", turned("k", "2*3 $x")), "2*3 $x!");
  EXPECT_EQ(title("k = { default = false }", "$k!", turned("k", "true")), "true!");
  EXPECT_EQ(title("k = { default = \"1mm\", kind = \"length\", max = \"1cm\" }", "$k!", turned("k", "9mm")), "9mm!");
  EXPECT_EQ(title("k = { random = [1, 2] }", "$k!", turned("k", "17.5")), "17.5!");
}

TEST(Knob, IsANumberWhenItsRangeHasFractions) {
  EXPECT_EQ(title("k = { default = 1, max = 2.5 }", "$k!", turned("k", "1.5")), "1.5!");
  EXPECT_EQ(title("k = { default = 1, choices = [1, 1.5] }", "$k!", turned("k", "1.5")), "1.5!");
}

TEST(Knob, LastTurnWins) {
  Overrides overrides = turned("k", "1");
  overrides.knobs.emplace_back("k", "2");
  EXPECT_EQ(title("k = { default = 4 }", "$k!", overrides), "2!");
}

struct KnobCase {
  std::string_view knob;
  std::string_view turned_to;  ///< empty: left alone
  std::string_view complaint;
};

void PrintTo(const KnobCase& each, std::ostream* out) {
  *out << each.knob << " -D k=" << each.turned_to;
}

class BadKnob : public ::testing::TestWithParam<KnobCase> {};

TEST_P(BadKnob, IsReported) {
  const auto& [knob, turned_to, complaint] = GetParam();
  const Overrides overrides = turned_to.empty() ? Overrides{} : turned("k", std::string(turned_to));
  // "$k" is used, but its trouble is told only once.
  EXPECT_EQ(complaints_in("[knobs]\nk = " + std::string(knob) + "\n[slots]\na = { rotate = \"$k\" }", overrides),
            std::string(complaint) + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, BadKnob,
    ::testing::Values(
        KnobCase{"{ default = 4000, max = 1000 }", "", "p.toml:3:17: error: 'k' = 4000 is outside (-inf, 1000]"},
        KnobCase{"{ default = 4, min = 0, max = 1000 }", "4000", "-D k=4000: error: 'k' = 4000 is outside [0, 1000]"},
        KnobCase{"{ default = 4 }", "4.5", "-D k=4.5: error: 'k': expected a whole number, found 4.5"},
        KnobCase{"{ default = 4 }", "abc", "-D k=abc: error: 'k': unknown name 'abc'; did you mean 'abs'?"},
        KnobCase{"{ default = 4.0 }", "1/0",
                 "-D k=1/0: error: 'k': the value of '1/0' is infinite; a finite number is expected"},
        KnobCase{"{ default = 4.0 }", "nan", "-D k=nan: error: 'k': unknown name 'nan'; did you mean 'tan'?"},
        KnobCase{"{ default = 1, choices = [1, 2] }", "3",
                 "-D k=3: error: 'k' = 3 is none of its choices; known: 1, 2"},
        KnobCase{"{ default = 3, choices = [1, 2] }", "",
                 "p.toml:3:17: error: 'k' = 3 is none of its choices; known: 1, 2"},
        KnobCase{"{ default = 1, kind = \"flg\" }", "",
                 "p.toml:3:28: error: 'kind': 'flg' is none of the choices; did you mean 'flag'?"},
        KnobCase{"{ random = [40, 10] }", "",
                 "p.toml:3:16: error: knob 'k': the low end 40 lies above the high end 10"},
        KnobCase{"{ random = [1] }", "",
                 "p.toml:3:16: error: 'random': expected a list of 2 numbers, found a list of 1"},
        KnobCase{"{ random = [1, 2], default = 1 }", "",
                 "p.toml:3:1: error: knob 'k' has both 'default' and 'random'; keep one"},
        KnobCase{"{ random = [1.5, 2], kind = \"integer\" }", "",
                 "p.toml:3:16: error: knob 'k' draws whole numbers, so both ends must be whole numbers"},
        KnobCase{"{ random = [1, 2], kind = \"flag\" }", "",
                 "p.toml:3:1: error: knob 'k' draws numbers, so its kind is number or integer"},
        KnobCase{"{ random = [1, 9], max = 5 }", "", "p.toml:3:16: error: 'k' = 9 is outside (-inf, 5]"},
        KnobCase{"{ doc = \"x\" }", "", "p.toml:3:1: error: knob 'k' needs a 'default' or 'random = [low, high]'"},
        KnobCase{"{ default = \"x\", min = 1 }", "",
                 "p.toml:3:28: error: 'min' is for numbers and lengths; knob 'k' is a text"},
        KnobCase{"{ default = 1, min = 3, max = 2 }", "", "p.toml:3:1: error: knob 'k': min 3 lies above max 2"},
        KnobCase{"{ default = 1, defualt = 2 }", "",
                 "p.toml:3:20: error: unknown key 'defualt' in knob 'k'; did you mean 'default'?"},
        KnobCase{"5", "", "p.toml:3:5: error: knob 'k' is written { default = 5 }"},
        KnobCase{"{ default = [1] }", "", "p.toml:3:17: error: 'k': expected a text, found a list"}));

TEST(Knob, IsLookedForByItsName) {
  EXPECT_EQ(complaints_in("[knobs]\nlevels = { default = 4 }", turned("levls", "3")),
            "-D levls=3: error: no knob 'levls'; did you mean 'levels'?\n");
  EXPECT_EQ(complaints_in("", turned("levels", "3")),
            "-D levels=3: error: no knob 'levels': this preset has no knobs\n");
  EXPECT_EQ(complaints_in("about.title = \"$levls\"\n[knobs]\nlevels = { default = 4 }"),
            "p.toml:2:16: error: no knob 'levls'; did you mean 'levels'?\n");
  EXPECT_EQ(complaints_in("about.title = \"5 $ \""),
            "p.toml:2:16: error: a '$' without the name of a knob in '5 $ '; write $$ for a dollar\n");
  EXPECT_EQ(complaints_in("[knobs]\na-b = { default = 1 }\nseed = { default = 2 }"),
            "p.toml:3:1: error: 'a-b' cannot name a knob; use letters, digits and _\n"
            "p.toml:4:1: error: a knob cannot be called 'seed': $seed is the seed of the preset\n");
}

TEST(RandomKnob, DependsOnSeedAndNameAlone) {
  const auto draw = [](std::uint64_t seed, std::string_view knobs) {
    Overrides overrides;
    overrides.seed = seed;
    return title(knobs, "$lean!", overrides);
  };
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::string text = draw(seed, "lean = { random = [10, 40] }");
    EXPECT_EQ(text, draw(seed, "a = { random = [0, 1] }\nlean = { random = [10, 40] }\nz = { default = 1 }"));
    const double lean = std::stod(text);
    EXPECT_TRUE(lean >= 10.0 && lean < 40.0) << text;
    seen.insert(text);
  }
  EXPECT_EQ(seen.size(), 20U);
}

TEST(RandomKnob, DrawsEveryWholeNumberOfItsRange) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Overrides overrides;
    overrides.seed = seed;
    seen.insert(title("k = { random = [-1, 1], kind = \"integer\" }", "<$k>", overrides));
  }
  EXPECT_EQ(seen, (std::set<std::string>{"<(-1)>", "<0>", "<1>"}));
}

TEST(Seed, IsPutIntoTextInFull) {
  EXPECT_EQ(piece_of("seed = 9223372036854775807\nabout.title = \"no. $seed\"").about.title, "no. 9223372036854775807");
  Overrides overrides;
  overrides.seed = 18446744073709551615U;
  const Piece piece = piece_of("seed = 3\nabout.title = \"no. ${seed}\"", overrides);
  EXPECT_EQ(piece.about.title, "no. 18446744073709551615");
  EXPECT_EQ(piece.seed, 18446744073709551615U);
  EXPECT_EQ(complaints_in("seed = -1"), "p.toml:2:8: error: a seed is a whole number from 0 to 9223372036854775807\n");
  EXPECT_EQ(complaints_in("seed = \"x\""),
            "p.toml:2:9: error: a seed is a whole number from 0 to 9223372036854775807\n");
}

TEST(Summary, TellsTheKnobs) {
  const Result<Summary> summary = summarise({"p.toml", R"(burin = 1
about = { title = "T $n", summary = "S" }
layer = "not read"
[knobs]
n = { default = 4, min = 0, max = 9, doc = "levels" }
x = { default = 1.5, min = 0 }
m = { default = "a", choices = ["a", "b"] }
c = { default = "oat", kind = "color" }
f = { default = true }
l = { default = "1mm", kind = "length", max = "1cm" }
r = { random = [10, 40] }
)"});
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->about.title, "T 4");
  std::string table;
  for (const KnobInfo& knob : summary->knobs) {
    table += knob.name + "; " + knob.kind + "; " + knob.default_text + "; " + knob.range + "; " + knob.doc + '\n';
  }
  EXPECT_EQ(table,
            "n; whole number; 4; [0, 9]; levels\n"
            "x; number; 1.5; [0, inf); \n"
            "m; text; a; a | b; \n"
            "c; color; oat; ; \n"
            "f; true or false; true; ; \n"
            "l; length; 1mm; (-inf, 1cm]; \n"
            "r; random; drawn from the seed; [10, 40); \n");
}

}  // namespace
}  // namespace burin::preset
