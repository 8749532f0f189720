#include <map>
#include <zlib.h>

#include <gtest/gtest.h>

#include "drawing.hpp"

namespace burin::test {
namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes.at(at + i));
  return value;
}

struct Chunk {
  std::string type;
  std::string data;
};

/// The chunks of a PNG; each checksum is checked.
std::vector<Chunk> chunks(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::uint32_t size = big_endian(png, at);
    chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, size)});
    const auto* checked = reinterpret_cast<const Bytef*>(png.data() + at + 4);
    EXPECT_EQ(big_endian(png, at + 8 + size), crc32(0, checked, size + 4)) << chunks.back().type;
    at += size + 12;
  }
  return chunks;
}

/// The data of the chunks of one type.
std::vector<std::string> data_of(const std::string& png, std::string_view type) {
  std::vector<std::string> data;
  for (const Chunk& chunk : chunks(png)) {
    if (chunk.type == type) data.push_back(chunk.data);
  }
  return data;
}

Flow draw_diagonal(PathSink& to) {
  return draw_line(to, {{1.0, 1.0}, {19.0, 9.0}});
}

TEST(Png, HasThePagesSizeInWholePixelsAndItsResolution) {
  Sheet sheet = small_sheet();
  sheet.page.width_mm = 20.04;
  OutputOptions options;
  options.dots_per_mm = 300.0 / 25.4;
  const std::string png = drawn("png", sheet, draw_diagonal, options);
  const std::vector<std::string> header = data_of(png, "IHDR");
  ASSERT_EQ(header.size(), 1U);
  EXPECT_EQ(big_endian(header[0], 0), 237U);  // 236.69
  EXPECT_EQ(big_endian(header[0], 4), 118U);  // 118.11
  const std::vector<std::string> dots = data_of(png, "pHYs");
  ASSERT_EQ(dots.size(), 1U);
  EXPECT_EQ(big_endian(dots[0], 0), 11811U);
  EXPECT_EQ(big_endian(dots[0], 4), 11811U);
  EXPECT_EQ(dots[0][8], 1);  // a metre
}

TEST(Png, OfATinyPageHasOnePixel) {
  Sheet sheet = small_sheet();
  sheet.page = {.width_mm = 0.01, .height_mm = 0.01};
  const Pixels one = pixels(sheet, draw_diagonal);
  EXPECT_EQ(one.width, 1);
  EXPECT_EQ(one.height, 1);
}

TEST(Png, ShowsThePaperAndSaysThatItIsSrgb) {
  Sheet sheet = small_sheet();
  sheet.page.paper = {250, 240, 230};
  const std::string png = drawn("png", sheet, draw_diagonal);
  EXPECT_EQ(data_of(png, "sRGB"), std::vector<std::string>{std::string(1, '\0')});
  const Pixels picture = decoded(png);
  EXPECT_EQ(std::vector<std::uint8_t>(picture.rgb.begin(), picture.rgb.begin() + 3),
            (std::vector<std::uint8_t>{250, 240, 230}));
}

TEST(Png, IsGreyWhenEveryColourIs) {
  Sheet sheet = small_sheet();
  sheet.pens[0].colour = {90, 90, 90};
  sheet.page.paper = {240, 240, 240};
  const std::string grey = drawn("png", sheet, draw_diagonal);
  EXPECT_EQ(data_of(grey, "IHDR").at(0).substr(8, 2), std::string("\x08\x00", 2));
  sheet.pens.push_back({.name = "unused", .colour = {90, 90, 91}});
  const std::string rgb = drawn("png", sheet, draw_diagonal);
  EXPECT_EQ(data_of(rgb, "IHDR").at(0).substr(8, 2), std::string("\x08\x02", 2));
  EXPECT_EQ(decoded(grey).rgb, decoded(rgb).rgb);
}

TEST(Png, CarriesTheOriginAsText) {
  Sheet sheet = small_sheet();
  sheet.made_by = {.title = "Winter card",
                   .author = "Ren\xC3\xA9",
                   .summary = "Two lines\nof text",
                   .record = "title = \"\xE2\x9D\x84\"\n\tseed = 19\r\n"};
  const std::string png = drawn("png", sheet, draw_diagonal);
  const std::vector<std::string> latin1 = {std::string("Title\0Winter card", 17), std::string("Author\0Ren\xE9", 11),
                                           std::string("Description\0Two lines\nof text", 29),
                                           std::string("Software\0burin", 14)};
  EXPECT_EQ(data_of(png, "tEXt"), latin1);
  const std::vector<std::string> utf8 = {std::string("burin-origin\0\0\0\0\0", 17) + sheet.made_by.record};
  EXPECT_EQ(data_of(png, "iTXt"), utf8);
  EXPECT_TRUE(data_of(png, "tIME").empty());
}

TEST(Png, CarriesAnAsciiRecordAsPlainText) {
  Sheet sheet = small_sheet();
  sheet.made_by.record = "seed = 19\n";
  const std::string png = drawn("png", sheet, draw_diagonal);
  const std::vector<std::string> texts = {std::string("Software\0burin", 14),
                                          std::string("burin-origin\0", 13) + sheet.made_by.record};
  EXPECT_EQ(data_of(png, "tEXt"), texts);
}

TEST(Png, ReplacesWhatNoTextCanHold) {
  Sheet sheet = small_sheet();
  sheet.made_by.title = std::string("a\xFF\0b\x1B", 5);
  const std::string png = drawn("png", sheet, draw_diagonal);
  const std::vector<std::string> utf8 = {std::string("Title\0\0\0\0\0", 10) +
                                         "a\xEF\xBF\xBD\xEF\xBF\xBD"
                                         "b\xEF\xBF\xBD"};
  EXPECT_EQ(data_of(png, "iTXt"), utf8);
}

TEST(Png, RefusesMorePixelsThanCairoCanDraw) {
  Sheet sheet = small_sheet();
  OutputOptions options;
  options.dots_per_mm = 32767.0 / 20.0;
  EXPECT_TRUE(cairo_back_end("png").accepts(sheet, options).ok());
  options.dots_per_mm = 1638.4;
  const Result<Done> result = cairo_back_end("png").accepts(sheet, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.problems()[0].trouble, Trouble::limit);
  const std::string message = result.problems()[0].message;
  EXPECT_NE(message.find("32768 x 16384"), std::string::npos) << message;
  EXPECT_NE(message.find("--dpi"), std::string::npos) << message;
  EXPECT_NE(message.find("--size"), std::string::npos) << message;
  options.dots_per_mm = 1e300;
  EXPECT_FALSE(cairo_back_end("png").accepts(sheet, options).ok());
}

TEST(Png, ToleratesATwelfthOfAPixel) {
  EXPECT_DOUBLE_EQ(cairo_back_end("png").tolerance_mm({}, ten_dots()), 0.008);
}

}  // namespace
}  // namespace burin::test
