#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/failing_sink.hpp"
#include "support/svg_drawing.hpp"

namespace burin {
namespace {

using test::DrawnPath;
using test::plain_sheet;
using test::ReadContour;
using test::svg_of;

/// The text of the paths of the only layer.
std::vector<std::string> data_of(const std::string& svg) {
  const test::XmlElement root = test::read_xml(svg);
  std::vector<std::string> data;
  for (const test::XmlElement& path : test::layers_of(root).at(0)->children) data.push_back(path.at("d"));
  return data;
}

DrawnPath stroke(std::vector<Vec2> points, bool closed = false) {
  DrawnPath path;
  path.head.closed = closed;
  path.contours = {std::move(points)};
  return path;
}

/// A stroke with a segment between each of its points.
std::vector<Vec2> zigzag(std::size_t points) {
  std::vector<Vec2> zigzag;
  for (std::size_t i = 0; i < points; ++i) {
    zigzag.push_back({0.001 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 0.5});
  }
  return zigzag;
}

double half_unit(int decimals) {
  return 0.5 * std::pow(10.0, -decimals);
}

TEST(SvgPath, IsShort) {
  const auto data = [](std::vector<Vec2> points, bool closed = false) {
    return data_of(svg_of(plain_sheet(), {stroke(std::move(points), closed)}).text).at(0);
  };
  EXPECT_EQ(data({{10, 20}, {10.5, 20.25}}), "m10 20 .5.25");
  EXPECT_EQ(data({{-0.5, -0.25}, {0, 0}}), "m-.5-.25.5.25");
  EXPECT_EQ(data({{0, 0}, {1, 2}, {1.5, 3}, {1, 3.5}}), "m0 0 1 2 .5 1-.5.5");
  EXPECT_EQ(data({{0, 0}, {1, 0}, {3, 0}, {3, -2}, {3, 1}, {2, 2}}), "m0 0h1 2v-2 3l-1 1");
  EXPECT_EQ(data({{0, 0}, {1, 0}, {1, 1}}, true), "m0 0h1v1z");
  EXPECT_EQ(data({{1.5, 1.5}, {2.005, 2.05}, {12345.678, -9876.5}}), "m1.5 1.5.505.55 12343.673-9878.55");
}

TEST(SvgPath, ManyStrokesShareAnElementByRelativeMoves) {
  const auto svg = svg_of(
      plain_sheet(), {stroke({{1, 1}, {2, 1}, {2, 2}}, true), stroke({{1, 5}, {1.5, 6}}), stroke({{1, 5}, {2, 6}})});
  EXPECT_EQ(data_of(svg.text), std::vector<std::string>{"m1 1h1v1zm0 4 .5 1m-.5-1 1 1"});
}

TEST(SvgPath, RoundedZeroHasNoSign) {
  const auto svg = svg_of(plain_sheet(), {stroke({{-0.0004, -0.0}, {-0.0001, 1}, {0.0004, 1.0004}})});
  EXPECT_EQ(data_of(svg.text).at(0), "m0 0v1");
  EXPECT_EQ(svg.skipped, 1U);
}

/// Every coordinate within half a unit, every contour and its closing there, for all numbers of decimals.
class SvgPathRandom : public testing::TestWithParam<int> {};

TEST_P(SvgPathRandom, ReadsBackWithinHalfAUnit) {
  const int decimals = GetParam();
  OutputOptions options;
  options.decimals = decimals;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Sheet sheet = plain_sheet(3);
    const std::vector<DrawnPath> paths = test::random_paths(seed, 3, 60);
    const auto svg = svg_of(sheet, paths, options);
    const test::XmlElement root = test::read_xml(svg.text);

    std::vector<std::vector<ReadContour>> got(3);
    for (std::size_t layer = 0; layer < 3; ++layer) {
      for (const test::XmlElement& path : test::layers_of(root).at(layer)->children) {
        for (ReadContour& contour : test::read_path_data(path.at("d"))) got[layer].push_back(std::move(contour));
      }
    }
    // A half of the last decimal, and what adding a thousand exact decimals in binary may lose.
    const double tolerance = half_unit(decimals) + 1e-8;
    std::vector<std::size_t> next(3, 0);
    std::uint64_t skipped = 0;
    for (const DrawnPath& path : paths) {
      for (const std::vector<Vec2>& points : path.contours) {
        const ReadContour& contour = got[path.head.layer].at(next[path.head.layer]++);
        std::size_t at = 0;
        const auto shows = [&](std::size_t k, Vec2 p) {
          return k < contour.points.size() && std::abs(contour.points[k].x - p.x) <= tolerance &&
                 std::abs(contour.points[k].y - p.y) <= tolerance;
        };
        ASSERT_TRUE(shows(0, points.front()));
        for (std::size_t i = 1; i < points.size(); ++i) {
          // On to the next point of the file, unless this one rounds onto its predecessor.
          const bool moved = shows(at + 1, points[i]);
          ASSERT_TRUE(moved || shows(at, points[i])) << "point " << i;
          if (moved) ++at;
        }
        const bool dot = contour.points.size() == 2 && contour.points[0] == contour.points[1];
        if (!dot) {
          EXPECT_EQ(at + 1, contour.points.size());
          EXPECT_EQ(contour.closed, path.head.closed);
        }
        skipped += points.size() - (dot ? 1 : contour.points.size());
      }
    }
    for (std::size_t layer = 0; layer < 3; ++layer) EXPECT_EQ(next[layer], got[layer].size());
    EXPECT_EQ(svg.skipped, skipped);
  }
}

INSTANTIATE_TEST_SUITE_P(Decimals, SvgPathRandom, testing::Range(0, 7));

TEST(SvgPath, BytesDoNotDependOnSpans) {
  const std::vector<DrawnPath> paths = test::random_paths(7, 2, 80);
  const Sheet sheet = plain_sheet(2);
  const std::string whole = svg_of(sheet, paths).text;
  for (const std::size_t span : {1U, 2U, 7U, 999U, 1000U, 1001U, 1024U}) {
    EXPECT_EQ(svg_of(sheet, paths, {}, span).text, whole) << span;
  }
}

TEST(SvgPath, ErrorsDoNotAddUp) {
  // A million steps of a third of a unit: the end is still within half a unit.
  std::vector<Vec2> points;
  for (int i = 0; i <= 1'000'000; ++i) points.push_back({i / 3000.0, i / 7000.0});
  const auto svg = svg_of(plain_sheet(), {stroke(points)});
  const auto data = data_of(svg.text);
  const Vec2 last = test::read_path_data(data.back()).back().points.back();
  EXPECT_NEAR(last.x, points.back().x, 0.0005 + 1e-8);
  EXPECT_NEAR(last.y, points.back().y, 0.0005 + 1e-8);
}

TEST(SvgPath, KochCurveTakesFewBytes) {
  // Order 8 of 160 mm / 9 long: the segments of order 10 of 160 mm.
  std::vector<Vec2> points{{25, 120}};
  const auto koch = [&](const auto& self, Vec2 a, Vec2 b, int order) -> void {
    if (order == 0) {
      points.push_back(b);
      return;
    }
    const Vec2 third = (1.0 / 3.0) * (b - a);
    const Vec2 top = a + third + complex_product(third, {0.5, 0.5 * std::sqrt(3.0)});
    self(self, a, a + third, order - 1);
    self(self, a + third, top, order - 1);
    self(self, top, b - third, order - 1);
    self(self, b - third, b, order - 1);
  };
  koch(koch, {25, 120}, {25 + 160.0 / 9.0, 120}, 8);
  const auto svg = svg_of(plain_sheet(), {stroke(points)});
  EXPECT_EQ(svg.skipped, 0U);
  EXPECT_LE(static_cast<double>(svg.text.size()), 8.5 * static_cast<double>(points.size() - 1));
}

TEST(SvgPath, PacksShortStrokesUpToAThousandSegments) {
  std::vector<DrawnPath> paths;
  for (int i = 0; i < 999; ++i) paths.push_back(stroke({{0, 0.1 * i}, {1, 0.1 * i + 0.5}, {2, 0.1 * i}}));
  const auto data = data_of(svg_of(plain_sheet(), paths).text);
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(test::segment_count(test::read_path_data(data[0])), 1000U);
  EXPECT_EQ(test::segment_count(test::read_path_data(data[1])), 998U);
}

TEST(SvgPath, KeepsStrokesWholeWhenPacking) {
  // 600 + 600 do not fit together; 400 fits behind 600.
  const auto data =
      data_of(svg_of(plain_sheet(), {stroke(zigzag(601)), stroke(zigzag(601)), stroke(zigzag(401))}).text);
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(test::read_path_data(data[0]).size(), 1U);
  EXPECT_EQ(test::read_path_data(data[1]).size(), 2U);
}

TEST(SvgPath, LongStrokesHaveAnElementOfTheirOwn) {
  for (const std::size_t segments : {999U, 1000U, 1001U, 2000U, 29'999U, 30'000U}) {
    SCOPED_TRACE(segments);
    const auto data = data_of(
        svg_of(plain_sheet(), {stroke({{0, 9}, {1, 8}}), stroke(zigzag(segments + 1)), stroke({{0, 9}, {1, 8}})}).text);
    if (segments == 999) {  // fits behind the first
      ASSERT_EQ(data.size(), 2U);
      continue;
    }
    ASSERT_EQ(data.size(), 3U);
    const auto contours = test::read_path_data(data[1]);
    ASSERT_EQ(contours.size(), 1U);
    EXPECT_EQ(contours[0].points.size(), segments + 1);
  }
}

TEST(SvgPath, CutsAStrokeAfterThirtyThousandSegments) {
  const std::vector<Vec2> points = zigzag(70'001);
  const auto data = data_of(svg_of(plain_sheet(), {stroke(points)}).text);
  ASSERT_EQ(data.size(), 3U);
  std::size_t at = 0;
  for (const std::string& part : data) {
    const auto contours = test::read_path_data(part);
    ASSERT_EQ(contours.size(), 1U);
    EXPECT_FALSE(contours[0].closed);
    for (std::size_t i = 0; i < contours[0].points.size(); ++i) {
      EXPECT_NEAR(distance(contours[0].points[i], points[at + i]), 0.0, 1e-8);
    }
    at += contours[0].points.size() - 1;
  }
  EXPECT_EQ(at, 70'000U);
}

TEST(SvgPath, LongFilesRestWhereLibxml2EmptiesItsBuffer) {
  // Without these lines librsvg gives up at random on files of more than 10 MB.
  std::vector<Vec2> zigzag;
  for (int i = 0; i < 800'000; ++i) zigzag.push_back({100.0 + 0.0001 * i, i % 2 == 0 ? 10.0 : 20.123});
  const std::string text = svg_of(plain_sheet(), {stroke(zigzag)}).text;
  const std::string rest = '\n' + std::string(4096, ' ') + '\n';
  std::size_t before = 0;
  int rests = 0;
  for (std::size_t at = text.find(rest); at != std::string::npos; at = text.find(rest, at + 1)) {
    EXPECT_LT(at - before, 2'500'000U);
    before = at;
    ++rests;
  }
  EXPECT_LT(text.size() - before, 2'500'000U);
  EXPECT_GT(rests, 1);
}

TEST(SvgPath, AClosedStrokeThatIsCutReturnsByALine) {
  const std::vector<Vec2> points = zigzag(40'000);
  const auto data = data_of(svg_of(plain_sheet(), {stroke(points, true)}).text);
  ASSERT_EQ(data.size(), 2U);
  for (const std::string& part : data) EXPECT_FALSE(test::read_path_data(part).at(0).closed);
  const auto last = test::read_path_data(data[1]).at(0).points;
  EXPECT_EQ(last.size(), 10'001U);
  EXPECT_NEAR(distance(last.back(), points.front()), 0.0, 1e-8);
}

TEST(SvgPath, ACutAtTheEndLeavesNoDotBehind) {
  std::vector<Vec2> points = zigzag(30'001);
  points.push_back(points.back());
  points.push_back(points.back());
  const auto svg = svg_of(plain_sheet(), {stroke(points)});
  EXPECT_EQ(data_of(svg.text).size(), 1U);
  EXPECT_EQ(svg.skipped, 2U);

  points.push_back(points.front());  // back at the start: nothing is left to close
  EXPECT_EQ(data_of(svg_of(plain_sheet(), {stroke(points, true)}).text).size(), 2U);
}

TEST(SvgPath, StrokesWhoseCutWouldShowStayWholeUpToTheLimitOfLibrsvg) {
  const std::vector<Vec2> points = zigzag(70'001);
  const auto parts = [&](auto&& change) {
    Sheet sheet = plain_sheet();
    change(sheet.layers[0]);
    return data_of(svg_of(sheet, {stroke(points)}).text).size();
  };
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.join = Join::miter; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.join = Join::bevel; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.cap = Cap::butt; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.dashes_mm = {1, 2}; }), 1U);
  EXPECT_EQ(parts([](SheetLayer& layer) { layer.opacity = 0.5; }), 3U);

  std::vector<Vec2> wide;
  for (int i = 0; i < 900'000; ++i) wide.push_back({i % 2 == 0 ? -111.111 : 8888.887, 0.001 * i});
  Sheet sheet = plain_sheet();
  sheet.layers[0].join = Join::miter;
  const auto data = data_of(svg_of(sheet, {stroke(wide)}).text);
  ASSERT_EQ(data.size(), 2U);
  for (const std::string& part : data) EXPECT_LT(part.size(), 10'000'000U);
  EXPECT_GT(data[0].size(), 6'900'000U);  // and leaves room for what is read before it
}

TEST(SvgPath, FillsAreNeverCutOrPacked) {
  DrawnPath fill;
  fill.head = {0, Role::ink, Paint::fill_evenodd, true, 0};
  fill.contours = {zigzag(40'000), {{5, 5}, {6, 5}, {6, 6}}, zigzag(2000)};
  Sheet sheet = plain_sheet();
  sheet.layers[0].paint = Paint::fill_evenodd;
  const auto data = data_of(svg_of(sheet, {fill, fill}).text);
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(data[0], data[1]);
  const auto contours = test::read_path_data(data[0]);
  ASSERT_EQ(contours.size(), 3U);
  EXPECT_EQ(contours[0].points.size(), 40'000U);
  EXPECT_EQ(contours[1].points.size(), 3U);
  for (const ReadContour& contour : contours) EXPECT_TRUE(contour.closed);
}

TEST(SvgPath, ADotStaysADot) {
  DrawnPath two_contours;
  two_contours.contours = {{{1, 1}}, {{3, 1}, {3.0001, 1}}};
  const auto svg =
      svg_of(plain_sheet(), {stroke({{5, 5}}), stroke({{6, 5}, {6.0002, 5}, {5.9999, 5}}, true), two_contours});
  EXPECT_EQ(data_of(svg.text), std::vector<std::string>{"m5 5h0m1 0h0m-5-4h0m2 0h0"});
  EXPECT_EQ(svg.skipped, 3U);
}

TEST(SvgPath, MasksAreNotDrawn) {
  DrawnPath mask = stroke({{0, 0}, {1, 1}});
  mask.head.role = Role::mask;
  DrawnPath both = stroke({{2, 2}, {3, 4}});
  both.head.role = Role::ink_and_mask;
  const auto svg = svg_of(plain_sheet(), {mask, both, mask});
  EXPECT_EQ(data_of(svg.text), std::vector<std::string>{"m2 2 1 2"});
}

TEST(SvgPath, LargeCoordinatesAreExact) {
  OutputOptions options;
  options.decimals = 6;
  const double big = 999'999'999.0;
  const auto svg = svg_of(plain_sheet(), {stroke({{-big, big}, {big, -big}, {big, 0.000001}})}, options);
  EXPECT_EQ(data_of(svg.text).at(0), "m-999999999 999999999 1999999998-1999999998v999999999.000001");
}

TEST(SvgPath, CoordinatesBeyondAllPagesAreAProblem) {
  for (const double bad :
       {1e9, -1e9, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (const Vec2 p : {Vec2{bad, 0}, Vec2{0, bad}}) {
      StringSink bytes;
      const Sheet sheet = plain_sheet();
      const auto sink = output::open_svg(bytes, sheet, {});
      EXPECT_EQ(test::draw({stroke({{0, 0}, {1, 1}, p, {2, 2}})}, *sink), Flow::stop);
      const Result<Done> done = sink->finish();
      ASSERT_FALSE(done);
      EXPECT_EQ(done.problems()[0].trouble, Trouble::limit);
      EXPECT_NE(done.problems()[0].message.find("scale"), std::string::npos);
    }
  }
}

TEST(SvgPath, SkippedPointsAreCounted) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 1000; ++i) points.push_back({i * 0.0001, 0});
  // 0, 0.001 ... 0.1 are 100 segments of 1000.
  const auto svg = svg_of(plain_sheet(), {stroke(points)});
  EXPECT_EQ(svg.skipped, 900U);
  EXPECT_EQ(test::segment_count(test::read_path_data(data_of(svg.text).at(0))), 100U);
}

TEST(SvgPath, EveryFullDiskIsReported) {
  const Sheet sheet = plain_sheet(3);
  const std::vector<DrawnPath> paths = test::random_paths(3, 3, 120);
  const std::string whole = svg_of(sheet, paths).text;
  ASSERT_GT(whole.size(), 200'000U);  // several blocks
  for (std::size_t room = 0; room < whole.size(); room += 1 + whole.size() / 97) {
    test::FailingSink disk(room);
    const auto sink = output::open_svg(disk, sheet, {});
    const Flow flow = test::draw(paths, *sink);
    EXPECT_EQ(flow == Flow::stop, disk.failed());
    const Result<Done> done = sink->finish();
    ASSERT_FALSE(done) << room;
    EXPECT_EQ(done.problems()[0].trouble, Trouble::output);
    EXPECT_NE(done.problems()[0].message.find("No space left on device"), std::string::npos);
    EXPECT_EQ(disk.writes_after_failure(), 0U);
    EXPECT_EQ(disk.text(), whole.substr(0, room));
  }
  test::FailingSink roomy(whole.size());
  const auto sink = output::open_svg(roomy, sheet, {});
  EXPECT_EQ(test::draw(paths, *sink), Flow::go);
  EXPECT_TRUE(sink->finish());
}

TEST(SvgPath, AFailureEndsTheDrawingEarly) {
  test::FailingSink disk(0);
  const Sheet sheet = plain_sheet();
  const auto sink = output::open_svg(disk, sheet, {});
  const std::vector<Vec2> points = zigzag(1000);
  ASSERT_EQ(sink->begin({}), Flow::go);
  int spans = 0;
  while (spans < 1000 && sink->points(points) == Flow::go) ++spans;
  EXPECT_LT(spans, 30);
  EXPECT_FALSE(sink->finish());
}

}  // namespace
}  // namespace burin
