#include <gtest/gtest.h>

#include "burin/output/pdf_drawing.hpp"

namespace burin {
namespace {

using test::fill;
using test::pdf_of;
using test::PdfFile;
using test::PdfPainted;
using test::PdfStyle;
using test::PdfText;
using test::plain_sheet;
using test::steps;
using test::stroke;

constexpr double points_per_mm = 72.0 / 25.4;

test::DrawnPath diagonal(LayerId layer = 0) {
  return stroke({{10, 10}, {90, 60}}, false, layer);
}

TEST(PdfDocument, PageHasItsTrueSizeInPoints) {
  const PdfFile file = pdf_of(plain_sheet(), {diagonal()}).file();
  EXPECT_EQ(file.numbers(file.page(), "MediaBox"), (std::vector<double>{0, 0, 595.275591, 841.889764}));
  EXPECT_FALSE(file.page().contains("TrimBox"));
}

TEST(PdfDocument, EachSheetLayerIsALayerOfTheSameNameAsInSvg) {
  Sheet sheet = plain_sheet(3);
  sheet.layers[1].opacity = 0.5;
  const PdfText pdf = pdf_of(sheet, {diagonal(0), diagonal(1), diagonal(2)});
  EXPECT_EQ(pdf.file().layer_names(), (std::vector<std::string>{"1 ink 0.3", "2 red 0.8", "1 ink 0.3"}));
  const std::vector<PdfPainted> painted = pdf.painted();
  ASSERT_EQ(painted.size(), 3U);
  EXPECT_EQ(painted[0].layer, "1 ink 0.3");
  EXPECT_EQ(painted[1].layer, "2 red 0.8");
  EXPECT_EQ(painted[2].layer, "1 ink 0.3");
}

TEST(PdfDocument, ALayerWithoutPathsIsListed) {
  EXPECT_EQ(pdf_of(plain_sheet(2), {diagonal(1)}).file().layer_names().size(), 2U);
  EXPECT_TRUE(pdf_of(plain_sheet(2), {}).painted().empty());
}

TEST(PdfDocument, StyleIsTheLayers) {
  Sheet sheet = plain_sheet(2);
  SheetLayer& layer = sheet.layers[0];
  layer.cap = Cap::square;
  layer.join = Join::miter;
  layer.miter_limit = 2.5;
  layer.dashes_mm = {1, 2, 3};
  layer.dash_offset_mm = -1;
  const std::vector<PdfPainted> painted = pdf_of(sheet, {diagonal(0), diagonal(1)}).painted();
  const PdfStyle& first = painted.at(0).style;
  EXPECT_NEAR(first.width, 0.3 * points_per_mm, 1e-6);
  EXPECT_EQ(first.cap, 2);
  EXPECT_EQ(first.join, 0);
  EXPECT_EQ(first.miter, 2.5);
  ASSERT_EQ(first.dashes.size(), 3U);
  EXPECT_NEAR(first.dashes[2], 3.0 * points_per_mm, 1e-6);
  EXPECT_NEAR(first.dash_offset, 11.0 * points_per_mm, 1e-6) << "an odd pattern repeats after two rounds";
  const PdfStyle& second = painted.at(1).style;
  EXPECT_NEAR(second.width, 0.8 * points_per_mm, 1e-6);
  EXPECT_EQ(second.cap, 1);
  EXPECT_EQ(second.join, 1);
  EXPECT_TRUE(second.dashes.empty());
}

TEST(PdfDocument, DashesOfNoLengthAreAFullLine) {
  Sheet sheet = plain_sheet();
  sheet.layers[0].dashes_mm = {0, 0};
  EXPECT_TRUE(pdf_of(sheet, {diagonal()}).painted().at(0).style.dashes.empty());
}

TEST(PdfDocument, GreysAreGreyAndColoursRgb) {
  Sheet sheet = plain_sheet(2);
  sheet.pens[0].colour = {51, 51, 51};
  sheet.pens[1].colour = {255, 0, 102};
  const std::vector<PdfPainted> painted = pdf_of(sheet, {diagonal(0), diagonal(1)}).painted();
  EXPECT_EQ(painted.at(0).style.line_colour, "2000 G");
  EXPECT_EQ(painted.at(0).style.fill_colour, "2000 g");
  EXPECT_EQ(painted.at(1).style.line_colour, "10000 0 4000 RG");
  EXPECT_EQ(painted.at(1).style.fill_colour, "10000 0 4000 rg");
}

TEST(PdfDocument, InksStayInks) {
  Sheet sheet = plain_sheet(2);
  sheet.pens[0].cmyk = Cmyk{0.1, 0.9, 1.0, 0.05};
  sheet.pens[1].spot = "Pantone 485 C";
  const PdfText pdf = pdf_of(sheet, {diagonal(0), diagonal(1)});
  const std::vector<PdfPainted> painted = pdf.painted();
  EXPECT_EQ(painted.at(0).style.line_colour, "1000 9000 10000 500 K");
  EXPECT_EQ(painted.at(0).style.fill_colour, "1000 9000 10000 500 k");
  EXPECT_EQ(painted.at(1).style.line_colour, "10000 Pantone 485 C");
  EXPECT_EQ(painted.at(1).style.fill_colour, "10000 Pantone 485 C");
  EXPECT_NE(pdf.bytes.find("[/Separation/Pantone#20485#20C/DeviceRGB<</FunctionType 2/Domain[0 1]/C0[1 1 1]/C1["),
            std::string::npos);
  sheet.pens[1].cmyk = Cmyk{0.0, 0.95, 1.0, 0.0};
  EXPECT_NE(pdf_of(sheet, {diagonal(1)})
                .bytes.find("C/DeviceCMYK<</FunctionType 2/Domain[0 1]/C0[0 0 0 0]/C1[0 .95 1 0]/N 1>>]"),
            std::string::npos);
}

TEST(PdfDocument, ALayerWithOpacityIsOneGroup) {
  Sheet sheet = plain_sheet(2);
  sheet.layers[0].opacity = 0.4;
  sheet.layers[1].opacity = 0.6;
  std::vector<test::DrawnPath> paths;
  for (int i = 0; i < 60; ++i) paths.push_back(stroke(test::zigzag(1500)));  // several chunks
  paths.push_back(diagonal(1));
  const PdfText pdf = pdf_of(sheet, paths);
  const std::vector<PdfPainted> painted = pdf.painted();
  for (std::size_t i = 0; i + 1 < painted.size(); ++i) {
    ASSERT_EQ(painted[i].group, 1U);
    ASSERT_DOUBLE_EQ(painted[i].style.opacity, 0.4);
    ASSERT_NEAR(painted[i].style.width, 0.3 * points_per_mm, 1e-6) << "set before the group";
  }
  EXPECT_EQ(painted.back().group, 2U);
  EXPECT_DOUBLE_EQ(painted.back().style.opacity, 0.6);
  EXPECT_TRUE(pdf.file().page().contains("Group"));
  EXPECT_EQ(pdf_of(plain_sheet(), {diagonal()}).painted().at(0).group, 0U);
}

TEST(PdfDocument, ShowsThePaperOnRequest) {
  Sheet sheet = plain_sheet();
  sheet.page.paper = {10, 20, 30};
  EXPECT_EQ(pdf_of(sheet, {diagonal()}).painted().size(), 1U);
  OutputOptions options;
  options.paper = true;
  const std::vector<PdfPainted> painted = pdf_of(sheet, {diagonal()}, options).painted();
  ASSERT_EQ(painted.size(), 2U);
  EXPECT_EQ(painted[0].by, "f");
  EXPECT_EQ(painted[0].layer, "");
  EXPECT_EQ(painted[0].style.fill_colour, "392 784 1176 rg");
  EXPECT_EQ(steps(painted[0].contours.at(0).points.at(0)), steps({0, 0}));
  EXPECT_EQ(steps(painted[0].contours.at(0).points.at(2)), steps({210, 297}));
}

TEST(PdfDocument, BleedHasBoxesAndCropMarksOutsideOfIt) {
  for (const double bleed_mm : {3.0, 1.0}) {
    Sheet sheet = plain_sheet();
    sheet.page.bleed_mm = bleed_mm;
    OutputOptions options;
    options.paper = true;
    const PdfText pdf = pdf_of(sheet, {diagonal()}, options);
    const PdfFile file = pdf.file();
    const std::vector<double> media = file.numbers(file.page(), "MediaBox");
    const std::vector<double> trim = file.numbers(file.page(), "TrimBox");
    const std::vector<double> bleed = file.numbers(file.page(), "BleedBox");
    EXPECT_NEAR(trim[2] - trim[0], 210.0 * points_per_mm, 1e-5);
    EXPECT_NEAR(trim[3] - trim[1], 297.0 * points_per_mm, 1e-5);
    for (const std::size_t side : {0U, 1U}) {
      EXPECT_NEAR(trim[side] - bleed[side], bleed_mm * points_per_mm, 1e-5);
      EXPECT_NEAR(bleed[side + 2] - trim[side + 2], bleed_mm * points_per_mm, 1e-5);
      EXPECT_EQ(media[side], 0.0);
      EXPECT_NEAR(media[side + 2] - trim[side + 2], trim[side], 1e-5);
    }
    const std::vector<PdfPainted> painted = pdf.painted();
    ASSERT_EQ(painted.size(), 3U);  // marks, paper, line
    EXPECT_EQ(painted[0].style.line_colour, "10000 All");
    ASSERT_EQ(painted[0].contours.size(), 8U);
    for (const test::PdfContour& mark : painted[0].contours) {
      ASSERT_EQ(mark.points.size(), 2U);
      const auto outside = [&](double at, double side) { return at < -bleed_mm + 1e-6 || at > side + bleed_mm - 1e-6; };
      for (const Vec2 p : mark.points) {
        EXPECT_TRUE(outside(p.x, 210.0) || outside(p.y, 297.0)) << p.x << ' ' << p.y;
        EXPECT_GT(p.x, -trim[0] / points_per_mm);
        EXPECT_GT(p.y, -trim[1] / points_per_mm);
      }
      // Each lies on the line along an edge of the page.
      const bool level = steps(mark.points[0]).second == steps(mark.points[1]).second;
      const long long along = level ? steps(mark.points[0]).second : steps(mark.points[0]).first;
      EXPECT_TRUE(along == 0 || along == (level ? 297'000 : 210'000)) << along;
    }
    EXPECT_EQ(steps(painted[1].contours.at(0).points.at(0)), steps({-bleed_mm, -bleed_mm}));
    EXPECT_EQ(steps(painted[2].contours.at(0).points.at(0)), steps({10, 10}));
  }
}

TEST(PdfDocument, CarriesTheOriginCharacterForCharacter) {
  Sheet sheet = plain_sheet();
  sheet.made_by = {.title = "Winter (card)",
                   .author = "Ren\xC3\xA9 \\ Co",
                   .summary = "A wreath & <more>",
                   .record = "burin = 1\r\n[knobs] # \xE2\x9D\x84 \xF0\x9F\x98\x80\n\tx = \"(a\\\\b)\" \n\n"};
  const auto info_text = [](const PdfFile& file, std::string_view key) {
    return file.text(file.dictionary(file.trailer(), "Info"), key);
  };
  const PdfFile file = pdf_of(sheet, {diagonal()}).file();
  EXPECT_EQ(info_text(file, "Title"), sheet.made_by.title);
  EXPECT_EQ(info_text(file, "Author"), sheet.made_by.author);
  EXPECT_EQ(info_text(file, "Subject"), sheet.made_by.summary);
  EXPECT_EQ(info_text(file, "Keywords"), sheet.made_by.record);
  EXPECT_EQ(info_text(file, "Creator"), "burin");
  EXPECT_EQ(info_text(file, "CreationDate"), "D:20000101000000Z");
  EXPECT_EQ(info_text(file, "ModDate"), "D:20000101000000Z");

  sheet.made_by.record = "plain (text)\r\nof \\ lines\tand\n";
  EXPECT_EQ(info_text(pdf_of(sheet, {}).file(), "Keywords"), sheet.made_by.record);
  sheet.made_by.record = "a\x01 b\xFF c";
  EXPECT_EQ(info_text(pdf_of(sheet, {}).file(), "Keywords"), "a\uFFFD b\uFFFD c");
}

TEST(PdfDocument, SaysTheSameInXmp) {
  Sheet sheet = plain_sheet();
  sheet.made_by = {"Snow & ice", "Ren\xC3\xA9", "Six-fold.", "x"};
  const PdfFile file = pdf_of(sheet, {}).file();
  const auto& reference = std::get<test::PdfReference>(file.catalog().at("Metadata").data);
  const std::string packet = file.object(reference.id).stream;
  const std::size_t begin = packet.find("?>\n") + 3;
  const test::XmlElement root = test::read_xml("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
                                               packet.substr(begin, packet.find("<?xpacket end") - begin));
  const test::XmlElement& about = root.child("rdf:RDF").child("rdf:Description");
  EXPECT_EQ(about.child("dc:title").child("rdf:Alt").child("rdf:li").text, "Snow & ice");
  EXPECT_EQ(about.child("dc:creator").child("rdf:Seq").child("rdf:li").text, "Ren\xC3\xA9");
  EXPECT_EQ(about.child("dc:description").child("rdf:Alt").child("rdf:li").text, "Six-fold.");
  EXPECT_EQ(about.child("xmp:CreateDate").text, "2000-01-01T00:00:00Z");
}

TEST(PdfDocument, IdentifierComesFromTheOriginAlone) {
  const auto identifier = [](const std::string& record) {
    Sheet sheet = plain_sheet();
    sheet.made_by.record = record;
    const PdfFile file = pdf_of(sheet, {}).file();
    const auto& both = std::get<test::PdfArray>(file.trailer().at("ID").data);
    EXPECT_EQ(std::get<std::string>(both.at(0).data), std::get<std::string>(both.at(1).data));
    return std::get<std::string>(both.at(0).data);
  };
  EXPECT_EQ(identifier("a").size(), 16U);
  EXPECT_EQ(identifier("a"), identifier("a"));
  EXPECT_NE(identifier("a"), identifier("b"));
}

TEST(PdfDocument, RefusesPagesThatViewersDoNotOpen) {
  Sheet sheet = plain_sheet();
  sheet.page.height_mm = 5080.0;
  EXPECT_TRUE(output::pdf_accepts(sheet, {}));
  sheet.page.bleed_mm = 3.0;
  const Result<Done> with_marks = output::pdf_accepts(sheet, {});
  ASSERT_FALSE(with_marks);
  EXPECT_EQ(with_marks.problems()[0].trouble, Trouble::limit);
  EXPECT_NE(with_marks.problems()[0].message.find("crop marks"), std::string::npos);
  sheet.page.bleed_mm = 0.0;
  sheet.page.height_mm = 5080.1;
  EXPECT_FALSE(output::pdf_accepts(sheet, {}));
  sheet.page.height_mm = 0.0;
  EXPECT_FALSE(output::pdf_accepts(sheet, {}));
  OutputOptions options;
  options.decimals = 7;
  EXPECT_FALSE(output::pdf_accepts(plain_sheet(), options));
}

TEST(PdfDocument, StreamsArePackedInChunks) {
  std::vector<test::DrawnPath> paths;
  for (int i = 0; i < 200; ++i) paths.push_back(stroke(test::zigzag(1000)));
  const PdfFile file = pdf_of(plain_sheet(), paths).file();
  const auto& chunks = std::get<test::PdfArray>(file.page().at("Contents").data);
  EXPECT_GT(chunks.size(), 5U);
  for (const test::PdfValue& chunk : chunks) {
    const PdfFile::Object& object = file.object(std::get<test::PdfReference>(chunk.data).id);
    EXPECT_LT(object.stream.size(), 400'000U);
    EXPECT_LT(object.stream_bytes, object.stream.size() / 2 + 1000);
  }
}

}  // namespace
}  // namespace burin
