#include <algorithm>

#include <burin/base/random.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

std::string repeated(std::string_view piece, std::size_t times) {
  std::string text;
  text.reserve(piece.size() * times);
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

TEST(Hostile, DottedKeysAreRefusedBeforeTheyAreParsed) {
  EXPECT_EQ(complaints(repeated("a.", 100'000) + "a = 1"), "p.toml:1:130: error: a key of more than 64 parts\n");
  EXPECT_EQ(complaints("[" + repeated("\"a\" . ", 40'000) + "a]"),
            "p.toml:1:390: error: a key of more than 64 parts\n");
  EXPECT_EQ(complaints("x = 1\ny = { " + repeated("a.", 100'000) + "a = 1 }"),
            "p.toml:2:136: error: a key of more than 64 parts\n");
}

TEST(Hostile, DotsInTextAndCommentsAreNoKeys) {
  const std::string dots = repeated(".", 200);
  EXPECT_EQ(complaints_in("# " + dots + "\nabout.title = \"" + dots + "\" # " + dots + "\nabout.author = '" + dots +
                          "'\nabout.summary = \"\"\"\n" + dots + "\\\"\"" + dots + "\"\"\""),
            "");
}

TEST(Hostile, DeepBracketsAreRefused) {
  EXPECT_EQ(complaints("x = " + repeated("[", 100'000)), "p.toml:1:69: error: tables and lists more than 64 deep\n");
  EXPECT_EQ(complaints("x = " + repeated("{a=", 80'000)), "p.toml:1:197: error: tables and lists more than 64 deep\n");
  // Dots and brackets together go as deep.
  EXPECT_EQ(complaints("x = {a.a.a = " + repeated("{a.a.a = ", 40) + "1" + repeated("}", 41)),
            "p.toml:1:203: error: tables and lists more than 64 deep\n");
  EXPECT_EQ(complaints_in("[x" + repeated(".a", 60) + "]\ny = " + repeated("{a = ", 60) + "1.5" + repeated("}", 60)),
            "p.toml:2:2: error: unknown key 'x' in the preset; known: burin, seed, about, page, knobs, palette, pens, "
            "images, define, "
            "slots, layer\n");
}

TEST(Hostile, LongPresetsAreRefused) {
  const std::string most = repeated("# 34567\n", 32 * 1024);
  EXPECT_EQ(complaints(most),
            "p.toml: error: the edition is missing; begin the preset with the line: burin = 1\n"
            "p.toml: error: a preset needs at least one [[layer]]\n");
  EXPECT_EQ(complaints(most + "#"),
            "p.toml: error: the preset has 262145 bytes; at most 256 KiB are read. Put long "
            "lists of points into a CSV file\n");
}

TEST(Hostile, OnlyTextIsRead) {
  EXPECT_EQ(complaints(std::string_view("a = 1\nb\0 = 2", 12)),
            "p.toml:2:2: error: control character 0x00 in the text; remove it (is this a preset?)\n");
  EXPECT_EQ(complaints("a = '\x1B'"),
            "p.toml:1:6: error: control character 0x1B in the text; remove it (is this a "
            "preset?)\n");
  for (const char* bytes :
       {"\xFF", "\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC3", "\xF0\x9F\x98",
        "\xE2\x82"
        "a"}) {
    const std::string complaint = complaints("a = '" + std::string(bytes) + "'");
    EXPECT_EQ(complaint.substr(0, 28), "p.toml:1:6: error: byte 0x" + complaint.substr(26, 2)) << bytes;
    EXPECT_NE(complaint.find("is not UTF-8; save the preset as UTF-8"), std::string::npos) << complaint;
  }
  EXPECT_EQ(piece_of("about.title = '\u00E9\u20AC\U0001F600'").about.title, "\u00E9\u20AC\U0001F600");
}

TEST(Hostile, KnobsCannotMakeEndlessText) {
  const std::string knob = "knobs.k = { default = '" + repeated("x", 100'000) + "' }\n";
  EXPECT_NE(complaints_in(knob + "about.title = '" + repeated("$k ", 1000) + "'").find("too long a text"),
            std::string::npos);
}

TEST(Hostile, ExtremeNumbersAreReportedNotClamped) {
  EXPECT_EQ(complaints_in("seed = -9223372036854775808"),
            "p.toml:2:8: error: a seed is a whole number from 0 to 9223372036854775807\n");
  EXPECT_EQ(complaints_in("page.bleed = 1e308"), "p.toml:2:14: error: 'bleed' = 1e+308 mm is outside [0, 100] mm\n");
  EXPECT_EQ(complaints("burin = 1\n[[layer]]\ncurve = { family = 'two-point', levels = 9223372036854775807 }"),
            "p.toml:3:42: error: 'levels': 9223372036854775807 is too large\n");
  EXPECT_EQ(piece_of("page.bleed = -0.0").page.bleed.mm, 0.0);
}

TEST(Hostile, ThousandsOfProblemsAreCountedInReasonableTime) {
  std::string keys = "burin = 1\n";
  for (int i = 0; i < 20'000; ++i) keys += "k" + std::to_string(i) + " = 1\n";
  const std::string many = complaints(keys);
  EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 501);
  EXPECT_NE(many.find("p.toml: error: 19501 more problems follow these\n"), std::string::npos);
  // One unknown knob in a list of them is told once for each place, and not once more by the list's reader.
  const std::string list = complaints_in("define.x = [" + repeated("'$k', ", 30'000) + "]\nslots.a = { frame = [" +
                                         repeated("'$k', ", 4) + "] }");
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 501);
  EXPECT_NE(list.find("p.toml: error: 29504 more problems follow these\n"), std::string::npos);
}

/// Presets that differ from a right one by a few strokes of the pen: reading always ends, with a piece or with
/// problems.
TEST(Hostile, MutatedPresetsAreReadOrExplained) {
  const std::string source = R"(burin = 1
seed = 19
about = { title = "Card $levels", author = 'x' }
page = { size = "30x40cm", margin = "30mm 30mm 45mm", paper = "oat" }
[knobs]
levels = { default = 4, min = 0, max = 9, doc = "d" }
motif = { default = "koch", choices = ["koch", "bud"] }
lean = { random = [10, 40] }
[pens]
ink = { color = "black", width = "0.3mm" }
red = { color = "#f00", width = "(0.1*$levels)pt" }
[define]
bud = { points = [[0, 0], [0.3, 0], [0.5, "sqrt(3)/6"], [1, 0]] }
flake = { family = "two-point", motif = "$motif", base = "triangle", levels = "$levels" }
[slots]
top = { at = "0 0 100% 66%", grid = [2, 1], symmetry = "d6" }
[[layer]]
curve = { like = "flake", levels = 3 }
slot = "top"
pen = { by = "pr + x", at = [60], of = ["ink", "red"] }
[[layer]]
name = "own"
[layer.curve]
family = "two-point"
motif = { marks = [["1/3", 0], [0.5, 0.2]], sign = "edge" }
)";
  ASSERT_TRUE(load_text(source).ok());
  constexpr std::string_view alphabet = "\"'[]{}=.,#$%\\\n\t -+0919eaxlk_()/*\xC3\xA9\x80\0";
  constexpr std::uint64_t seed = 20260801;
  int right = 0;
  for (std::uint64_t run = 0; run < 4000; ++run) {
    std::string text = source;
    const std::uint64_t changes = 1 + random_bits(seed, run, 0) % 2;
    for (std::uint64_t change = 0; change < changes; ++change) {
      const auto draw = [&](std::uint64_t what, std::size_t count) {
        return static_cast<std::size_t>(random_bits(seed, run, change + 1, what) % count);
      };
      const std::size_t at = draw(0, text.size());
      const std::size_t length = std::min(draw(1, 12), text.size() - at);
      switch (draw(2, 5)) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, 1, alphabet[draw(3, alphabet.size())]);
          break;
        case 2:
          text[at] = alphabet[draw(3, alphabet.size())];
          break;
        case 3:
          text.insert(draw(3, text.size()), text.substr(at, length));
          break;
        default:
          text[at] = static_cast<char>(draw(3, 256));
      }
      if (text.empty()) text = "x";
    }
    const Result<Piece> piece = load_text(text);
    if (piece) {
      ++right;
      EXPECT_FALSE(piece->layers.empty()) << text;
      continue;
    }
    ASSERT_FALSE(piece.problems().empty());
    int line = 0;
    for (const Problem& problem : piece.problems()) {
      EXPECT_FALSE(problem.message.empty()) << "run " << run << '\n' << text;
      EXPECT_GE(problem.where.line, line) << "run " << run << '\n' << text;
      line = problem.where.line;
    }
  }
  // Neither all harmless nor all fatal: the mutations reach past the syntax.
  EXPECT_GT(right, 100);
  EXPECT_LT(right, 3900);
}

}  // namespace
}  // namespace burin::preset
