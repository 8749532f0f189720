#include <charconv>
#include <sstream>

#include <gtest/gtest.h>

#include <burin/output/csv_writer.hpp>

#include "support/failing_sink.hpp"
#include "support/svg_drawing.hpp"

namespace burin {
namespace {

using test::DrawnPath;
using test::plain_sheet;

std::string csv_of(const Sheet& sheet, const std::vector<DrawnPath>& paths, std::size_t span = SIZE_MAX) {
  StringSink bytes;
  const auto sink = output::open_csv(bytes, sheet, {});
  EXPECT_EQ(test::draw(paths, *sink, span), Flow::go);
  EXPECT_TRUE(sink->finish());
  return bytes.take();
}

TEST(Csv, HasARowForEachVertex) {
  Sheet sheet = plain_sheet(3);
  sheet.layers[0].name = "koch";
  sheet.layers[1].name = "leaves, \"big\"";
  sheet.layers[2].name = "two\nlines";
  DrawnPath ring{{0, Role::ink, Paint::stroke, true}, {{{0, 0}, {1, 0}, {0.5, 1.25}}, {{-0.0, 3e-7}}}};
  const DrawnPath open{{0}, {{{1e300, -2}, {1.0 / 3.0, 0.1}}}};
  DrawnPath leaf{{1}, {{{4, 5}}}};
  DrawnPath mask{{1, Role::mask}, {{{7, 7}}}};
  const DrawnPath last{{2}, {{{6, 7}}}};
  EXPECT_EQ(csv_of(sheet, {ring, open, mask, leaf, leaf, last}),
            "layer,path,x,y\n"
            "koch,0,0,0\nkoch,0,1,0\nkoch,0,0.5,1.25\nkoch,0,0,0\n"
            "koch,1,0,3e-07\nkoch,1,0,3e-07\n"
            "koch,2,1e+300,-2\nkoch,2,0.3333333333333333,0.1\n"
            "\"leaves, \"\"big\"\"\",0,4,5\n\"leaves, \"\"big\"\"\",1,4,5\n"
            "\"two\nlines\",0,6,7\n");
}

TEST(Csv, LayersOfOneNameCountOn) {
  Sheet sheet = plain_sheet(3);
  sheet.layers[2].name = sheet.layers[0].name;
  EXPECT_EQ(csv_of(sheet, {{{0}, {{{1, 1}}}}, {{1}, {{{2, 2}}}}, {{2}, {{{3, 3}}}}}),
            "layer,path,x,y\nlayer 0,0,1,1\nlayer 1,0,2,2\nlayer 0,1,3,3\n");
}

TEST(Csv, NumbersReadBackExactly) {
  const std::vector<DrawnPath> paths = test::random_paths(11, 1, 40);
  std::istringstream lines(csv_of(plain_sheet(), paths));
  std::string line;
  std::getline(lines, line);
  const auto expect_row = [&](std::size_t path, Vec2 p) {
    ASSERT_TRUE(std::getline(lines, line));
    Vec2 read;
    const std::string begin = "layer 0," + std::to_string(path) + ",";
    ASSERT_TRUE(line.starts_with(begin)) << line;
    const char* const end = line.data() + line.size();
    const char* const comma = std::from_chars(line.data() + begin.size(), end, read.x).ptr;
    EXPECT_EQ(*comma, ',');
    EXPECT_EQ(std::from_chars(comma + 1, end, read.y).ptr, end);
    EXPECT_EQ(read, p);
  };
  std::size_t number = 0;
  for (const DrawnPath& path : paths) {
    for (const std::vector<Vec2>& points : path.contours) {
      for (const Vec2 p : points) expect_row(number, p);
      if (path.head.closed) expect_row(number, points.front());
      ++number;
    }
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(Csv, BytesDoNotDependOnSpans) {
  const std::vector<DrawnPath> paths = test::random_paths(12, 2, 40);
  const std::string whole = csv_of(plain_sheet(2), paths);
  for (const std::size_t span : {1U, 3U, 1000U}) EXPECT_EQ(csv_of(plain_sheet(2), paths, span), whole);
}

TEST(Csv, EveryFullDiskIsReported) {
  const Sheet sheet = plain_sheet(2);
  const std::vector<DrawnPath> paths = test::random_paths(13, 2, 30);
  const std::string whole = csv_of(sheet, paths);
  for (std::size_t room = 0; room < whole.size(); room += 1 + whole.size() / 53) {
    test::FailingSink disk(room);
    const auto sink = output::open_csv(disk, sheet, {});
    const Flow flow = test::draw(paths, *sink);
    EXPECT_EQ(flow == Flow::stop, disk.failed());
    const Result<Done> done = sink->finish();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.problems()[0].trouble, Trouble::output);
    EXPECT_EQ(disk.writes_after_failure(), 0U);
  }
}

}  // namespace
}  // namespace burin
