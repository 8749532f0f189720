#include <gtest/gtest.h>

#include <burin/curves/two_point/named_motifs.hpp>

#include "tool.hpp"

/// burin list motifs, burin show MOTIF, burin show NAME --motif -o FILE.
namespace burin::test {
namespace {

TEST(Motif, EveryNameIsListedAndShown) {
  const TemporaryFolder folder;
  const Finished list = burin_in(folder, {"list", "motifs"});
  EXPECT_EQ(list.code, 0);
  for (const auto& row : curves::two_point::named_motifs()) {
    EXPECT_TRUE(contains(list.out, "  " + std::string(row.name) + ' ')) << row.name;
  }
  const Finished shown = burin_in(folder, {"show", "flowsnake", "--motif"});
  EXPECT_EQ(shown.code, 0);
  for (const char* part : {"gosper: ", "source: Gosper", "dimension: 2.000000", "reverse = \"B\"",
                           " 0.357143  -0.123718", "mirrored edges: none", "far end: 2, 3, 7"}) {
    EXPECT_TRUE(contains(shown.out, part)) << part << '\n' << shown.out;
  }
}

TEST(Motif, ANameThatPresetAndMotifShareLeadsToBoth) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(burin_in(folder, {"show", "koch"}).out, "burin show koch --motif"));
  EXPECT_TRUE(contains(burin_in(folder, {"show", "koch", "--motif"}).out, "von Koch 1904"));
}

TEST(Motif, AFileTakesTheFormatOfItsSuffix) {
  const TemporaryFolder folder;
  const Finished svg = burin_in(folder, {"show", "winter-card", "--motif", "-o", "-"});
  EXPECT_EQ(svg.code, 0) << svg.err;
  EXPECT_TRUE(contains(svg.out, "inkscape:label=\"4 directions"));
  EXPECT_EQ(burin_in(folder, {"show", "gosper", "--motif", "-o", "m.dump"}).code, 0);
  EXPECT_EQ(burin_in(folder, {"show", "gosper", "--motif", "-o", "m.dump"}).out, "");
}

TEST(Motif, MistakesAreNamed) {
  const TemporaryFolder folder;
  const struct {
    std::vector<std::string> words;
    int code;
    const char* message;
  } cases[] = {
      {{"show", "koch", "--motif", "-o", "m.csv"}, 2, "csv holds a curve's own points"},
      {{"show", "koch", "--motif", "-o", "m.doc"}, 2, "doc"},
      {{"show", "koch", "-o", "m.svg"}, 2, "-o FILE needs --motif or the name of a figure"},
      {{"show", "koch", "--text", "--motif"}, 2, "do not go together"},
      {{"show", "winter-card", "--motif"}, 2, "add -o FILE.svg"},
      {{"show", "kohc", "--motif", "-o", "m.svg"}, 3, "did you mean 'koch'?"},
      {{"show", "goper"}, 3, "did you mean 'gosper'?"},
      {{"show", "koch", "--motif", "-o", "missing/m.svg"}, 5, "missing"},
  };
  for (const auto& row : cases) {
    const Finished run = burin_in(folder, row.words);
    EXPECT_EQ(run.code, row.code) << row.message << '\n' << run.err;
    EXPECT_TRUE(contains(run.err, row.message)) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace burin::test
