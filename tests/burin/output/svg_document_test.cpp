#include <limits>

#include <gtest/gtest.h>

#include "support/svg_drawing.hpp"

namespace burin {
namespace {

using test::plain_sheet;
using test::read_xml;
using test::svg_of;
using test::XmlElement;

test::DrawnPath line_on(LayerId layer, Paint paint = Paint::stroke) {
  return {{layer, Role::ink, paint}, {{{0, 0}, {1, 1}, {2, 0}}}};
}

TEST(SvgDocument, RootIsInMillimetresOfThePage) {
  Sheet sheet = plain_sheet();
  sheet.page.width_mm = 8.5 * 25.4;
  sheet.page.height_mm = 279.4;
  const XmlElement svg = read_xml(svg_of(sheet, {}).text);
  EXPECT_EQ(svg.name, "svg");
  EXPECT_EQ(svg.at("xmlns"), "http://www.w3.org/2000/svg");
  EXPECT_EQ(svg.at("xmlns:inkscape"), "http://www.inkscape.org/namespaces/inkscape");
  EXPECT_EQ(svg.at("width"), "215.9mm");
  EXPECT_EQ(svg.at("height"), "279.4mm");
  EXPECT_EQ(svg.at("viewBox"), "0 0 215.9 279.4");

  sheet.page.width_mm = 100.0 / 3.0;
  const XmlElement third = read_xml(svg_of(sheet, {}).text);
  EXPECT_EQ(third.at("width"), "33.333333mm");
  EXPECT_EQ(third.at("viewBox"), "0 0 33.333333 279.4");
}

TEST(SvgDocument, EveryLayerIsATopLevelGroupInSheetOrder) {
  const Sheet sheet = plain_sheet(5);
  const XmlElement svg = read_xml(svg_of(sheet, {line_on(1), line_on(1), line_on(3)}).text);
  const auto layers = test::layers_of(svg);
  ASSERT_EQ(layers.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(layers[i]->name, "g");
    EXPECT_EQ(layers[i]->at("inkscape:groupmode"), "layer");
    EXPECT_EQ(layers[i]->at("inkscape:label"), i % 2 == 0 ? "1 ink 0.3" : "2 red 0.8");
    EXPECT_EQ(layers[i]->at("id"), "layer" + std::to_string(i + 1));
    EXPECT_EQ(layers[i]->children.size(), i % 2 == 0 ? 0U : 1U) << i;
  }
}

TEST(SvgDocument, ADrawingWithoutPathsStillHasItsLayers) {
  const XmlElement svg = read_xml(svg_of(plain_sheet(2), {}).text);
  EXPECT_EQ(test::layers_of(svg).size(), 2U);
}

TEST(SvgDocument, StyleStandsOnTheGroup) {
  Sheet sheet = plain_sheet();
  SheetLayer& layer = sheet.layers[0];
  layer.pen = 1;
  const auto group = [&] { return *test::layers_of(read_xml(svg_of(sheet, {line_on(0)}).text)).at(0); };
  const auto style = [](const XmlElement& element) {
    std::string text;
    for (const auto& [name, value] : element.attributes) {
      if (name != "inkscape:groupmode" && name != "inkscape:label" && name != "id" && name != "d") {
        text += name + "=" + value + ";";
      }
    }
    return text;
  };
  EXPECT_EQ(style(group()), "fill=none;stroke=#c80000;stroke-linecap=round;stroke-linejoin=round;stroke-width=0.8;");

  layer.cap = Cap::square;
  layer.join = Join::miter;
  layer.miter_limit = 2.5;
  layer.dashes_mm = {4, 1.5, 0.25};
  layer.dash_offset_mm = -1;
  layer.opacity = 0.35;
  EXPECT_EQ(style(group()),
            "fill=none;opacity=0.35;stroke=#c80000;stroke-dasharray=4 1.5 0.25;stroke-dashoffset=-1;"
            "stroke-linecap=square;stroke-miterlimit=2.5;stroke-width=0.8;");
  EXPECT_EQ(style(group().child("path")), "");

  layer = {};
  layer.paint = Paint::fill_evenodd;
  layer.cap = Cap::butt;
  layer.join = Join::bevel;
  EXPECT_EQ(style(group()), "fill=#000000;fill-rule=evenodd;stroke=none;stroke-linejoin=bevel;stroke-width=0.3;");
}

TEST(SvgDocument, APathPaintedOtherwiseThanItsLayerSaysSo) {
  Sheet sheet = plain_sheet();
  const std::vector<test::DrawnPath> paths{line_on(0), line_on(0, Paint::fill_nonzero), line_on(0)};
  const XmlElement strokes = read_xml(svg_of(sheet, paths).text);
  const std::vector<XmlElement> in_strokes = test::layers_of(strokes).at(0)->children;
  ASSERT_EQ(in_strokes.size(), 3U);
  EXPECT_FALSE(in_strokes[0].has("fill"));
  EXPECT_EQ(in_strokes[1].at("fill"), "#000000");
  EXPECT_EQ(in_strokes[1].at("fill-rule"), "nonzero");
  EXPECT_EQ(in_strokes[1].at("stroke"), "none");
  EXPECT_FALSE(in_strokes[2].has("fill"));

  sheet.layers[0].paint = Paint::fill_nonzero;
  const XmlElement fills = read_xml(svg_of(sheet, paths).text);
  const std::vector<XmlElement> in_fills = test::layers_of(fills).at(0)->children;
  ASSERT_EQ(in_fills.size(), 3U);
  EXPECT_EQ(in_fills[0].at("fill"), "none");
  EXPECT_EQ(in_fills[0].at("stroke"), "#000000");
  EXPECT_FALSE(in_fills[1].has("fill"));
}

TEST(SvgDocument, PaperIsDrawnOnRequestOutsideTheLayers) {
  Sheet sheet = plain_sheet();
  sheet.page = {100, 50, 3, {0xF4, 0xEF, 0xE4}};
  EXPECT_EQ(svg_of(sheet, {}).text.find("<rect"), std::string::npos);
  OutputOptions options;
  options.paper = true;
  const XmlElement svg = read_xml(svg_of(sheet, {}, options).text);
  EXPECT_EQ(test::layers_of(svg).size(), 1U);
  const XmlElement& paper = svg.children.at(1);
  EXPECT_EQ(paper.at("id"), "paper");
  EXPECT_FALSE(paper.has("inkscape:groupmode"));
  const XmlElement& rect = paper.child("rect");
  EXPECT_EQ(rect.at("fill"), "#f4efe4");
  EXPECT_EQ(rect.at("x") + " " + rect.at("y") + " " + rect.at("width") + " " + rect.at("height"), "-3 -3 106 56");
}

TEST(SvgDocument, OriginReadsBackExactly) {
  std::string every_byte;
  for (int byte = 0; byte < 256; ++byte) every_byte += static_cast<char>(byte);
  for (const std::string& record :
       {std::string("seed = 19\n[knobs]\nlevels = 4\n"), std::string("a\r\nb\rc\\x41 \\\\ ]]> <!-- & \" ' \t end "),
        every_byte,
        std::string("\xEF\xBF\xBE \xED\xA0\x80 \xF4\x90\x80\x80 \xC0\xAF \xE2\x82 \xE2\x82\xAC \xF0\x9F\x8E\xA8"),
        std::string("\xE2\x82")}) {
    Sheet sheet = plain_sheet();
    sheet.made_by.record = record;
    const XmlElement svg = read_xml(svg_of(sheet, {}).text);
    EXPECT_EQ(test::exact_text(svg.child("metadata").child("burin:origin").text), record);
  }
}

TEST(SvgDocument, HostileTitlesStayText) {
  Sheet sheet = plain_sheet();
  sheet.made_by.title = "</title><script>alert(1)</script> & \"quotes\" ]]> \x01\xFF \xC3\xA9";
  sheet.made_by.author = "A <b> & C";
  sheet.made_by.summary = "first\nsecond";
  sheet.pens[0].name = "ink\" onload=\"x\n<&>";
  const XmlElement svg = read_xml(svg_of(sheet, {line_on(0)}).text);
  const std::string shown = "</title><script>alert(1)</script> & \"quotes\" ]]> \uFFFD\uFFFD \u00E9";
  EXPECT_EQ(svg.child("title").text, shown);
  EXPECT_EQ(svg.child("desc").text, "first\nsecond");
  const XmlElement& work = svg.child("metadata").child("rdf:RDF").child("cc:Work");
  EXPECT_EQ(work.child("dc:title").text, shown);
  EXPECT_EQ(work.child("dc:creator").child("cc:Agent").child("dc:title").text, "A <b> & C");
  EXPECT_EQ(test::layers_of(svg).at(0)->at("inkscape:label"), "1 ink\" onload=\"x\n<&> 0.3");
}

TEST(SvgDocument, WhatIsNotKnownIsNotThere) {
  const XmlElement svg = read_xml(svg_of(plain_sheet(), {}).text);
  EXPECT_THROW((void)svg.child("title"), std::runtime_error);
  EXPECT_THROW((void)svg.child("desc"), std::runtime_error);
  EXPECT_THROW((void)svg.child("metadata").child("burin:origin"), std::runtime_error);
}

TEST(SvgDocument, PagesAndDecimalsOutOfRangeAreRefused) {
  Sheet sheet = plain_sheet();
  EXPECT_TRUE(output::svg_accepts(sheet, {}));
  for (const int decimals : {0, 6}) {
    OutputOptions options;
    options.decimals = decimals;
    EXPECT_TRUE(output::svg_accepts(sheet, options));
  }
  for (const int decimals : {-1, 7}) {
    OutputOptions options;
    options.decimals = decimals;
    const Result<Done> accepted = output::svg_accepts(sheet, options);
    ASSERT_FALSE(accepted);
    EXPECT_NE(accepted.problems()[0].message.find("0 to 6"), std::string::npos);
  }
  sheet.page.width_mm = 20'000;
  EXPECT_TRUE(output::svg_accepts(sheet, {}));
  sheet.page.width_mm = 20'000.1;
  ASSERT_FALSE(output::svg_accepts(sheet, {}));
  EXPECT_EQ(output::svg_accepts(sheet, {}).problems()[0].trouble, Trouble::limit);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    sheet.page.width_mm = bad;
    EXPECT_FALSE(output::svg_accepts(sheet, {})) << bad;
  }
}

TEST(SvgDocumentDeathTest, LayersMustAscend) {
  EXPECT_DEATH((void)svg_of(plain_sheet(2), {line_on(1), line_on(0)}), "contract broken");
  EXPECT_DEATH((void)svg_of(plain_sheet(2), {line_on(2)}), "contract broken");
}

}  // namespace
}  // namespace burin
