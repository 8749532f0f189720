#include <gtest/gtest.h>

#include <burin/path/recording.hpp>

#include "burin/output/pdf_drawing.hpp"

namespace burin {
namespace {

using test::PdfPainted;
using test::PdfText;
using test::plain_sheet;
using test::steps;

/// A star of 16 points and a filled triangle in its middle; `turn` makes another.
Figure star(double turn = 0.0) {
  Recorder recorder;
  std::vector<Vec2> points;
  for (int i = 0; i < 16; ++i) {
    points.push_back(rotation_degrees(22.5 * i + turn)({i % 2 == 0 ? 2.0 : 1.0, 0.0}));
  }
  (void)test::draw({test::stroke(points, true), test::fill({{{0, 0}, {0.5, 0}, {0, 0.5}}})}, recorder);
  return Figure(recorder.take());
}

struct Placing {
  Affine2 at;
  PathHead head{};
  Figure figure = star();
};

PdfText placed(const std::vector<Placing>& placings, const Sheet& sheet = plain_sheet(2)) {
  StringSink bytes;
  const auto sink = output::open_pdf(bytes, sheet, {});
  for (const Placing& placing : placings) EXPECT_EQ(sink->place(placing.head, placing.figure, placing.at), Flow::go);
  EXPECT_TRUE(sink->finish());
  return {bytes.take(), 0};
}

const Affine2 turned = translation({40, 50}) * rotation_degrees(30) * scaling(3, 3);
const Affine2 mirrored = translation({140, 90}) * scaling(-0.25, 0.25);
const Affine2 squeezed = translation({60, 60}) * scaling(2, 1);

std::size_t forms_in(const PdfText& pdf) {
  const test::PdfFile file = pdf.file();
  return file.dictionary(file.dictionary(file.page(), "Resources"), "XObject").size();
}

void expect_star(const PdfPainted& line, const PdfPainted& middle, const Affine2& at) {
  const Figure figure = star();
  EXPECT_EQ(line.by, "S");
  EXPECT_EQ(middle.by, "f");
  EXPECT_TRUE(line.contours.at(0).closed);
  EXPECT_NEAR(line.style.width, 0.3 * 72.0 / 25.4, 1e-5);
  std::vector<Vec2> read = line.contours.at(0).points;
  read.insert(read.end(), middle.contours.at(0).points.begin(), middle.contours.at(0).points.end());
  const std::vector<Vec2>& points = figure.drawing().all_points();
  ASSERT_EQ(read.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LE(distance(read[i], at(points[i])), 0.00075);
}

TEST(PdfFigure, IsWrittenOnceAndPlacedTrue) {
  const PdfText pdf = placed({{turned}, {mirrored}, {turned}});
  EXPECT_EQ(forms_in(pdf), 1U);
  const std::vector<PdfPainted> painted = pdf.painted();
  ASSERT_EQ(painted.size(), 6U);
  expect_star(painted[0], painted[1], turned);
  expect_star(painted[2], painted[3], mirrored);
  expect_star(painted[4], painted[5], turned);
}

TEST(PdfFigure, IsKnownByItsLooks) {
  EXPECT_EQ(forms_in(placed({{turned}, {turned, {}, star(5.0)}, {mirrored}, {mirrored, {}, star(5.0)}})), 2U);
}

TEST(PdfFigure, ThatChangesItsShapeIsDrawn) {
  const PdfText pdf = placed({{squeezed}});
  EXPECT_EQ(forms_in(pdf), 0U);
  const std::vector<PdfPainted> painted = pdf.painted();
  ASSERT_EQ(painted.size(), 2U);
  expect_star(painted[0], painted[1], squeezed);
}

TEST(PdfFigure, OfFewPointsOrWithADotIsDrawn) {
  Recorder few;
  (void)test::draw({test::stroke({{0, 0}, {1, 1}})}, few);
  Recorder dotted;
  (void)test::draw({test::stroke(test::zigzag(30)), test::stroke({{1, 1}})}, dotted);
  const PdfText pdf = placed({{turned, {}, Figure(few.take())}, {turned, {}, Figure(dotted.take())}});
  EXPECT_EQ(forms_in(pdf), 0U);
  EXPECT_EQ(contours_of(pdf.painted()).size(), 3U);
}

TEST(PdfFigure, OfAPenWiderThanItselfIsDrawn) {
  EXPECT_EQ(forms_in(placed({{translation({50, 50}) * scaling(0.1, 0.1)}})), 0U);
}

TEST(PdfFigure, GoesIntoGroupsAndDashesKeepTheirLengths) {
  Sheet sheet = plain_sheet(2);
  sheet.layers[1].opacity = 0.5;
  sheet.layers[1].dashes_mm = {1, 2};
  const std::vector<PdfPainted> painted = placed({{turned}, {turned, {.layer = 1}}}, sheet).painted();
  ASSERT_EQ(painted.size(), 4U);
  EXPECT_EQ(painted[0].group, 0U);
  EXPECT_EQ(painted[2].group, 1U);
  EXPECT_EQ(painted[2].layer, "2 red 0.8");
  ASSERT_EQ(painted[2].style.dashes.size(), 2U);
  EXPECT_NEAR(painted[2].style.dashes[1], 2.0 * 72.0 / 25.4, 1e-4);
  EXPECT_NEAR(painted[2].style.width, 0.8 * 72.0 / 25.4, 1e-4);
}

TEST(PdfFigure, AsAMaskIsNotDrawn) {
  EXPECT_TRUE(placed({{turned, {.role = Role::mask}}}).painted().empty());
}

TEST(PdfFigure, TooFarAwayIsAProblem) {
  StringSink bytes;
  const Sheet sheet = plain_sheet();
  const auto sink = output::open_pdf(bytes, sheet, {});
  EXPECT_EQ(sink->place({}, star(), translation({2e6, 0})), Flow::stop);
  EXPECT_FALSE(sink->finish());
}

TEST(PdfFigure, ManyTakeLittleMemoryAndRoom) {
  std::vector<Placing> placings;
  for (int i = 0; i < 400; ++i) placings.push_back({turned, {}, star(0.1 * i)});
  EXPECT_EQ(forms_in(placed(placings)), 256U);
}

}  // namespace
}  // namespace burin
