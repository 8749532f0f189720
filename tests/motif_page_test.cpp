#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/burin.hpp>
#include <burin/curves/two_point/dimension.hpp>
#include <burin/curves/two_point/motif_figure.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

#include "support/blessed_page.hpp"

/// docs/motifs.md and its pictures are written from the table of named motifs and held to it here.
namespace burin {
namespace {

using namespace curves::two_point;

constexpr Page page{180.0, 74.0, 0.0, {255, 255, 255}};
constexpr Box2 figure_area{{6.0, 6.0}, {82.0, 68.0}};
constexpr Box2 curve_area{{98.0, 6.0}, {174.0, 68.0}};

/// The level whose curve is shown: the finest of at most 1100 edges; a fret stays an ornament.
int shown_level(const NamedMotif& row) {
  if (row.name == "fret") return 1;
  const double edges = static_cast<double>(motif_from(row).by_level.front().child_count());
  int level = 1;
  while (std::pow(edges, level + 1) <= 1100) ++level;
  return level;
}

/// The motif on the left, a level of its curve on the right.
std::string picture(const NamedMotif& row) {
  curves::TwoPointParams params;
  params.motif = motif_from(row);
  params.levels = shown_level(row);
  Recorder recorder;
  EXPECT_EQ(curves::find_family("two-point")->draw(params, {}, recorder), Flow::go);
  const Recording curve = recorder.take();
  const Box2 box = curve.bounds();
  const double scale = std::min(curve_area.width() / box.width(), curve_area.height() / std::max(box.height(), 1e-9));
  const Affine2 page_from_model =
      translation(curve_area.center()) * scaling(scale, -scale) * translation(-1.0 * box.center());

  Sheet sheet = motif_sheet(page);
  sheet.made_by.title = "Motif " + std::string(row.name);
  sheet.pens.push_back({"curve", {25, 25, 25}, 0.3});
  sheet.layers.push_back({.name = "curve", .pen = sheet.pens.size() - 1});
  return test::page_svg(sheet, [&](PathSink& sink) {
    EXPECT_EQ(draw_motif_figures(*motif_figures(params.motif, std::nullopt, 0), figure_area, sink), Flow::go);
    Painted painted(sink, static_cast<LayerId>(sheet.layers.size() - 1), Paint::stroke);
    Mapped mapped(painted, page_from_model);
    EXPECT_EQ(curves::find_family("two-point")->draw(params, {}, mapped), Flow::go);
  });
}

std::string section(const NamedMotif& row) {
  std::string text = fmt::format("\n## {}\n\n{}.", row.name, row.summary);
  if (!row.alias.empty()) text += fmt::format(" Also called `{}`.", row.alias);
  text += fmt::format("\n\n![{0}: the motif, and level {1} of its curve](images/motifs/{0}.svg)\n\n", row.name,
                      shown_level(row));
  text += fmt::format("Source: {}. ", row.source);
  if (const std::optional<double> dimension = similarity_dimension(motif_from(row))) {
    text += fmt::format("Dimension {:.6f}", *dimension);
    text += row.dimension_note.empty() ? "." : fmt::format(", by its ratios only, since {}.", row.dimension_note);
  }
  return text + fmt::format("\n\n```toml\nmotif = \"{}\"\nmotif = {}\n```\n", row.name, table_text(row));
}

std::string whole_page() {
  std::string text =
      "# The named motifs\n\n"
      "<!-- Written from the code: BURIN_BLESS=1 with ctest -R MotifPage writes this page and its pictures anew. "
      "-->\n\n"
      "A curve takes a motif by its name, `motif = \"koch\"`, or by a table. Both lines under a picture mean the same. "
      "A\n"
      "table may also start from a name and change what stands beside it:\n\n"
      "```toml\nmotif = { name = \"cesaro\", angle = 70 }\nmotif = { name = \"dragon\", reverse = [1, 0] }\n"
      "motif = { name = \"koch\", sign = \"random\", decay = 0.9 }\n```\n\n"
      "On the left of a picture is the motif: it replaces the dashed edge. A half arrow on an edge points the way in\n"
      "which that edge is built at the next level, and its barb lies on its right, or on its left where the edge is\n"
      "mirrored: each is a copy of the whole figure, laid with the hollow half arrow on it. On the right is a level "
      "of\n"
      "the curve. `burin show gosper --motif -o motif.svg` draws such a figure, of presets too.\n\n"
      "The dimension D solves sum r^D = 1 over the lengths r of the edges; it is the dimension of the limit curve "
      "unless\n"
      "its copies overlap. Names that end in `-printed` are the misprints of the papers ([the ledger](papers.md)).\n";
  for (const NamedMotif& row : named_motifs()) text += section(row);
  return text;
}

TEST(MotifPage, IsWrittenFromTheTable) {
  test::hold_file(test::docs_folder() / "motifs.md", whole_page());
}

TEST(MotifPage, ItsPicturesAreWhatTheTableDraws) {
  std::vector<test::PagePicture> pictures;
  for (const NamedMotif& row : named_motifs()) pictures.push_back({std::string(row.name), picture(row)});
  test::hold_pictures("motifs", pictures);
}

/// The canonical dump of a one-layer preset with this motif.
std::string dump_with(const std::string& motif) {
  const Result<preset::Plan> plan = load(
      {"motif.toml", "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", levels = 2, motif = " + motif + " }\n"});
  if (!plan) return problems_text(plan.problems());
  StringSink bytes;
  return write(*plan, "dump", bytes).ok() ? bytes.take() : "not written";
}

TEST(MotifPage, ATableIsItsName) {
  for (const NamedMotif& row : named_motifs()) {
    const std::string named = dump_with('"' + std::string(row.name) + '"');
    EXPECT_EQ(named, dump_with(table_text(row))) << row.name;
    EXPECT_NE(named, "not written");
  }
  EXPECT_NE(dump_with("\"koch\""), dump_with("\"levy\""));
}

}  // namespace
}  // namespace burin
