#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <burin/output/back_ends.hpp>

#include "support/svg_drawing.hpp"

namespace burin {
namespace {

const BackEnd& row_of(std::string_view format) {
  for (const BackEnd& row : output::back_ends()) {
    if (row.format == format) return row;
  }
  throw std::out_of_range(std::string(format));
}

TEST(BackEnds, AreOnePerFormat) {
  std::set<std::string_view> formats;
  for (const BackEnd& row : output::back_ends()) {
    EXPECT_EQ(row.name, "native");
    EXPECT_FALSE(row.summary.empty());
    EXPECT_TRUE(formats.insert(row.format).second) << row.format;
    EXPECT_EQ(row.space, row.format == "csv" ? Space::model : Space::page) << row.format;
    EXPECT_EQ(row.binary, row.format == "pdf" || row.format == "png") << row.format;
  }
  EXPECT_EQ(output::back_ends().front().format, "svg");
  for (const char* format : {"svg", "pdf", "png", "csv", "dump"}) EXPECT_TRUE(formats.contains(format)) << format;
}

TEST(BackEnds, ToleranceIsHalfOfTheLastDecimalThatShows) {
  OutputOptions options;
  for (const char* format : {"svg", "pdf"}) {
    options.decimals = 3;
    EXPECT_DOUBLE_EQ(row_of(format).tolerance_mm({}, options), 0.0005);
    options.decimals = 0;
    EXPECT_DOUBLE_EQ(row_of(format).tolerance_mm({}, options), 0.5);
  }
  EXPECT_EQ(row_of("csv").tolerance_mm({}, options), 0.0);
  EXPECT_EQ(row_of("dump").tolerance_mm({}, options), 0.0);
}

TEST(BackEnds, PixelsTolerateLessOfThinPens) {
  OutputOptions options;
  options.dots_per_mm = 10.0;
  Sheet sheet;
  const auto in_pixels = [&](double thinnest_mm) {
    sheet.pens = {{"wide", {}, 2.0}, {"thin", {}, thinnest_mm}};
    return 10.0 * row_of("png").tolerance_mm(sheet, options);
  };
  EXPECT_DOUBLE_EQ(in_pixels(1.0), 0.08);
  EXPECT_DOUBLE_EQ(in_pixels(0.05), 0.04);
  EXPECT_DOUBLE_EQ(in_pixels(0.001), 0.02);
}

TEST(BackEnds, EachWritesADrawingAndTheSameTwice) {
  const Sheet sheet = test::plain_sheet(2);
  const std::vector<test::DrawnPath> paths = test::random_paths(5, 2, 20);
  for (const BackEnd& row : output::back_ends()) {
    ASSERT_TRUE(row.accepts(sheet, {})) << row.format;
    std::string texts[2];
    for (std::string& text : texts) {
      StringSink bytes;
      const auto sink = row.open(bytes, sheet, {});
      EXPECT_EQ(test::draw(paths, *sink), Flow::go);
      EXPECT_TRUE(sink->finish());
      text = bytes.take();
    }
    EXPECT_FALSE(texts[0].empty());
    EXPECT_EQ(texts[0], texts[1]) << row.format;
  }
}

}  // namespace
}  // namespace burin
