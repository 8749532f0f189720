#include <cstdlib>

#include <gtest/gtest.h>

#include "drawing.hpp"

namespace burin::test {
namespace {

Flow draw_diagonal(PathSink& to) {
  return draw_line(to, {{1.0, 1.0}, {19.0, 9.0}});
}

/// What follows `key` up to `end`.
std::string between(const std::string& text, const std::string& key, const std::string& end) {
  const std::size_t from = text.find(key);
  if (from == std::string::npos) return "(not there)";
  const std::size_t begin = from + key.size();
  return text.substr(begin, text.find(end, begin) - begin);
}

std::string utf8(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(static_cast<std::uint8_t>(bits)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6U), byte(0x80 | (code & 0x3FU))};
  if (code < 0x10000) return {byte(0xE0 | code >> 12U), byte(0x80 | (code >> 6U & 0x3FU)), byte(0x80 | (code & 0x3FU))};
  return {byte(0xF0 | code >> 18U), byte(0x80 | (code >> 12U & 0x3FU)), byte(0x80 | (code >> 6U & 0x3FU)),
          byte(0x80 | (code & 0x3FU))};
}

/// The text of an entry of the document information: a plain string without escapes, or UTF-16 in hexadecimal.
std::string info(const std::string& pdf, const std::string& key) {
  const std::string plain = between(pdf, "/" + key + " (", ")");
  if (plain != "(not there)") return plain;
  const std::string hex = between(pdf, "/" + key + " <", ">");
  EXPECT_EQ(hex.substr(0, 4), "FEFF") << key << ": " << hex;
  std::string text;
  std::uint32_t high = 0;
  for (std::size_t i = 4; i + 4 <= hex.size(); i += 4) {
    const auto unit = static_cast<std::uint32_t>(std::strtoul(hex.substr(i, 4).c_str(), nullptr, 16));
    if (unit >= 0xD800 && unit < 0xDC00) {
      high = unit;
    } else {
      text += utf8(unit >= 0xDC00 && unit < 0xE000 ? 0x10000 + ((high - 0xD800) << 10U) + (unit - 0xDC00) : unit);
    }
  }
  return text;
}

TEST(Pdf, PageHasTheTrueSizeInPoints) {
  Sheet sheet = small_sheet();
  sheet.page = {.width_mm = 210.0, .height_mm = 297.0};
  EXPECT_NE(drawn("pdf", sheet, draw_diagonal).find("/MediaBox [ 0 0 595.275591 841.889764 ]"), std::string::npos);
}

TEST(Pdf, CarriesTheOriginCharacterForCharacter) {
  Sheet sheet = small_sheet();
  sheet.made_by = {.title = "Winter (card)",
                   .author = "Ren\xC3\xA9 \\ Co",
                   .summary = "A wreath",
                   .record = "burin = 1\r\n[knobs] # \xE2\x9D\x84 \xF0\x9F\x98\x80\n\tx = \"(a\\\\b)\" \n\n"};
  const std::string pdf = drawn("pdf", sheet, draw_diagonal);
  EXPECT_EQ(info(pdf, "Title"), sheet.made_by.title);
  EXPECT_EQ(info(pdf, "Author"), sheet.made_by.author);
  EXPECT_EQ(info(pdf, "Subject"), sheet.made_by.summary);
  EXPECT_EQ(info(pdf, "Keywords"), sheet.made_by.record);
  EXPECT_EQ(info(pdf, "Creator"), "burin");
}

TEST(Pdf, DatesAreConstants) {
  const std::string pdf = drawn("pdf", small_sheet(), draw_diagonal);
  EXPECT_EQ(info(pdf, "CreationDate"), "20000101000000Z");
  EXPECT_EQ(info(pdf, "ModDate"), "20000101000000Z");
}

TEST(Pdf, HasNoPictureInside) {
  Sheet sheet = small_sheet();
  sheet.layers[0].opacity = 0.5;
  const std::string pdf = drawn("pdf", sheet, draw_diagonal);
  EXPECT_EQ(pdf.find("/Image"), std::string::npos);
  EXPECT_NE(pdf.find("/ca 0.5"), std::string::npos);
}

TEST(Pdf, ShowsThePaperOnRequestOnly) {
  Sheet sheet = small_sheet();
  OutputOptions options;
  const std::string without = drawn("pdf", sheet, draw_diagonal, options);
  sheet.page.paper = {1, 2, 3};
  EXPECT_EQ(without, drawn("pdf", sheet, draw_diagonal, options));
  options.paper = true;
  EXPECT_NE(without, drawn("pdf", sheet, draw_diagonal, options));
}

TEST(Pdf, RefusesPagesThatViewersDoNotOpen) {
  Sheet sheet = small_sheet();
  sheet.page.height_mm = 5080.0;
  EXPECT_TRUE(cairo_back_end("pdf").accepts(sheet, {}).ok());
  sheet.page.height_mm = 5080.1;
  const Result<Done> result = cairo_back_end("pdf").accepts(sheet, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.problems()[0].trouble, Trouble::limit);
  EXPECT_NE(result.problems()[0].message.find("20 x 5080.1 mm"), std::string::npos) << result.problems()[0].message;
}

TEST(Pdf, RefusesInksThatItWouldLose) {
  Sheet sheet = small_sheet();
  sheet.pens[0].cmyk = Cmyk{0.0, 1.0, 1.0, 0.0};
  sheet.pens.push_back({.name = "gold", .colour = {180, 150, 80}, .spot = "Pantone 871 C"});
  const Result<Done> result = cairo_back_end("pdf").accepts(sheet, {});
  ASSERT_FALSE(result.ok());
  ASSERT_EQ(result.problems().size(), 2U);
  EXPECT_NE(result.problems()[0].message.find("pen 'ink' has 'cmyk'"), std::string::npos);
  EXPECT_NE(result.problems()[1].message.find("pen 'gold' has 'spot'"), std::string::npos);
  EXPECT_NE(result.problems()[1].message.find("--backend native"), std::string::npos);
  for (const char* format : {"png", "svg"}) EXPECT_TRUE(cairo_back_end(format).accepts(sheet, {}).ok()) << format;
}

TEST(Pdf, ToleranceIsHalfOfCairosUnit) {
  EXPECT_DOUBLE_EQ(cairo_back_end("pdf").tolerance_mm({}, {}), 25.4 / 72.0 / 512.0);
}

}  // namespace
}  // namespace burin::test
