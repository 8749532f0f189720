#include <gtest/gtest.h>

#include <burin/output/back_ends.hpp>

#include "support/svg_drawing.hpp"

namespace burin {
namespace {

TEST(BackEnds, AreSvgCsvAndDump) {
  const std::span<const BackEnd> rows = output::back_ends();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].format, "svg");
  EXPECT_EQ(rows[1].format, "csv");
  EXPECT_EQ(rows[2].format, "dump");
  EXPECT_EQ(rows[0].space, Space::page);
  EXPECT_EQ(rows[1].space, Space::model);
  EXPECT_EQ(rows[2].space, Space::page);
  for (const BackEnd& row : rows) {
    EXPECT_EQ(row.name, "native");
    EXPECT_FALSE(row.binary);
    EXPECT_FALSE(row.summary.empty());
  }
}

TEST(BackEnds, ToleranceIsHalfOfTheLastDecimalThatShows) {
  const std::span<const BackEnd> rows = output::back_ends();
  OutputOptions options;
  EXPECT_DOUBLE_EQ(rows[0].tolerance_mm(options), 0.0005);
  options.decimals = 0;
  EXPECT_DOUBLE_EQ(rows[0].tolerance_mm(options), 0.5);
  EXPECT_EQ(rows[1].tolerance_mm(options), 0.0);
  EXPECT_EQ(rows[2].tolerance_mm(options), 0.0);
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
