#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <zlib.h>

#include <fmt/format.h>

/// Small files made by hand, as other programs might write them, with a record somewhere inside.
namespace burin::test {

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            static_cast<uLong>(bytes.size()), 9);
  packed.resize(size);
  return packed;
}

inline std::string big_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

// PNG

inline const std::string png_signature = "\x89PNG\r\n\x1a\n";

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(data.size(), 4) + body + big_endian(crc, 4);
}

/// A PNG, as far as its chunks go, with one more.
inline std::string png_with(const std::string& chunk) {
  return png_signature + png_chunk("IHDR", std::string(13, '\1')) + png_chunk("tEXt", std::string("Title\0a", 7)) +
         chunk + png_chunk("IDAT", "not looked at") + png_chunk("IEND", "");
}

// PDF

inline std::string utf16_hexadecimal(std::u16string_view text) {
  std::string digits = "<FEFF";
  for (const char16_t unit : text) digits += fmt::format("{:04x}", static_cast<unsigned>(unit));
  return digits + '>';
}

/// A PDF with a cross-reference table; `info` is object 1. Offsets begin behind `before`, which some programs put
/// there.
inline std::string pdf_with_info(const std::string& info, const std::string& before = {}) {
  const std::string head = "%PDF-1.5\n% comment\n";
  const std::string objects = head + "1 0 obj\n" + info + "\nendobj\n";
  return before + objects +
         fmt::format(
             "xref\n0 2\n0000000000 65535 f \n{:010} 00000 n \ntrailer\n<< /Size 2 /Info 1 0 R >>\nstartxref\n"
             "{}\n%%EOF\n",
             head.size(), objects.size());
}

/// The same with the newer structures: object 1 in an object stream, the table in a stream with PNG's predictor.
inline std::string pdf_with_info_in_streams(const std::string& info) {
  std::string pdf = "%PDF-1.5\n";
  const std::size_t stream_at = pdf.size();
  const std::string packed = deflated("7 0 1 9 " + std::string("(seven)  ") + info);
  pdf += fmt::format("2 0 obj\n<< /Type /ObjStm /N 2 /First 8 /Filter /FlateDecode /Length {} >>\nstream\n",
                     packed.size());
  pdf += packed + "\nendstream\nendobj\n";
  const std::size_t table_at = pdf.size();
  const std::array<std::string, 4> entries{big_endian(0, 1) + big_endian(0, 3) + big_endian(255, 1),
                                           big_endian(2, 1) + big_endian(2, 3) + big_endian(1, 1),
                                           big_endian(1, 1) + big_endian(stream_at, 3) + big_endian(0, 1),
                                           big_endian(1, 1) + big_endian(table_at, 3) + big_endian(0, 1)};
  std::string rows;
  std::string above(5, '\0');
  for (const std::string& entry : entries) {
    rows += '\2';
    for (std::size_t i = 0; i < entry.size(); ++i) rows += static_cast<char>(entry[i] - above[i]);
    above = entry;
  }
  const std::string table = deflated(rows);
  pdf += fmt::format(
      "3 0 obj\n<< /Type /XRef /Size 4 /W [1 3 1] /Filter [/FlateDecode] /DecodeParms [<< /Predictor 12 /Columns 5 >>] "
      "/Info 1 0 R /Length {} >>\nstream\r\n",
      table.size());
  return pdf + table + fmt::format("\nendstream\nendobj\nstartxref\n{}\n%%EOF\n", table_at);
}

}  // namespace burin::test
