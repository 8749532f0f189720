#include <random>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>
#include <cli/cell_grid.hpp>
#include <cli/contact_sheet.hpp>
#include <cli/draw_run.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using cli::CellGrid;
using cli::ContactSheet;
using cli::GridSpec;
using cli::SheetCell;
using cli::SheetStyle;
using Names = std::vector<std::string>;

/// A square of 100 mm in the middle of a page of 120 x 160 mm, in two layers of two pens.
constexpr const char* square_text =
    "burin = 1\n"
    "about = { title = \"Squares\" }\n"
    "page = { size = \"120x160mm\", margin = \"10mm\", paper = \"oat\" }\n"
    "[knobs]\n"
    "weight = { default = \"1mm\", kind = \"length\" }\n"
    "[pens]\n"
    "ink = { color = \"black\", width = \"$weight\" }\n"
    "red = { color = \"red\", width = \"2mm\" }\n"
    "[[layer]]\n"
    "name = \"square\"\n"
    "curve = { family = \"two-point\", motif = \"koch\", base = \"square\", levels = 0 }\n"
    "[[layer]]\n"
    "name = \"line\"\n"
    "pen = \"red\"\n"
    "dashes = [\"4mm\", \"2mm\"]\n"
    "curve = { family = \"two-point\", motif = \"koch\", levels = 1 }\n";

preset::Plan plan_of(const std::string& text) {
  return cli::make_ready({{"t.toml", text}, "t", "t.toml", ""}, {}, {})->plan;
}

SheetCell square_cell(const std::string& from = "", const std::string& to = "") {
  std::string text = square_text;
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return {plan_of(text), "caption", "label"};
}

TEST(CellGrid, TakesTheColumnsThatShowMost) {
  const Box2 a4{{10.0, 10.0}, {200.0, 287.0}};
  const auto columns = [&](std::size_t count, Vec2 item) {
    return cli::make_grid({.count = count, .item_mm = item, .area = a4}).columns;
  };
  EXPECT_EQ(columns(1, {100.0, 100.0}), 1U);
  EXPECT_EQ(columns(25, {210.0, 297.0}), 5U);
  EXPECT_EQ(columns(12, {297.0, 210.0}), 3U);
  EXPECT_EQ(columns(6, {1000.0, 10.0}), 1U);
  EXPECT_EQ(columns(6, {10.0, 1000.0}), 6U);
}

TEST(CellGrid, CellsLieInTheAreaAndApart) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> length(10.0, 500.0);
  for (int round = 0; round < 300; ++round) {
    GridSpec spec{.count = 1 + random() % 60,
                  .item_mm = {length(random), length(random)},
                  .area = {{5.0, 7.0}, {5.0 + 3.0 * length(random), 7.0 + 3.0 * length(random)}},
                  .gap_mm = length(random) / 200.0,
                  .caption_mm = length(random) / 300.0};
    if (round % 3 == 0) spec.columns = 1 + random() % 10;
    const CellGrid grid = cli::make_grid(spec);
    if (grid.scale == 0.0) continue;
    EXPECT_GE(grid.columns * grid.rows, spec.count);
    EXPECT_LT(grid.columns * (grid.rows - 1), spec.count);
    const Box2 room = spec.area.grown(1e-9);
    for (std::size_t i = 0; i < spec.count; ++i) {
      const Vec2 corner = grid.corner(i);
      EXPECT_TRUE(room.contains(corner));
      EXPECT_TRUE(room.contains(
          {corner.x + grid.scale * spec.item_mm.x, corner.y + grid.scale * spec.item_mm.y + spec.caption_mm}));
    }
    EXPECT_NEAR(grid.step.x - grid.scale * spec.item_mm.x, spec.gap_mm, 1e-9);
    EXPECT_EQ(grid.columns, spec.columns.value_or(grid.columns));
  }
}

TEST(CellGrid, WithoutRoomTheScaleIsZero) {
  EXPECT_EQ(cli::make_grid({.count = 100, .area = {{0.0, 0.0}, {50.0, 50.0}}, .gap_mm = 60.0}).scale, 0.0);
  EXPECT_EQ(cli::make_grid({.count = 2, .area = {{10.0, 0.0}, {5.0, 50.0}}}).scale, 0.0);
  EXPECT_EQ(cli::make_grid({.count = 2, .area = {{0.0, 0.0}, {50.0, 50.0}}, .caption_mm = 60.0}).scale, 0.0);
}

TEST(ContactSheet, SameLayersAreOneAndPensAreScaled) {
  SheetStyle style;
  style.columns = 2;
  const Result<ContactSheet> sheet = ContactSheet::make({square_cell(), square_cell(), square_cell()}, style);
  ASSERT_TRUE(sheet);
  const Sheet& made = sheet->sheet();
  ASSERT_EQ(made.layers.size(), 4U);
  EXPECT_EQ(made.layers[0].name, "square");
  EXPECT_EQ(made.layers[1].name, "line");
  EXPECT_EQ(made.layers[2].name, "frames");
  EXPECT_EQ(made.layers[3].name, "letters");
  ASSERT_EQ(made.pens.size(), 4U);
  const double scale = sheet->grid().scale;
  EXPECT_EQ(made.pens[0].width_mm, 1.0 * scale);
  EXPECT_EQ(made.pens[1].width_mm, 2.0 * scale);
  EXPECT_EQ(made.layers[1].dashes_mm, (std::vector<double>{4.0 * scale, 2.0 * scale}));
}

TEST(ContactSheet, EveryCellHasItsPieceInItsPlace) {
  SheetStyle style;
  style.columns = 2;
  const Result<ContactSheet> sheet = ContactSheet::make({square_cell(), square_cell(), square_cell()}, style);
  ASSERT_TRUE(sheet);
  Recorder recorder;
  Checked checked(recorder);
  preset::RunOptions only_squares;
  only_squares.wanted = [](const SheetLayer& layer) { return layer.name == "square"; };
  ASSERT_EQ(sheet->run(checked, only_squares), Flow::go);
  const Recording& drawn = recorder.recording();
  ASSERT_EQ(drawn.paths().size(), 3U);
  Recorder single;
  ASSERT_EQ(square_cell().plan.run(single, only_squares), Flow::go);
  const std::vector<Vec2>& points = single.recording().all_points();
  ASSERT_EQ(drawn.all_points().size(), 3 * points.size());
  const CellGrid& grid = sheet->grid();
  for (std::size_t i = 0; i < drawn.all_points().size(); ++i) {
    const Vec2 corner = grid.corner(i / points.size());
    const Vec2 expected = corner + grid.scale * points[i % points.size()];
    EXPECT_NEAR(drawn.all_points()[i].x, expected.x, 1e-9);
    EXPECT_NEAR(drawn.all_points()[i].y, expected.y, 1e-9);
  }
  Recorder all;
  Checked all_checked(all);
  EXPECT_EQ(sheet->run(all_checked, {}), Flow::go);
  const Result<Forecast> forecast = sheet->check_size({}, 1e6);
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->points, static_cast<double>(all.recording().all_points().size()));
  EXPECT_FALSE(sheet->check_size({}, forecast->points - 1.0));
}

TEST(ContactSheet, LayersKeepTheirOrderInEveryCell) {
  // The second piece has other pens for its layers, so its layers are added; the third finds both of the first again.
  const Result<ContactSheet> sheet =
      ContactSheet::make({square_cell(), square_cell("pen = \"red\"", "pen = \"ink\""), square_cell()}, {});
  ASSERT_TRUE(sheet);
  Names names;
  for (const SheetLayer& layer : sheet->sheet().layers) names.push_back(layer.name);
  EXPECT_EQ(names, (Names{"square", "line", "line", "frames", "letters"}));
}

TEST(ContactSheet, PapersAreFilledWhereTheyAreShown) {
  SheetStyle style;
  style.papers = true;
  const Result<ContactSheet> sheet =
      ContactSheet::make({square_cell(), square_cell("paper = \"oat\"", "paper = \"white\""), square_cell()}, style);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->sheet().layers[0].name, "paper");
  EXPECT_EQ(sheet->sheet().layers[0].paint, Paint::fill_nonzero);
  Recorder recorder;
  preset::RunOptions only_paper;
  only_paper.wanted = [](const SheetLayer& layer) { return layer.name == "paper"; };
  ASSERT_EQ(sheet->run(recorder, only_paper), Flow::go);
  EXPECT_EQ(recorder.recording().paths().size(), 2U) << "white paper on a white sheet is not drawn";
}

TEST(ContactSheet, CellsThatAreTooSmallAreRefused) {
  std::vector<SheetCell> cells(3, square_cell());
  SheetStyle style;
  style.gap_mm = 90.0;
  style.columns = 3;
  const Result<ContactSheet> sheet = ContactSheet::make(cells, style);
  ASSERT_FALSE(sheet);
  EXPECT_EQ(sheet.problems().front().trouble, Trouble::limit);
  EXPECT_TRUE(contains(sheet.problems().front().message, "take a larger --page"));
}

TEST(Sheet, DrawsAllFormatsAndTells) {
  const TemporaryFolder folder;
  folder.write("koch.toml", koch_text);
  Names words{"sheet", "koch.toml", "--sweep", "levels=1..6", "-o", "s.svg", "-o", "s.dump"};
#ifdef BURIN_HAS_CAIRO
  words.insert(words.end(), {"-o", "s.pdf", "-o", "s.png", "--dpi", "50"});
#endif
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "page  210 x 297 mm\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "cells 6 in ")) << run.out;
  const std::string svg = folder.read("s.svg");
  for (const char* layer : {"\"1 ink ", "\"2 frame ", "\"3 letters "}) {
    const std::size_t at = svg.find(layer);
    EXPECT_NE(at, std::string::npos) << layer;
    EXPECT_EQ(svg.find(layer, at + 1), std::string::npos) << layer << " once for all cells";
  }
  EXPECT_TRUE(contains(svg, "sheet = [&quot;--sweep levels=1..6&quot;]"));
  EXPECT_TRUE(contains(burin_in(folder, {"redraw", "s.svg"}).err, "make it again with burin sheet"));
  EXPECT_FALSE(contains(svg, folder.path().string()));
  words.insert(words.end(), {"--threads", "1", "-q"});
  ASSERT_EQ(burin_in(folder, words).code, 0);
  EXPECT_EQ(folder.read("s.svg"), svg) << "the same bytes again, with one thread";
}

TEST(Sheet, GoldenDump) {
  const TemporaryFolder folder;
  folder.write("koch.toml", koch_text);
  const Finished run = burin_in(folder, {"sheet", "koch.toml", "--sweep", "levels=0,1", "--page", "a6", "--skip",
                                         "letters", "-q", "-o", "-", "--format", "dump"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out,
            R"(burin dump 1
page 105000 148000 bleed 0 paper #ffffff
pen 1 #000000 55 "ink"
pen 2 #b0b0b0 120 "frame"
pen 3 #333333 116 "letters"
layer 1 "curve" pen 1 stroke cap round join round miter 4 opacity 1
layer 2 "frames" pen 2 stroke cap round join miter miter 4 opacity 1
layer 3 "letters" pen 3 stroke cap round join round miter 4 opacity 1
path 1 stroke open
37963 43481
67037 43481
path 1 stroke open
37963 101243
47654 101243
52500 109636
57346 101243
67037 101243
path 2 stroke closed
33384 17082
71616 17082
71616 71154
33384 71154
path 2 stroke closed
33384 79041
71616 79041
71616 133112
33384 133112
)");
}

TEST(Sheet, TwoAxesMakeATable) {
  const TemporaryFolder folder;
  folder.write("koch.toml", koch_text);
  const Finished run =
      burin_in(folder, {"sheet", "koch.toml", "--sweep", "levels=1..3", "--seed", "1..5", "-o", "s.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "cells 15 in 5 columns and 3 rows")) << run.out;
  EXPECT_TRUE(contains(run.err, "nothing in 'koch.toml' is random")) << run.err;
  EXPECT_TRUE(contains(burin_in(folder, {"sheet", "koch.toml", "--sweep", "levels=1..3", "--seed", "1..5", "--columns",
                                         "4", "-o", "s.svg"})
                           .out,
                       "in 4 columns and 4 rows"));
}

TEST(Sheet, OptionsShapeThePage) {
  const TemporaryFolder folder;
  folder.write("koch.toml", koch_text);
  const Names words{"sheet",  "koch.toml", "--sweep",     "levels=1..4", "--labels", "none",  "--no-frames",
                    "--page", "a5",        "--landscape", "--margin",    "5mm",      "--gap", "0.2cm"};
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "page  210 x 148 mm")) << run.out;
  const std::string svg = folder.read("koch-sheet.svg");
  EXPECT_TRUE(contains(svg, "width=\"210mm\" height=\"148mm\""));
  EXPECT_FALSE(contains(svg, " frame "));
  EXPECT_TRUE(contains(svg, " letters ")) << "the heading stays";
}

TEST(Sheet, WrongCommandLinesTeach) {
  const TemporaryFolder folder;
  folder.write("koch.toml", koch_text);
  struct Case {
    Names options;
    int code;
    const char* said;
  };
  for (const Case& c :
       {Case{{"-o", "s.csv"}, 2, "a sheet is a page"}, Case{{"--columns", "0"}, 2, "--columns"},
        Case{{"--gap", "-1mm"}, 2, "--gap"}, Case{{"--gap", "x"}, 2, "--gap x"},
        Case{{"--labels", "valus"}, 2, "did you mean 'values'"}, Case{{"--page", "a44"}, 2, "--page a44"},
        Case{{"--margin", "200mm"}, 4, "leave 0 mm for each"}, Case{{"--seed", "0..9999"}, 4, "take a larger --page"},
        Case{{"--seed", "0..10000"}, 4, "--max-results"}, Case{{"--sweep", "levels=999..1001"}, 3, "outside [0, 1000]"},
        Case{{"--max-points", "10"}, 4, "--max-points"}, Case{{"-o", "missing/s.svg"}, 5, "missing"}}) {
    Names words{"sheet", "koch.toml"};
    words.insert(words.end(), c.options.begin(), c.options.end());
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, c.code) << c.said << run.err;
    EXPECT_TRUE(contains(run.err, c.said)) << c.said << ": " << run.err;
  }
  EXPECT_EQ(folder.names(), Names{"koch.toml"});
}

}  // namespace
}  // namespace burin::test
