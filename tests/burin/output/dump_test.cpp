#include <gtest/gtest.h>

#include <burin/base/sha256.hpp>
#include <burin/output/dump_writer.hpp>

#include "support/failing_sink.hpp"
#include "support/svg_drawing.hpp"

namespace burin {
namespace {

using test::DrawnPath;
using test::plain_sheet;

std::string dump_of(const Sheet& sheet, const std::vector<DrawnPath>& paths, std::size_t span = SIZE_MAX) {
  StringSink bytes;
  const auto sink = output::open_dump(bytes, sheet, {});
  EXPECT_EQ(test::draw(paths, *sink, span), Flow::go);
  EXPECT_TRUE(sink->finish());
  return bytes.take();
}

TEST(Dump, ShowsTablesAndPathsInMicrometres) {
  Sheet sheet;
  sheet.page = {210, 297, 3, {0xF4, 0xEF, 0xE4}};
  sheet.pens = {{"ink", {}, 0.3}, {"a \"b\"\n\\", {255, 0, 16}, 25.4 / 72.0}};
  sheet.layers.resize(2);
  sheet.layers[0].name = "koch";
  sheet.layers[1].name = "dashes";
  sheet.layers[1].pen = 1;
  sheet.layers[1].paint = Paint::fill_evenodd;
  sheet.layers[1].cap = Cap::butt;
  sheet.layers[1].join = Join::miter;
  sheet.layers[1].dashes_mm = {1, 0.25};
  sheet.layers[1].dash_offset_mm = 0.5;
  sheet.layers[1].opacity = 0.35;
  sheet.made_by = {"title", "author", "summary", "record"};
  const DrawnPath open{{0, Role::ink, Paint::stroke, false, 3}, {{{0, 0}, {1.0004, -2.0006}, {1.0004, -2.0006}}}};
  const DrawnPath rings{{1, Role::ink_and_mask, Paint::fill_evenodd, true}, {{{1, 1}}, {{-0.0001, 2}}}};
  const DrawnPath mask{{1, Role::mask, Paint::fill_nonzero, true}, {{{5, 5}}}};
  EXPECT_EQ(
      dump_of(sheet, {open, rings, mask}),
      "burin dump 1\n"
      "page 210000 297000 bleed 3000 paper #f4efe4\n"
      "pen 1 #000000 300 \"ink\"\n"
      "pen 2 #ff0010 353 \"a \\\"b\\\"\\x0a\\\\\"\n"
      "layer 1 \"koch\" pen 1 stroke cap round join round miter 4 opacity 1\n"
      "layer 2 \"dashes\" pen 2 fill-evenodd cap butt join miter miter 4 opacity 0.35 dashes 1000 250 offset 500\n"
      "path 1 stroke open\n0 0\n1000 -2001\n1000 -2001\n"
      "path 2 fill-evenodd closed ink-and-mask\n1000 1000\ncontour\n0 2000\n"
      "path 2 fill-nonzero closed mask\n5000 5000\n");
}

TEST(Dump, OriginIsNotInIt) {
  Sheet sheet = plain_sheet();
  const std::string before = dump_of(sheet, {});
  sheet.made_by = {"title", "author", "summary", "record"};
  EXPECT_EQ(dump_of(sheet, {}), before);
}

/// A stroke whose dump is a head of 19 bytes and `points` lines of 10.
DrawnPath ten_bytes_a_point(std::size_t points) {
  DrawnPath path;
  path.contours.emplace_back();
  for (std::size_t i = 0; i < points; ++i)
    path.contours[0].push_back({1.0 + 0.001 * static_cast<double>(i % 9000), 10.25});
  for (Vec2& p : path.contours[0]) p.y = 1.025;
  return path;
}

TEST(Dump, AboveItsLimitItHasCountsBoundsAndAHash) {
  const Sheet sheet = plain_sheet(2);
  const std::string tables = dump_of(sheet, {});
  const std::size_t fits = (output::dump_limit_bytes - 19) / 10;
  const std::string small = dump_of(sheet, {ten_bytes_a_point(fits)});
  EXPECT_EQ(small.size(), tables.size() + 19 + 10 * fits);
  EXPECT_LE(small.size() - tables.size(), output::dump_limit_bytes);

  std::string text = "path 1 stroke open\n";
  for (std::size_t i = 0; i <= fits; ++i) text += std::to_string(1000 + i % 9000) + " 1025\n";
  const std::string large = dump_of(sheet, {ten_bytes_a_point(fits + 1)});
  EXPECT_EQ(large, tables + "total 1 paths 1 contours 1 points " + std::to_string(fits + 1) +
                       " bounds 1000 1025 9999 1025\n" + "total 2 paths 0 contours 0 points 0\n" + "paths " +
                       std::to_string(text.size()) + " bytes sha256 " + sha256_hex(text) + "\n");
}

TEST(Dump, ItsHashSeesEveryPoint) {
  const Sheet sheet = plain_sheet();
  DrawnPath path = ten_bytes_a_point(300'000);
  const std::string before = dump_of(sheet, {path});
  EXPECT_EQ(dump_of(sheet, {path}, 1), before);
  for (const std::size_t changed : {std::size_t{1}, std::size_t{150'000}, std::size_t{299'998}}) {
    DrawnPath other = path;
    std::swap(other.contours[0][changed], other.contours[0][changed + 1]);
    EXPECT_NE(dump_of(sheet, {other}), before) << changed;
  }
}

TEST(Dump, CoordinatesBeyondAllPagesAreAProblem) {
  StringSink bytes;
  const Sheet sheet = plain_sheet();
  const auto sink = output::open_dump(bytes, sheet, {});
  EXPECT_EQ(test::draw({{{0}, {{{0, 0}, {-1e9, 0}}}}}, *sink), Flow::stop);
  const Result<Done> done = sink->finish();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.problems()[0].trouble, Trouble::limit);
}

TEST(Dump, EveryFullDiskIsReported) {
  const Sheet sheet = plain_sheet(2);
  const std::vector<DrawnPath> paths = test::random_paths(14, 2, 30);
  const std::string whole = dump_of(sheet, paths);
  for (std::size_t room = 0; room < whole.size(); room += 1 + whole.size() / 53) {
    test::FailingSink disk(room);
    const auto sink = output::open_dump(disk, sheet, {});
    (void)test::draw(paths, *sink);
    const Result<Done> done = sink->finish();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.problems()[0].trouble, Trouble::output);
    EXPECT_EQ(disk.writes_after_failure(), 0U);
  }
}

}  // namespace
}  // namespace burin
