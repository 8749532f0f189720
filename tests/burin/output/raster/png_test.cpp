#include <gtest/gtest.h>

#include <burin/output/back_ends.hpp>
#include <burin/output/raster/png.hpp>

#include "decoded_png.hpp"
#include "support/failing_sink.hpp"
#include "support/random_paths.hpp"
#include "support/threads.hpp"

namespace burin::test {
namespace {

using output::RasterPlan;

/// 20 x 10 mm of white paper, a black pen of 1 mm in one layer.
Sheet small_sheet() {
  Sheet sheet;
  sheet.page = {.width_mm = 20.0, .height_mm = 10.0};
  sheet.pens = {{.name = "ink", .colour = {0, 0, 0}, .width_mm = 1.0}};
  sheet.layers = {{.name = "line", .pen = 0}};
  return sheet;
}

OutputOptions ten_dots() {
  OutputOptions options;
  options.dots_per_mm = 10.0;
  return options;
}

DrawnPath stroke(std::vector<Vec2> points, LayerId layer = 0) {
  return {{.layer = layer}, {std::move(points)}};
}

std::string drawn(const Sheet& sheet, const std::vector<DrawnPath>& paths, const OutputOptions& options = ten_dots(),
                  const RasterPlan& plan = {}) {
  StringSink bytes;
  const auto sink = output::open_png(bytes, sheet, options, plan);
  do {
    EXPECT_EQ(draw(paths, *sink), Flow::go);
  } while (sink->wants_another_run());
  EXPECT_TRUE(sink->finish());
  return bytes.take();
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<std::uint8_t>(bytes.at(at + k));
  return value;
}

/// The data of all chunks of a type, one after the other.
std::string chunk_data(const std::string& png, std::string_view type) {
  std::string data;
  for (std::size_t at = 8; at < png.size(); at += number_at(png, at) + 12) {
    if (png.compare(at + 4, 4, type) == 0) data += png.substr(at + 8, number_at(png, at));
  }
  return data;
}

/// Bits and colour type of IHDR.
std::string format_of(const std::string& png) {
  return chunk_data(png, "IHDR").substr(8, 2);
}

constexpr char grey = 0;
constexpr char rgb = 2;
constexpr char palette = 3;

const BackEnd& back_end() {
  for (const BackEnd& row : output::back_ends()) {
    if (row.format == "png") return row;
  }
  throw std::logic_error("no png");
}

TEST(NativePng, ShowsALineOnItsPaper) {
  Sheet sheet = small_sheet();
  sheet.page.paper = {250, 240, 230};
  sheet.pens[0].colour = {200, 0, 10};
  const DecodedPng picture = decoded_png(drawn(sheet, {stroke({{2.0, 5.0}, {18.0, 5.0}})}));
  ASSERT_EQ(picture.width, 200);
  ASSERT_EQ(picture.height, 100);
  const auto pixel = [&](int x, int y) {
    const auto at = picture.rgb.begin() + 3 * (y * 200 + x);
    return std::vector<int>(at, at + 3);
  };
  EXPECT_EQ(pixel(0, 0), (std::vector{250, 240, 230}));
  EXPECT_EQ(pixel(100, 44), (std::vector{250, 240, 230}));
  EXPECT_EQ(pixel(100, 45), (std::vector{200, 0, 10}));
  EXPECT_EQ(pixel(100, 54), (std::vector{200, 0, 10}));
  EXPECT_EQ(pixel(100, 55), (std::vector{250, 240, 230}));
}

TEST(NativePng, MixesHalfAPixelHalfAndHalf) {
  const DecodedPng picture = decoded_png(drawn(small_sheet(), {stroke({{2.0, 5.05}, {18.0, 5.05}})}));
  EXPECT_EQ(picture.red(100, 45), 128);  // half of 255, rounded
  EXPECT_EQ(picture.red(100, 50), 0);
  EXPECT_EQ(picture.red(100, 55), 128);
}

TEST(NativePng, LinesOfALayerAreOneUnionAndLayersLieOverEachOther) {
  Sheet sheet = small_sheet();
  sheet.layers[0].opacity = 0.5;
  const std::vector<Vec2> line = {{2.0, 5.0}, {18.0, 5.0}};
  EXPECT_EQ(drawn(sheet, {stroke(line)}), drawn(sheet, {stroke(line), stroke(line), stroke({line[1], line[0]})}));
  EXPECT_EQ(decoded_png(drawn(sheet, {stroke(line)})).red(100, 50), 128);
  sheet.layers.push_back(sheet.layers[0]);
  EXPECT_EQ(decoded_png(drawn(sheet, {stroke(line, 0), stroke(line, 1)})).red(100, 50), 64);
}

TEST(NativePng, FillsByBothRules) {
  const std::vector<std::vector<Vec2>> rings = {{{2, 1}, {18, 1}, {18, 9}, {2, 9}}, {{6, 3}, {14, 3}, {14, 7}, {6, 7}}};
  for (const Paint paint : {Paint::fill_nonzero, Paint::fill_evenodd}) {
    const DecodedPng picture =
        decoded_png(drawn(small_sheet(), {{{.layer = 0, .paint = paint, .closed = true}, rings}}));
    EXPECT_EQ(picture.red(40, 50), 0);
    EXPECT_EQ(picture.red(100, 50), paint == Paint::fill_evenodd ? 255 : 0);
    EXPECT_EQ(picture.red(10, 50), 255);
  }
}

TEST(NativePng, LeavesMasksOut) {
  DrawnPath mask = stroke({{2.0, 5.0}, {18.0, 5.0}});
  mask.head.role = Role::mask;
  EXPECT_EQ(drawn(small_sheet(), {mask}), drawn(small_sheet(), {}));
}

TEST(NativePng, HasTheFormatOfItsColours) {
  Sheet sheet = small_sheet();
  std::vector<DrawnPath> paths;
  for (int k = 0; k < 12; ++k) paths.push_back(stroke({{1.0, 1.0 + 0.6 * k}, {19.0, 8.0 - 0.55 * k}}));
  EXPECT_EQ(format_of(drawn(sheet, paths)), std::string({8, grey}));
  EXPECT_EQ(format_of(drawn(sheet, {})), std::string({1, palette})) << "blank";
  // A level line has few shades.
  EXPECT_EQ(format_of(drawn(sheet, {{{.layer = 0, .paint = Paint::fill_nonzero, .closed = true},
                                     {{{2, 2.02}, {18, 2.02}, {18, 8}, {2, 8}}}}})),
            std::string({2, palette}));
  sheet.pens[0].colour = {200, 30, 30};
  EXPECT_EQ(format_of(drawn(sheet, paths)), std::string({8, palette}));
  // Four inks that lie over each other have more than 256 mixtures.
  sheet.pens[0].width_mm = 0.2;
  for (LayerId layer = 1; layer < 4; ++layer) {
    sheet.pens.push_back({.name = "more", .colour = {0, static_cast<std::uint8_t>(60 * layer), 200}, .width_mm = 0.2});
    sheet.layers.push_back({.name = "more", .pen = layer, .opacity = 0.7});
    for (int k = 0; k < 12; ++k)
      paths.push_back(stroke({{1.0, 1.0 + 0.13 * layer + 0.6 * k}, {19.0, 8.0 - 0.55 * k}}, layer));
  }
  const std::string colours = drawn(sheet, paths);
  EXPECT_EQ(format_of(colours), std::string({8, rgb}));
  EXPECT_EQ(decoded_png(colours).width, 200);
}

TEST(NativePng, SaysItsSizeItsColourSpaceAndItsOrigin) {
  Sheet sheet = small_sheet();
  sheet.made_by = {.title = "Winter card", .author = "Ren\xC3\xA9", .summary = "", .record = "seed = 19\n"};
  const std::string png = drawn(sheet, {stroke({{1.0, 1.0}, {19.0, 9.0}})});
  EXPECT_EQ(chunk_data(png, "sRGB"), std::string(1, '\0'));
  const std::string dots = chunk_data(png, "pHYs");
  EXPECT_EQ(number_at(dots, 0), 10000U);
  EXPECT_EQ(number_at(dots, 4), 10000U);
  EXPECT_EQ(dots[8], 1);  // a metre
  EXPECT_EQ(chunk_data(png, "tEXt"), std::string("Title\0Winter card", 17) + std::string("Author\0Ren\xE9", 11) +
                                         std::string("Software\0burin", 14) + std::string("burin-origin\0", 13) +
                                         "seed = 19\n");
}

/// A sheet of many kinds of lines and fills, larger than a few tiles.
Sheet mixed_sheet() {
  Sheet sheet;
  sheet.page = {.width_mm = 200.0, .height_mm = 300.0, .paper = {244, 239, 228}};
  sheet.pens = {{.name = "ink", .colour = {20, 20, 20}, .width_mm = 0.3},
                {.name = "red", .colour = {200, 30, 30}, .width_mm = 2.0}};
  sheet.layers = {{.name = "a", .pen = 0},
                  {.name = "b", .pen = 1, .cap = Cap::butt, .join = Join::miter, .opacity = 0.6},
                  {.name = "c", .pen = 0, .cap = Cap::square, .join = Join::bevel, .dashes_mm = {3.0, 1.0, 0.5}}};
  return sheet;
}

TEST(NativePng, HasTheSamePixelsInBandsAndWithEveryKernel) {
  const Sheet sheet = mixed_sheet();
  const std::vector<DrawnPath> paths = random_paths(9, 3, 24);
  OutputOptions options;
  options.dots_per_mm = 1.0;
  const std::string whole = drawn(sheet, paths, options);
  EXPECT_EQ(drawn(sheet, paths, options, {.kernel = &output::raster::portable_kernel()}), whole);
  for (const double pixels : {2000.0, 30000.0}) {
    const std::string bands = drawn(sheet, paths, options, {.most_pixels_at_once = 0.0, .pixels_per_band = pixels});
    EXPECT_EQ(decoded_png(bands).rgb, decoded_png(whole).rgb) << pixels;
  }
}

/// Strokes, dashes and fills in three layers, of more points than are kept at once.
std::vector<DrawnPath> many_points() {
  std::vector<DrawnPath> paths = random_paths(10, 3, 24);
  Dice dice(41);
  std::vector<Vec2> line = {{100.0, 150.0}};
  while (line.size() < 100'000) {
    const Vec2 next = line.back() + Vec2{dice.between(-3.0, 3.0), dice.between(-3.0, 3.0)};
    line.push_back(next.x > 0.0 && next.x < 200.0 && next.y > 0.0 && next.y < 300.0 ? next : Vec2{100.0, 150.0});
  }
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    if (path->head.layer != 1) continue;
    paths.insert(path, {{.layer = 1}, {line}});
    break;
  }
  return paths;
}

TEST(NativePng, HasTheSameBytesForAnyNumberOfWorkers) {
  const Sheet sheet = mixed_sheet();
  const std::vector<DrawnPath> paths = many_points();
  OutputOptions options;
  options.dots_per_mm = 1.0;
  const Threads threads;
  RasterPlan bands{.most_pixels_at_once = 0.0, .pixels_per_band = 20'000.0};
  const std::string one = drawn(sheet, paths, options);
  const std::string one_in_bands = drawn(sheet, paths, options, bands);
  EXPECT_EQ(decoded_png(one_in_bands).rgb, decoded_png(one).rgb);
  for (const std::size_t count : {2U, 3U, 4U}) {
    EXPECT_TRUE(drawn(sheet, paths, options, {.workers = {&threads, count}}) == one) << count;
    bands.workers = {&threads, count};
    EXPECT_TRUE(drawn(sheet, paths, options, bands) == one_in_bands) << count;
  }
}

TEST(NativePng, OfALargePageHasTheSameBytesForAnyNumberOfWorkers) {
  Sheet sheet = mixed_sheet();
  OutputOptions options;
  options.dots_per_mm = 5.0;
  const std::vector<DrawnPath> mixtures = many_points();
  std::vector<DrawnPath> line = mixtures;
  std::erase_if(line, [](const DrawnPath& path) { return path.head.layer != 1; });
  const Threads threads;
  const auto expect_the_same = [&](const std::vector<DrawnPath>& paths, char pixels) {
    const std::string one = drawn(sheet, paths, options);
    EXPECT_EQ(format_of(one), std::string({8, pixels}));
    for (const std::size_t count : {2U, 4U}) {
      EXPECT_TRUE(drawn(sheet, paths, options, {.workers = {&threads, count}}) == one) << count;
    }
    const RasterPlan bands{.most_pixels_at_once = 0.0, .pixels_per_band = 700'000.0, .workers = {&threads, 2}};
    EXPECT_TRUE(decoded_png(drawn(sheet, paths, options, bands)).rgb == decoded_png(one).rgb);
  };
  expect_the_same(mixtures, rgb);
  expect_the_same(line, palette);
  sheet.page.paper = {255, 255, 255};
  sheet.pens[1].colour = {0, 0, 0};
  expect_the_same(line, grey);
}

TEST(RowShare, GivesEveryRowToOnePainter) {
  for (const int painters : {1, 2, 4, 8}) {
    for (int first = 0; first < 300; ++first) {
      int owners = 0;
      for (int k = 0; k < painters; ++k) {
        const output::raster::RowShare share{k, painters - 1};
        owners += share.has(first) ? 1 : 0;
        for (int end = first + 1; end < first + 300; end += 13) {
          bool has_one = false;
          for (int row = first; row < end; ++row) has_one = has_one || share.has(row);
          EXPECT_EQ(share.has_any(first, end), has_one) << k << ' ' << first << ' ' << end;
        }
      }
      EXPECT_EQ(owners, 1);
    }
  }
}

TEST(NativePng, InBandsKnowsItsColoursBeforehand) {
  const RasterPlan bands{.most_pixels_at_once = 0.0, .pixels_per_band = 4000.0};
  Sheet sheet = small_sheet();
  const std::vector<DrawnPath> line = {stroke({{1.0, 1.0}, {19.0, 9.0}})};
  EXPECT_EQ(format_of(drawn(sheet, line, ten_dots(), bands)), std::string({8, grey}));
  sheet.pens[0].colour = {200, 0, 0};
  EXPECT_EQ(format_of(drawn(sheet, line, ten_dots(), bands)), std::string({8, palette}));
  EXPECT_EQ(decoded_png(drawn(sheet, line, ten_dots(), bands)).rgb, decoded_png(drawn(sheet, line)).rgb);
  sheet.layers.push_back({.name = "two", .pen = 0});
  EXPECT_EQ(format_of(drawn(sheet, line, ten_dots(), bands)), std::string({8, rgb}));
}

TEST(NativePng, AsksForEachBandOnce) {
  Sheet sheet = small_sheet();
  StringSink bytes;
  const auto sink =
      output::open_png(bytes, sheet, ten_dots(), {.most_pixels_at_once = 0.0, .pixels_per_band = 200 * 40});
  double covered_mm = 0.0;
  do {
    const Box2 part = sink->wanted_part_mm();
    EXPECT_DOUBLE_EQ(part.low.y, covered_mm);
    covered_mm = part.high.y;
  } while (sink->wants_another_run());
  EXPECT_DOUBLE_EQ(covered_mm, 10.0);
  EXPECT_TRUE(sink->finish());
  EXPECT_EQ(decoded_png(bytes.text()).height, 100);
}

TEST(NativePng, OfATinyPageHasOnePixel) {
  Sheet sheet = small_sheet();
  sheet.page = {.width_mm = 0.01, .height_mm = 0.01};
  const DecodedPng one = decoded_png(drawn(sheet, {stroke({{-5.0, -5.0}, {5.0, 5.0}})}));
  EXPECT_EQ(one.width, 1);
  EXPECT_EQ(one.height, 1);
  EXPECT_EQ(one.red(0, 0), 0);
}

TEST(NativePng, RefusesPagesThatAreTooLarge) {
  Sheet sheet = small_sheet();
  OutputOptions options;
  options.dots_per_mm = 5000.0;
  EXPECT_TRUE(back_end().accepts(sheet, options));
  options.dots_per_mm = 5000.1;
  const Result<Done> result = back_end().accepts(sheet, options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.problems()[0].trouble, Trouble::limit);
  EXPECT_NE(result.problems()[0].message.find("100002 x 50001"), std::string::npos) << result.problems()[0].message;
  EXPECT_NE(result.problems()[0].message.find("--size"), std::string::npos);
}

TEST(NativePng, SaysHowMuchMemoryItNeeds) {
  Sheet sheet = small_sheet();
  OutputOptions options;
  options.dots_per_mm = 100.0;
  EXPECT_NEAR(back_end().memory_bytes(1e9, sheet, options), 8e6 + 14.0 * 2e6, 1e5);
  sheet.layers.push_back(sheet.layers.front());
  EXPECT_NEAR(back_end().memory_bytes(1e9, sheet, options), 8e6 + 18.0 * 2e6, 1e5) << "two layers";
  options.dots_per_mm = 1000.0;
  EXPECT_LE(back_end().memory_bytes(1e9, sheet, options), 64e6) << "in bands";
}

TEST(NativePng, KeepsAFailedWriteForTheEnd) {
  const std::vector<DrawnPath> paths = random_paths(9, 3, 30);
  OutputOptions options;
  options.dots_per_mm = 1.0;
  for (const RasterPlan& plan : {RasterPlan{}, RasterPlan{.most_pixels_at_once = 0.0, .pixels_per_band = 5000.0}}) {
    const Sheet sheet = mixed_sheet();
    const std::size_t size = drawn(sheet, paths, options, plan).size();
    for (const std::size_t room : {std::size_t{0}, std::size_t{40}, size / 2, size - 1}) {
      FailingSink full(room);
      const auto sink = output::open_png(full, sheet, options, plan);
      while (draw(paths, *sink) == Flow::go && sink->wants_another_run()) {
      }
      const Result<Done> finished = sink->finish();
      ASSERT_FALSE(finished) << room;
      EXPECT_EQ(finished.problems()[0].trouble, Trouble::output);
      EXPECT_NE(finished.problems()[0].message.find("No space left"), std::string::npos);
      EXPECT_EQ(full.writes_after_failure(), 0U);
    }
  }
}

}  // namespace
}  // namespace burin::test
