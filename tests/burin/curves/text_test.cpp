#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <burin/curves/text/layout.hpp>
#include <burin/curves/text/text.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// Lines of letters: measures, alignment, views, and what is refused.
namespace burin::curves {
namespace {

TextParams sans(std::string text) {
  TextParams params;
  params.text.text = std::move(text);
  return params;
}

Recording recorded(const TextParams& params, const View& view = {}) {
  return testing::record("text", params, {.view = view});
}

std::string complaint(std::string_view json) {
  const testing::ReadParams read = testing::read_params("text", json);
  EXPECT_FALSE(read.params.has_value());
  std::string all;
  for (const Problem& problem : read.problems) all += problem.message + '\n';
  return all;
}

TEST(Text, ACapitalIsExactlyOneHigh) {
  EXPECT_EQ(text_box(sans("H")), (Box2{{4.0 / 21, 0.0}, {18.0 / 21, 1.0}}));
}

TEST(Text, WidthsAreTheSumOfTheAdvances) {
  // rowmans: A 18, V 18, I 8, space 16 units.
  EXPECT_NEAR(text_width(sans("AVI I")), (18 + 18 + 8 + 16 + 8) / 21.0, 1e-12);
  EXPECT_EQ(text_width(sans("I\nAVI")), text_width(sans("AVI")));
  TextParams spaced = sans("AVI");
  spaced.tracking = 0.25;
  EXPECT_NEAR(text_width(spaced), text_width(sans("AVI")) + 2 * 0.25, 1e-12);
  EXPECT_EQ(text_width(sans("")), 0.0);
}

TEST(Text, LinesGoDown) {
  TextParams lines = sans("H\n\nH");
  lines.line_height = 2.5;
  const Box2 box = text_box(lines);
  EXPECT_EQ(box.high.y, 1.0);
  EXPECT_EQ(box.low.y, -5.0);
}

TEST(Text, AlignsItsLines) {
  TextParams lines = sans("I\nHHH");
  const double width = text_width(lines);
  const double bearing = 4.0 / 21;
  const auto first_x = [&] { return recorded(lines).all_points().front().x; };
  EXPECT_NEAR(first_x(), bearing, 1e-12);
  lines.align = TextAlign::center;
  EXPECT_NEAR(first_x(), 0.0, 1e-12);
  EXPECT_NEAR(text_box(lines).center().x, 0.0, 1e-12);
  lines.align = TextAlign::right;
  EXPECT_NEAR(first_x(), -bearing, 1e-12);
  EXPECT_NEAR(text_box(lines).low.x, -width + bearing, 1e-12);
}

TEST(Text, SlantsAboutTheBaseline) {
  TextParams slanted = sans("I");
  slanted.slant = 45.0;
  const std::vector<Vec2> points = recorded(slanted).all_points();
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1], (Vec2{4.0 / 21, 0.0}));
  EXPECT_EQ(points[0], (Vec2{4.0 / 21 + 1.0, 1.0}));
}

TEST(Text, StrokesAreOpenPaths) {
  const Recording drawing = recorded(sans("Oi."));
  EXPECT_EQ(drawing.paths().size(), 4U);
  for (const Recording::Path& path : drawing.paths()) EXPECT_FALSE(path.head.closed);
}

TEST(Text, ShowsOnlyTheLettersInView) {
  const TextParams params = sans("HIH\nHIH");
  const double width = text_width(params);
  const Recording all = recorded(params);
  // About the middle of the first line there is only the I.
  const View view{{{0.5 * width - 0.01, 0.4}, {0.5 * width + 0.01, 0.5}}, 0.1};
  const Recording seen = recorded(params, view);
  ASSERT_EQ(seen.all_points().size(), 2U);
  EXPECT_EQ(seen.all_points()[0], all.all_points()[6]);
  EXPECT_EQ(seen.all_points()[1], all.all_points()[7]);
  const Forecast forecast = find_family("text")->forecast(params, {.view = view}, 1e9);
  EXPECT_EQ(forecast.points, 2.0);
  EXPECT_EQ(forecast.asked_points, static_cast<double>(all.all_points().size()));
}

TEST(Text, LabelsAreMappedUnderTheirHead) {
  Recorder recorder;
  const Affine2 page_from_model = translation({10.0, 20.0}) * scaling(4.0, -4.0);
  const PathHead head{.layer = 3, .level = 7};
  ASSERT_EQ(draw_text(sans("I"), page_from_model, head, recorder), Flow::go);
  ASSERT_EQ(recorder.recording().paths().size(), 1U);
  EXPECT_EQ(recorder.recording().paths()[0].head, head);
  EXPECT_EQ(recorder.recording().bounds(), text_box(sans("I"), page_from_model));
  EXPECT_EQ(text_box(sans("I"), page_from_model).low.y, 16.0);
  EXPECT_EQ(text_box(sans("I"), page_from_model).high.y, 20.0);
}

TEST(Text, LabelsShowABoxForWhatHasNoGlyph) {
  const Box2 box = text_box(sans("ж"));
  EXPECT_EQ(box, (Box2{{3.0 / 21, 0.0}, {13.0 / 21, 1.0}}));
  EXPECT_EQ(text_box(sans("\xFF")), box);
  EXPECT_EQ(recorded(sans("\xFF\xC3жI")).paths().size(), 4U);
}

TEST(Text, LineEndsOfAllSystemsAreOne) {
  const auto text = [](std::string_view json) {
    const testing::ReadParams read = testing::read_params("text", json);
    EXPECT_TRUE(read.params.has_value()) << problems_text(read.problems);
    return std::any_cast<TextParams>(*read.params).text.text;
  };
  EXPECT_EQ(text(R"({"text": "a\r\nb\rc\nd\r"})"), "a\nb\nc\nd\n");
  EXPECT_EQ(text(R"({"text": "{{a}} {{{{b}}}}"})"), "{a} {{b}}");
}

TEST(Text, RefusesWhatItCannotDraw) {
  const std::string known =
      "; there are the letters of ASCII and Latin-1, accented ones of Latin Extended-A and common marks\n";
  EXPECT_EQ(complaint(R"({"text": "é\nab ж"})"), "'text': no glyph for 'ж' (U+0436), character 4 of line 2" + known);
  EXPECT_EQ(complaint(R"({"text": "\t"})"), "'text': no glyph for (U+0009), character 1 of line 1" + known);
  EXPECT_EQ(complaint(R"({"text": ""})"), "'text': the text has no letter to draw\n");
  EXPECT_EQ(complaint(R"({"text": " \r\n "})"), "'text': the text has no letter to draw\n");
  EXPECT_EQ(complaint(R"({"text": 3})"), "'text': expected a text, found a whole number\n");
  EXPECT_EQ(complaint(R"({})"), "a text needs 'text': what is written\n");
  EXPECT_EQ(complaint(R"({"text": "a", "font": "sanz"})"),
            "'font': 'sanz' is none of the choices; did you mean 'sans'?\n");
  EXPECT_EQ(complaint(R"({"text": "a", "slant": 61})"), "'slant' = 61 is outside [-60, 60]\n");
}

TEST(Text, NamesBytesThatAreNoUtf8) {
  EXPECT_EQ(lettering::undrawable("é\nab\xE9"), "byte 0xE9 is not UTF-8, character 3 of line 2");
  EXPECT_EQ(lettering::undrawable("\xC3"), "byte 0xC3 is not UTF-8, character 1 of line 1");
  EXPECT_EQ(lettering::undrawable("a\nb – ß"), std::nullopt);
}

TEST(Text, RefusesBracesThatAreNoPlaceholders) {
  EXPECT_EQ(complaint(R"({"text": "{title}"})"), "'text': unknown placeholder '{title}' ({{ and }} are braces)\n");
  EXPECT_EQ(complaint(R"({"text": "a {"})"), "'text': a '{' without its '}'; write {{ for a brace\n");
  EXPECT_EQ(complaint(R"({"text": "a } b"})"), "'text': a '}' without its '{'; write }} for a brace\n");
  EXPECT_EQ(complaint(R"({"text": "{}"})"), "'text': unknown placeholder '{}' ({{ and }} are braces)\n");
}

}  // namespace
}  // namespace burin::curves
