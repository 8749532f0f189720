#include "preset_text.hpp"

namespace burin::preset {
namespace {

PageSpec page_of(std::string_view page) {
  return piece_of("page = { margin = 0, " + std::string(page) + " }").page;
}

TEST(PageSize, KnowsThePapers) {
  EXPECT_EQ(piece_of("").page.size.width_mm, 210.0);
  EXPECT_EQ(piece_of("").page.size.height_mm, 297.0);
  for (const auto& [text, width, height] :
       std::initializer_list<std::tuple<std::string, double, double>>{{"a0", 841, 1189},
                                                                      {"A3", 297, 420},
                                                                      {"a6", 105, 148},
                                                                      {"b0", 1000, 1414},
                                                                      {"b5", 176, 250},
                                                                      {"letter", 215.9, 279.4},
                                                                      {"legal", 215.9, 355.6},
                                                                      {"tabloid", 279.4, 431.8},
                                                                      {"square", 210, 210},
                                                                      {"30x40cm", 300, 400},
                                                                      {"200mm x 300mm", 200, 300},
                                                                      {"200mm x 30cm", 200, 300},
                                                                      {"30x40", 30, 40},
                                                                      {"8x10in", 203.2, 254},
                                                                      {"96px x 192px", 25.4, 50.8},
                                                                      {"(max(1,2)*10)mm x 3cm", 20, 30}}) {
    const PageSpec page = page_of("size = '" + text + "'");
    EXPECT_NEAR(page.size.width_mm, width, 1e-9) << text;
    EXPECT_NEAR(page.size.height_mm, height, 1e-9) << text;
  }
}

TEST(PageSize, TurnsOnItsSide) {
  EXPECT_EQ(page_of("size = 'a4', landscape = true").size.width_mm, 297.0);
  EXPECT_EQ(page_of("size = '40x30cm', landscape = true").size.width_mm, 400.0);
  EXPECT_EQ(page_of("size = '30x40cm', landscape = true").size.height_mm, 300.0);
}

TEST(PageSize, ReportsWhatIsNone) {
  EXPECT_EQ(complaints_in("page.size = 'leter'"),
            "p.toml:2:14: error: 'size': 'leter' is no paper such as a4 or 30x40cm; did you mean 'letter'?\n");
  EXPECT_EQ(complaints_in("page.size = '30xx40cm'").substr(0, 46), "p.toml:2:14: error: 'size': unknown name 'x40'");
  EXPECT_EQ(complaints_in("page.size = '0x40cm'"),
            "p.toml:2:14: error: 'size': a side of 0 mm is outside [1, 20000] mm\n");
  EXPECT_EQ(complaints_in("page.size = '-30x40cm'"),
            "p.toml:2:14: error: 'size': a side of -300 mm is outside [1, 20000] mm\n");
  EXPECT_EQ(complaints_in("page.size = 30"),
            "p.toml:2:13: error: 'size': expected a paper such as \"a4\" or \"30x40cm\", found a whole number\n");
  EXPECT_EQ(complaints_in("page = 'a4'"), "p.toml:2:9: error: 'page' is a table: [page], not a text\n");
}

TEST(Margins, GoClockwiseFromTheTop) {
  const auto margins = [](std::string_view text) {
    const Margins m = piece_of("page.margin = " + std::string(text)).page.margin;
    return std::array<double, 4>{m.top_mm, m.right_mm, m.bottom_mm, m.left_mm};
  };
  using Four = std::array<double, 4>;
  EXPECT_EQ(margins("7"), (Four{7, 7, 7, 7}));
  EXPECT_EQ(margins("'1cm'"), (Four{10, 10, 10, 10}));
  EXPECT_EQ(margins("'1 2'"), (Four{1, 2, 1, 2}));
  EXPECT_EQ(margins("'1mm 2mm 3mm'"), (Four{1, 2, 3, 2}));
  EXPECT_EQ(margins("' 1  2 (3 + 1)mm 5 '"), (Four{1, 2, 4, 5}));
  EXPECT_EQ(margins("0"), (Four{0, 0, 0, 0}));
}

TEST(Margins, LeaveALiveArea) {
  EXPECT_EQ(complaints_in("page.margin = '1 2 3 4 5'"),
            "p.toml:2:16: error: 'margin': expected one to four lengths in a text, found a text\n");
  EXPECT_EQ(complaints_in("page.margin = -1"), "p.toml:2:15: error: 'margin': a margin of -1 mm is below 0\n");
  EXPECT_EQ(complaints_in("page.margin = '10mm 105mm'"),
            "p.toml:2:16: error: margins of 105 mm and 105 mm leave nothing of the page's width of 210 mm\n");
  EXPECT_EQ(complaints_in("page.size = '6x9cm'\npage.margin = '45mm 5mm'"),
            "p.toml:3:16: error: margins of 45 mm and 45 mm leave nothing of the page's height of 90 mm\n");
  EXPECT_EQ(complaints_in("page.size = '5x9cm'"),
            "p.toml:2:14: error: margins of 25 mm and 25 mm leave nothing of the page's width of 50 mm; set "
            "'margin'\n");
}

TEST(Colour, IsANameOrHexadecimal) {
  EXPECT_EQ(page_of("paper = 'black'").paper, (Colour{0, 0, 0}));
  EXPECT_EQ(page_of("paper = '#0F08fe'").paper, (Colour{15, 8, 254}));
  EXPECT_EQ(complaints_in("page.paper = 'tomatoo'"),
            "p.toml:2:15: error: 'paper': 'tomatoo' is no color; did you mean 'tomato'?\n");
  EXPECT_EQ(complaints_in("page.paper = '#12345'"),
            "p.toml:2:15: error: 'paper': '#12345' is no color; write a name such as black, or #rrggbb\n");
}

TEST(Pens, KeepTheOrderOfTheFile) {
  const Piece piece = piece_of("[pens]\nzinc = {}\nalum = { width = '0.8pt', color = 'red' }\n[pens.mid]\nwidth = 1");
  ASSERT_EQ(piece.pens.size(), 3U);
  EXPECT_EQ(piece.pens[0].name, "zinc");
  EXPECT_EQ(piece.pens[1].name, "alum");
  EXPECT_NEAR(piece.pens[1].pen.width.mm, 0.8 * 25.4 / 72.0, 1e-12);
  EXPECT_EQ(piece.pens[2].name, "mid");
  EXPECT_EQ(piece.layers[0].style.pen.of, std::vector<std::string>{"zinc"});
}

TEST(Pens, ThereIsAlwaysOne) {
  const Piece piece = piece_of("");
  ASSERT_EQ(piece.pens.size(), 1U);
  EXPECT_EQ(piece.pens[0].name, "ink");
  EXPECT_EQ(piece.pens[0].pen.color, (Colour{0, 0, 0}));
  EXPECT_EQ(piece.pens[0].pen.width.mm, 0.3);
}

TEST(Pens, HaveAWidthAboveZero) {
  EXPECT_EQ(complaints_in("[pens]\nink = { width = -0.0 }\nred = { width = '101mm' }\nblue = 3"),
            "p.toml:3:17: error: 'width' = 0 mm is outside (0, 100] mm\n"
            "p.toml:4:18: error: 'width' = 101 mm is outside (0, 100] mm\n"
            "p.toml:5:8: error: pen 'blue' is a table in braces, not a whole number\n");
}

}  // namespace
}  // namespace burin::preset
