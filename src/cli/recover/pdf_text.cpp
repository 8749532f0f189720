#include <array>
#include <cstdint>

#include <cli/recover/pdf_object.hpp>
#include <cli/recover/utf8_text.hpp>

namespace burin::cli {

namespace {

/// PDFDocEncoding (ISO 32000-1, annex D.2) where it differs from Latin-1; 0: no character.
constexpr std::array<std::uint16_t, 8> from_0x18{0x02D8, 0x02C7, 0x02C6, 0x02D9, 0x02DD, 0x02DB, 0x02DA, 0x02DC};
constexpr std::array<std::uint16_t, 34> from_0x7f{
    0,      0x2022, 0x2020, 0x2021, 0x2026, 0x2014, 0x2013, 0x0192, 0x2044, 0x2039, 0x203A, 0x2212,
    0x2030, 0x201E, 0x201C, 0x201D, 0x2018, 0x2019, 0x201A, 0x2122, 0xFB01, 0xFB02, 0x0141, 0x0152,
    0x0160, 0x0178, 0x017D, 0x0131, 0x0142, 0x0153, 0x0161, 0x017E, 0,      0x20AC};

std::optional<std::string> utf8_of_doc_encoding(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    std::uint32_t code = static_cast<unsigned char>(c);
    if (code >= 0x18 && code < 0x18 + from_0x18.size()) code = from_0x18.at(code - 0x18);
    if (code >= 0x7F && code < 0x7F + from_0x7f.size()) code = from_0x7f.at(code - 0x7F);
    if (code == 0 || code == 0xAD) return std::nullopt;
    append_utf8(text, code);
  }
  return text;
}

std::optional<std::string> utf8_of_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t at) {
    const std::uint32_t first = static_cast<unsigned char>(bytes[at]);
    const std::uint32_t second = static_cast<unsigned char>(bytes[at + 1]);
    return big_endian ? first << 8U | second : second << 8U | first;
  };
  if (bytes.size() % 2 != 0) return std::nullopt;
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= 0xD800 && code < 0xE000) {
      const std::uint32_t low = code < 0xDC00 && at + 2 < bytes.size() ? unit(at + 2) : 0;
      if (low < 0xDC00 || low >= 0xE000) return std::nullopt;
      code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
      at += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace

std::optional<std::string> utf8_of_pdf_text(std::string_view bytes) {
  if (bytes.starts_with("\xFE\xFF")) return utf8_of_utf16(bytes.substr(2), true);
  if (bytes.starts_with("\xFF\xFE")) return utf8_of_utf16(bytes.substr(2), false);
  if (bytes.starts_with("\xEF\xBB\xBF")) return std::string(bytes.substr(3));
  return utf8_of_doc_encoding(bytes);
}

}  // namespace burin::cli
