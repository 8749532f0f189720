#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/data/svg/paths.hpp>

namespace burin::data {
namespace {

using Contours = std::vector<std::vector<Vec2>>;

std::vector<SvgPath> paths(const std::string& shape, SvgParts parts = SvgParts::all) {
  const Result<SvgDrawing> drawing =
      read_svg("<svg width='20' height='20'><g stroke='red' fill='none'>" + shape + "</g></svg>", "a.svg", 1e-4);
  EXPECT_TRUE(drawing.ok()) << problems_text(drawing.problems());
  return drawing ? svg_paths(*drawing, parts) : std::vector<SvgPath>{};
}

/// Each stroke of one contour.
Contours lines(const std::string& shape) {
  Contours all;
  for (const SvgPath& path : paths(shape)) {
    EXPECT_EQ(path.contours.size(), 1U);
    all.push_back(path.contours.front());
  }
  return all;
}

TEST(SvgPaths, AreasComeBeforeStrokes) {
  const std::vector<SvgPath> both = paths("<rect width='4' height='3' fill='black'/>");
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].paint, SvgPath::Paint::fill_nonzero);
  EXPECT_EQ(both[1].paint, SvgPath::Paint::stroke);
  EXPECT_EQ(paths("<rect width='4' height='3' fill='black'/>", SvgParts::fills).size(), 1U);
  EXPECT_EQ(paths("<rect width='4' height='3' fill='black'/>", SvgParts::outlines).size(), 1U);
}

TEST(SvgPaths, DashesAreCut) {
  EXPECT_EQ(lines("<path d='M0 0H10' stroke-dasharray='3 2'/>"), (Contours{{{0, 0}, {3, 0}}, {{5, 0}, {8, 0}}}));
  EXPECT_EQ(lines("<path d='M0 0H10' stroke-dasharray='3 2' stroke-dashoffset='4'/>"),
            (Contours{{{1, 0}, {4, 0}}, {{6, 0}, {9, 0}}}));
  EXPECT_EQ(lines("<path d='M0 0H4V3' stroke-dasharray='5 9'/>"), (Contours{{{0, 0}, {4, 0}, {4, 1}}}));
}

TEST(SvgPaths, AClosedLineHasNoGapBetweenItsLastDashAndItsFirst) {
  EXPECT_EQ(lines("<path d='M0 0H5V5H0z' stroke-dasharray='8 4'/>"),
            (Contours{{{3, 5}, {0, 5}, {0, 0}, {5, 0}, {5, 3}}}));
  EXPECT_EQ(lines("<path d='M0 0H5V5H0z' stroke-dasharray='6 6'/>").size(), 2U);
}

TEST(SvgPaths, LinesOfTooManyDashesAreLeftWhole) {
  EXPECT_EQ(lines("<path d='M0 0H9e9' stroke-dasharray='0.001'/>"), (Contours{{{0, 0}, {9e9, 0}}}));
}

}  // namespace
}  // namespace burin::data
