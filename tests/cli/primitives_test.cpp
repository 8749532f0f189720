#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <burin/primitives/library.hpp>

#include "tool.hpp"

/// burin list primitives, burin show FIGURE, burin primitives --sheet FILE, and figures of the user's own.
namespace burin::test {
namespace {

constexpr const char* own_figure =
    "<svg xmlns='http://www.w3.org/2000/svg'><title>My own</title><path d='M0 0h9' stroke='red'/></svg>";

/// A home with the figure `mine`.
ToolSetup with_own_figure(const TemporaryFolder& folder, const std::string& svg = own_figure) {
  const std::filesystem::path figures = folder.path() / "data/burin/primitives";
  std::filesystem::create_directories(figures);
  std::ofstream(figures / "mine.svg") << svg;
  ToolSetup setup;
  setup.environment.emplace_back("XDG_DATA_HOME", (folder.path() / "data").string());
  return setup;
}

TEST(Primitives, EveryFigureIsListedAndShown) {
  const TemporaryFolder folder;
  const Finished list = burin_in(folder, {"list", "primitives"});
  EXPECT_EQ(list.code, 0);
  for (const primitives::ShippedFigure& figure : primitives::shipped_figures()) {
    EXPECT_TRUE(contains(list.out, "  " + std::string(figure.name) + ' ')) << figure.name;
  }
  const Finished shown = burin_in(folder, {"show", "leaf"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  for (const char* part : {"leaf: Leaf\n", "family: leaves\n", "licence: CC0-1.0\n", "closed line", "1 high"}) {
    EXPECT_TRUE(contains(shown.out, part)) << part << '\n' << shown.out;
  }
}

TEST(Primitives, NoNameIsTakenTwice) {
  const TemporaryFolder folder;
  for (const primitives::ShippedFigure& figure : primitives::shipped_figures()) {
    const Finished shown = burin_in(folder, {"show", std::string(figure.name)});
    EXPECT_TRUE(contains(shown.out, "licence: ")) << figure.name << " is a preset, family, table or motif, too";
  }
}

TEST(Primitives, TheUsersOwnAreFound) {
  const TemporaryFolder folder;
  const ToolSetup setup = with_own_figure(folder);
  EXPECT_TRUE(contains(burin_in(folder, {"list", "primitives"}, setup).out, "yours: My own"));
  EXPECT_TRUE(contains(burin_in(folder, {"show", "mine"}, setup).out, "mine: My own"));
  EXPECT_EQ(burin_in(folder, {"primitives", "mine", "--sheet", "mine.svg"}, setup).code, 0);
  std::ofstream(folder.file("other.svg")) << own_figure;
  EXPECT_TRUE(contains(burin_in(folder, {"show", "other.svg", "--primitive"}, setup).out, "other: My own"));
}

TEST(Primitives, AFileTakesTheFormatOfItsSuffix) {
  const TemporaryFolder folder;
  const Finished svg = burin_in(folder, {"show", "leaf", "-o", "-"});
  EXPECT_EQ(svg.code, 0) << svg.err;
  EXPECT_TRUE(contains(svg.out, "inkscape:label=\"2 figure"));
  const Finished sheet =
      burin_in(folder, {"primitives", "insects", "star", "--sheet", "-", "--page", "a5", "--landscape"});
  EXPECT_EQ(sheet.code, 0) << sheet.err;
  EXPECT_TRUE(contains(sheet.out, "width=\"210mm\" height=\"148mm\""));
  EXPECT_TRUE(contains(sheet.out, "inkscape:label=\"3 letters"));
  EXPECT_FALSE(contains(burin_in(folder, {"primitives", "--no-labels", "--sheet", "-"}).out, "<path d=\"\""));
}

TEST(Primitives, MistakesAreNamed) {
  const TemporaryFolder folder;
  const ToolSetup setup = with_own_figure(folder, "<svg>\n<text>x</text></svg>");
  const struct {
    std::vector<std::string> words;
    int code;
    const char* message;
  } cases[] = {
      {{"primitives"}, 2, "--sheet FILE.pdf"},
      {{"primitives", "leav", "--sheet", "x.svg"}, 3, "did you mean 'leaf'?"},
      {{"primitives", "leaf", "--sheet", "x.csv"}, 2, "csv holds a curve's own points"},
      {{"primitives", "leaf", "--sheet", "x.svg", "--page", "a99"}, 2, "a99"},
      {{"primitives", "leaf", "--sheet", "x.svg", "--page", "20x20mm"}, 2, "no room"},
      {{"primitives", "gone.svg", "--sheet", "x.svg"}, 3, "gone.svg"},
      {{"show", "mine"}, 3, "mine.svg:2:2: error: <text>: text is not drawn"},
      {{"show", "leaf", "--motif"}, 2, "no motif is called 'leaf'"},
      {{"show", "leaf", "--primitive", "--text"}, 2, "do not go together"},
      {{"show", "leafs"}, 3, "did you mean 'leaf'?"},
  };
  for (const auto& row : cases) {
    const Finished run = burin_in(folder, row.words, setup);
    EXPECT_EQ(run.code, row.code) << row.message << '\n' << run.err;
    EXPECT_TRUE(contains(run.err, row.message)) << run.err;
  }
}

TEST(Primitives, APresetDrawsAnSvgBesideIt) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("mine.svg")) << own_figure;
  std::ofstream(folder.file("p.toml")) << "burin = 1\n[[layer]]\nsvg = \"mine.svg\"\n[[layer]]\nshape = \"disc\"\n";
  const Finished run = burin_in(folder, {"draw", "p.toml", "-o", "p.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
}

}  // namespace
}  // namespace burin::test
