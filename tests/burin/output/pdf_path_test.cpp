#include <limits>

#include <gtest/gtest.h>

#include <burin/output/fixed_point.hpp>

#include "burin/output/pdf_drawing.hpp"
#include "support/failing_sink.hpp"

namespace burin {
namespace {

using test::contours_of;
using test::DrawnPath;
using test::fill;
using test::pdf_of;
using test::PdfContour;
using test::PdfPainted;
using test::plain_sheet;
using test::steps;
using test::stroke;
using test::zigzag;

/// What a contour is on the grid: each point but those that fall onto the one before.
std::vector<std::pair<long long, long long>> on_grid(const std::vector<Vec2>& points, int decimals) {
  const output::Grid grid(decimals);
  std::vector<std::pair<long long, long long>> all;
  for (const Vec2 p : points) {
    const output::GridPoint g = grid(p);
    if (all.empty() || all.back() != std::pair<long long, long long>(g.x, g.y)) all.emplace_back(g.x, g.y);
  }
  return all;
}

/// Every contour point for point on the grid of every number of decimals, and whether it is closed.
class PdfPathRandom : public testing::TestWithParam<int> {};

TEST_P(PdfPathRandom, ReadsBackOnTheGrid) {
  const int decimals = GetParam();
  OutputOptions options;
  options.decimals = decimals;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    Sheet sheet = plain_sheet(3);
    for (SheetLayer& layer : sheet.layers) layer.join = Join::miter;  // no stroke is cut
    sheet.layers[2].opacity = 0.5;
    const std::vector<DrawnPath> paths = test::random_paths(seed, 3, 40);
    const test::PdfText pdf = pdf_of(sheet, paths, options);
    const std::vector<PdfContour> got = contours_of(pdf.painted());
    std::size_t next = 0;
    std::uint64_t skipped = 0;
    for (const DrawnPath& path : paths) {
      for (const std::vector<Vec2>& points : path.contours) {
        auto expected = on_grid(points, decimals);
        skipped += points.size() - expected.size();
        const bool dot = expected.size() == 1;
        if (dot && path.head.paint != Paint::stroke) continue;
        if (dot) expected.push_back(expected.front());
        const PdfContour& contour = got.at(next++);
        std::vector<std::pair<long long, long long>> read;
        for (const Vec2 p : contour.points) read.push_back(steps(p, decimals));
        ASSERT_EQ(read.size(), expected.size());
        // The page's own matrix has nine decimals: at a metre, as much as a nanometre.
        const long long most = decimals == 6 ? 1 : 0;
        for (std::size_t i = 0; i < read.size(); ++i) {
          ASSERT_LE(std::abs(read[i].first - expected[i].first), most) << i;
          ASSERT_LE(std::abs(read[i].second - expected[i].second), most) << i;
        }
        EXPECT_EQ(contour.closed, path.head.closed && !dot);
      }
    }
    EXPECT_EQ(next, got.size());
    EXPECT_EQ(pdf.skipped, skipped);
  }
}

INSTANTIATE_TEST_SUITE_P(Decimals, PdfPathRandom, testing::Range(0, 7));

TEST(PdfPath, BytesDoNotDependOnSpans) {
  const std::vector<DrawnPath> paths = test::random_paths(7, 2, 80);
  Sheet sheet = plain_sheet(2);
  sheet.layers[1].opacity = 0.25;
  const std::string whole = pdf_of(sheet, paths).bytes;
  EXPECT_EQ(pdf_of(sheet, paths).bytes, whole);
  for (const std::size_t span : {1U, 2U, 7U, 999U, 1000U, 1001U, 1024U}) {
    EXPECT_EQ(pdf_of(sheet, paths, {}, span).bytes, whole) << span;
  }
}

TEST(PdfPath, CutsAStrokeAfterAThousandSegments) {
  const std::vector<Vec2> points = zigzag(2501);
  const std::vector<PdfPainted> painted = pdf_of(plain_sheet(), {stroke(points)}).painted();
  ASSERT_EQ(painted.size(), 3U);
  std::size_t at = 0;
  for (const PdfPainted& piece : painted) {
    ASSERT_EQ(piece.contours.size(), 1U);
    EXPECT_FALSE(piece.contours[0].closed);
    EXPECT_EQ(piece.by, "S");
    for (std::size_t i = 0; i < piece.contours[0].points.size(); ++i) {
      ASSERT_EQ(steps(piece.contours[0].points[i]), steps(points[at + i]));
    }
    at += piece.contours[0].points.size() - 1;
  }
  EXPECT_EQ(at, 2500U);
}

TEST(PdfPath, AClosedStrokeThatIsCutReturnsByALine) {
  const std::vector<Vec2> points = zigzag(1500);
  const std::vector<PdfContour> got = contours_of(pdf_of(plain_sheet(), {stroke(points, true)}).painted());
  ASSERT_EQ(got.size(), 2U);
  EXPECT_FALSE(got[0].closed || got[1].closed);
  EXPECT_EQ(steps(got[1].points.back()), steps(points.front()));
  EXPECT_EQ(got[0].points.size() + got[1].points.size(), 1502U);
}

TEST(PdfPath, ACutAtTheEndLeavesNoDotBehind) {
  std::vector<Vec2> points = zigzag(1001);
  points.push_back(points.back());
  points.push_back(points.back());
  const test::PdfText pdf = pdf_of(plain_sheet(), {stroke(points), stroke({{50, 50}, {51, 50}})});
  EXPECT_EQ(pdf.painted().size(), 2U);
  EXPECT_EQ(pdf.skipped, 2U);
}

TEST(PdfPath, StrokesWhoseCutWouldShowStayWhole) {
  const std::vector<Vec2> points = zigzag(70'001);
  const auto parts = [&](auto&& change) {
    Sheet sheet = plain_sheet();
    change(sheet.layers[0]);
    return pdf_of(sheet, {stroke(points)}).painted().size();
  };
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.join = Join::miter; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.join = Join::bevel; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.cap = Cap::butt; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.dashes_mm = {1, 2}; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.dashes_mm = {0, 0}; }), 70U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.opacity = 0.5; }), 70U);
}

TEST(PdfPath, NeighboursShareAPieceAndOthersDoNot) {
  const auto pieces = [](double away) {
    return pdf_of(plain_sheet(), {stroke({{10, 10}, {11, 10}}), stroke({{10, 10 + away}, {11, 10 + away}})})
        .painted()
        .size();
  };
  EXPECT_EQ(pieces(1.0), 1U);
  EXPECT_EQ(pieces(100.0), 2U);
}

TEST(PdfPath, FillsAreWholeAndKeepTheirRule) {
  Sheet sheet = plain_sheet();
  sheet.layers[0].paint = Paint::fill_evenodd;
  const DrawnPath even = fill({zigzag(4000), {{5, 5}, {90, 5}, {6, 60}}}, Paint::fill_evenodd);
  const DrawnPath nonzero = fill({{{5, 5}, {6, 5}, {6, 6}}});
  const std::vector<PdfPainted> painted = pdf_of(sheet, {even, even, nonzero, stroke({{1, 1}, {2, 2}})}).painted();
  ASSERT_EQ(painted.size(), 4U);
  EXPECT_EQ(painted[0].by, "f*");
  EXPECT_EQ(painted[1].by, "f*");
  EXPECT_EQ(painted[2].by, "f");
  EXPECT_EQ(painted[3].by, "S");
  ASSERT_EQ(painted[0].contours.size(), 2U);
  EXPECT_EQ(painted[0].contours[0].points.size(), 4000U);
  EXPECT_TRUE(painted[0].contours[0].closed && painted[0].contours[1].closed);
}

TEST(PdfPath, ADotIsALineOfNoLengthWhereEndsAreRound) {
  const test::PdfText pdf = pdf_of(plain_sheet(), {stroke({{5, 6}}), stroke({{6, 5}, {6.0002, 5}}, true)});
  const std::vector<PdfContour> dots = contours_of(pdf.painted());
  ASSERT_EQ(dots.size(), 2U);
  ASSERT_EQ(dots[0].points.size(), 2U);
  EXPECT_EQ(steps(dots[0].points[0]), steps({5, 6}));
  EXPECT_EQ(steps(dots[0].points[1]), steps({5, 6}));
  EXPECT_EQ(pdf.skipped, 1U);
}

TEST(PdfPath, ADotIsASquareWhereEndsAre) {
  Sheet sheet = plain_sheet();
  sheet.layers[0].cap = Cap::square;
  sheet.pens[0].width_mm = 2.0;
  const std::vector<PdfPainted> painted = pdf_of(sheet, {stroke({{5, 6}})}).painted();
  ASSERT_EQ(painted.size(), 1U);
  EXPECT_EQ(painted[0].by, "f");
  EXPECT_EQ(steps(painted[0].contours.at(0).points[0]), steps({4, 5}));
  EXPECT_EQ(steps(painted[0].contours.at(0).points[2]), steps({6, 7}));
}

TEST(PdfPath, ADotIsNothingWhereEndsAreButt) {
  Sheet sheet = plain_sheet();
  sheet.layers[0].cap = Cap::butt;
  EXPECT_TRUE(pdf_of(sheet, {stroke({{5, 6}})}).painted().empty());
}

TEST(PdfPath, ADotOfADashedLayerIsWhole) {
  Sheet sheet = plain_sheet();
  sheet.layers[0].dashes_mm = {1, 2};
  const std::vector<PdfPainted> painted = pdf_of(sheet, {stroke({{5, 6}}), stroke({{5, 6}, {7, 7}})}).painted();
  ASSERT_EQ(painted.size(), 2U);
  EXPECT_TRUE(painted[0].style.dashes.empty());
  EXPECT_EQ(steps(painted[0].contours.at(0).points.at(1)), steps({5, 6}));
  EXPECT_EQ(painted[1].style.dashes.size(), 2U);
}

TEST(PdfPath, MasksAreNotDrawn) {
  DrawnPath mask = stroke({{0, 0}, {1, 1}});
  mask.head.role = Role::mask;
  DrawnPath both = stroke({{2, 2}, {3, 4}});
  both.head.role = Role::ink_and_mask;
  EXPECT_EQ(contours_of(pdf_of(plain_sheet(), {mask, both, mask}).painted()).size(), 1U);
}

TEST(PdfPath, NumbersFitInThirtyTwoBits) {
  OutputOptions options;
  options.decimals = 6;
  const double far = 1e6;
  const std::string text =
      pdf_of(plain_sheet(), {stroke({{-far, far}, {far, -far}, {0.000001, 0.5}})}, options).file().object(1).stream;
  EXPECT_NE(text.find("1 0 0 1 -1000000000 1000000000 cm\n0 0 m\n2000000000 -2000000000 l\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("1000000000.001 -999999500 l\n"), std::string::npos) << text;
}

TEST(PdfPath, CoordinatesBeyondAreAProblem) {
  for (const double bad :
       {1.1e6, -1e9, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (const Vec2 p : {Vec2{bad, 0}, Vec2{0, bad}}) {
      StringSink bytes;
      const Sheet sheet = plain_sheet();
      const auto sink = output::open_pdf(bytes, sheet, {});
      EXPECT_EQ(test::draw({stroke({{0, 0}, {1, 1}, p, {2, 2}})}, *sink), Flow::stop);
      const Result<Done> done = sink->finish();
      ASSERT_FALSE(done);
      EXPECT_EQ(done.problems()[0].trouble, Trouble::limit);
      EXPECT_NE(done.problems()[0].message.find("scale"), std::string::npos);
    }
  }
}

TEST(PdfPath, EveryFullDiskIsReported) {
  Sheet sheet = plain_sheet(3);
  sheet.layers[1].opacity = 0.5;
  const std::vector<DrawnPath> paths = test::random_paths(3, 3, 300);
  const std::string whole = pdf_of(sheet, paths).bytes;
  ASSERT_GT(whole.size(), 200'000U);  // several blocks
  for (std::size_t room = 0; room < whole.size(); room += 1 + whole.size() / 41) {
    test::FailingSink disk(room);
    const auto sink = output::open_pdf(disk, sheet, {});
    (void)test::draw(paths, *sink);
    const Result<Done> done = sink->finish();
    ASSERT_FALSE(done) << room;
    EXPECT_EQ(done.problems()[0].trouble, Trouble::output);
    EXPECT_NE(done.problems()[0].message.find("No space left on device"), std::string::npos);
    EXPECT_EQ(disk.writes_after_failure(), 0U);
    EXPECT_EQ(disk.text(), whole.substr(0, room));
  }
  test::FailingSink roomy(whole.size());
  const auto sink = output::open_pdf(roomy, sheet, {});
  (void)test::draw(paths, *sink);
  EXPECT_TRUE(sink->finish());
}

TEST(PdfPath, AFailureStopsTheDrawing) {
  test::FailingSink disk(0);
  const Sheet sheet = plain_sheet();
  const auto sink = output::open_pdf(disk, sheet, {});
  std::vector<Vec2> noise;
  test::Dice dice(1);
  for (int i = 0; i < 1'000'000; ++i) noise.push_back({dice.between(0, 200), dice.between(0, 200)});
  EXPECT_EQ(test::draw({stroke(noise)}, *sink), Flow::stop);
}

}  // namespace
}  // namespace burin
